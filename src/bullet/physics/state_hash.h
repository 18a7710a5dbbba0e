#pragma once

#include <scatter/world/state_bits.h>

#include <cstdint>

#include "bullet/physics/body.h"

namespace scatter {

/// A 64-bit hash of states, fed body by body. Like FNV-1a, but by words; each step can be undone, so two
/// runs that differ in one word never agree.
class StateHash {
 public:
  void add(const BulletBody& body);
  [[nodiscard]] std::uint64_t value() const { return hash_; }

 private:
  void add(std::uint32_t word);

  std::uint64_t hash_ = 0xcbf29ce484222325U;
};

/// The same words, but for id and level.
[[nodiscard]] StateBits stateBitsOf(const BulletBody& body);

}  // namespace scatter
