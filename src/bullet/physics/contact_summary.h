#pragma once

#include <cstdint>

class btDispatcher;

namespace scatter {

/// What a dispatcher's manifolds hold.
struct ContactSummary {
  std::uint32_t manifolds = 0;
  std::uint32_t contacts = 0;
  float deepest = 0.0F;  ///< Metres; of contacts that push, not of sensors.
};

[[nodiscard]] ContactSummary summarizeContacts(btDispatcher& dispatcher);

}  // namespace scatter
