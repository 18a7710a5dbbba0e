#pragma once

#include <array>
#include <cstdint>

namespace scatter {

/// The exact bits of a body's state as its engine keeps it, to find out whether two states are the same. Of
/// floats in an engine of single precision; an engine that keeps an orientation otherwise than as a matrix
/// leaves what it does not need at zero.
struct StateBits {
  std::array<std::uint32_t, 3> position{};
  std::array<std::uint32_t, 9> orientation{};
  std::array<std::uint32_t, 3> linearVelocity{};
  std::array<std::uint32_t, 3> angularVelocity{};

  bool operator==(const StateBits&) const = default;
};

}  // namespace scatter
