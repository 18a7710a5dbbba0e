#include "viewer/hand_lines.h"

#include <scatter/lab/hands.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "viewer/palette.h"

namespace scatter::viewer {
namespace {

constexpr int kTurns = 10;
constexpr int kPointsOfTurn = 8;
constexpr float kSlenderness = 0.03F;  // radius by length: seen from where all of it is in the picture

Vec3 across(const Vec3& way) {
  const Vec3 other = std::abs(way.y) < 0.9F ? Vec3(0.0F, 1.0F, 0.0F) : Vec3(1.0F, 0.0F, 0.0F);
  return glm::normalize(glm::cross(way, other));
}

}  // namespace

void addSpring(const Hands& hands, std::vector<Line>& lines) {
  if (!hands.dragged()) return;
  const Vec3 from = hands.grip();
  const Vec3 between = hands.dragTarget() - from;
  const float length = glm::length(between);
  if (!(length > 1e-4F)) return;
  const Vec3 way = between / length;
  const Vec3 right = across(way);
  const Vec3 up = glm::cross(way, right);
  const float radius = kSlenderness * length;
  constexpr int kPoints = kTurns * kPointsOfTurn;
  Vec3 last = from;
  for (int i = 1; i <= kPoints; ++i) {
    const float share = static_cast<float>(i) / static_cast<float>(kPoints);
    const float angle = 2.0F * std::numbers::pi_v<float> * static_cast<float>(kTurns) * share;
    // Its ends lie on the line between what it joins.
    const float reach = radius * std::min({1.0F, 8.0F * share, 8.0F * (1.0F - share)});
    const Vec3 next = from + share * between + reach * (std::cos(angle) * right + std::sin(angle) * up);
    lines.push_back({last, next, kSpringColor});
    last = next;
  }
}

}  // namespace scatter::viewer
