#pragma once

#include <cstdint>

#include "viewer/renderer.h"

namespace scatter::viewer {

/// Of a level: the coarsest red, the finest green, those between from orange to yellow.
[[nodiscard]] Color levelColor(int level, int levelCount);

/// Of the number-th thing: neighbours are far apart.
[[nodiscard]] Color distinctColor(std::uint64_t number);

/// So little of a step's work is not worth a colour of its own, units.
inline constexpr float kLeastCost = 0.5F;
/// And from so much on it has the last colour.
inline constexpr float kMostCost = 200.0F;

/// Of what something took of a step, on a logarithmic scale from kLeastCost to kMostCost: blue, green,
/// yellow, red, white. It does not depend on what others took, so that worlds can be compared.
[[nodiscard]] Color costColor(float units);

/// Of a share of the largest gap: from blue, where there is none, over green and yellow to red.
[[nodiscard]] Color gapColor(float share);

inline constexpr Color kContactColor{1.0F, 0.85F, 0.2F, 1.0F};
inline constexpr Color kCreditColor{0.95F, 0.35F, 0.9F, 1.0F};
inline constexpr Color kBoundsColor{0.45F, 0.55F, 0.65F, 1.0F};
inline constexpr Color kVelocityColor{0.4F, 0.85F, 1.0F, 1.0F};
inline constexpr Color kSpringColor{0.98F, 0.98F, 0.85F, 1.0F};
inline constexpr Color kPairColor{0.35F, 0.4F, 0.5F, 1.0F};
inline constexpr Color kRequestColor{1.0F, 0.65F, 0.1F, 1.0F};
inline constexpr Color kRetractedColor{0.55F, 0.6F, 0.9F, 1.0F};

}  // namespace scatter::viewer
