#pragma once

#include "pairs/manifolds.h"

namespace scatter::pairs {

/// Two bodies touch if they are this near, metres.
inline constexpr float kTouching = 0.01F;

/// A switch may make a penetration this much deeper by rounding, metres.
inline constexpr float kTolerance = 0.002F;

/// Adds to the distances of a manifold's points. If it `eases` them, a distance that is below zero still is
/// no error to be corrected.
void addCredit(void* manifold, float credit, Manifolds& engine, bool eases);

/// Ends the ease of a manifold's points. One that is still deep keeps its ease until it is found anew: it may
/// be older than where the parts are now.
void endCredit(void* manifold, Manifolds& engine);

/// How deep the contacts of a manifold press the bodies apart where the bodies are now, metres.
[[nodiscard]] float pressNow(const void* manifold, const Manifolds& engine);

}  // namespace scatter::pairs
