#pragma once

#include <cstdint>

namespace scatter::io {

/// The type of an accessor's numbers, as glTF names it.
enum class Component : std::uint16_t {
  kByte = 5120,
  kUnsignedByte = 5121,
  kShort = 5122,
  kUnsignedShort = 5123,
  kUnsignedInt = 5125,
  kFloat = 5126
};

}  // namespace scatter::io
