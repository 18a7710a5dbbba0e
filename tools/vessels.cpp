#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/vec3.hpp>
#include <utility>

#include "prop.h"

namespace scatter::tools {
namespace {

/// What the radius of a polygon around a circle is to that of the circle.
double circumscribed(int corners) {
  return 1.0 / std::cos(glm::pi<double>() / corners);
}

/// The corners of a quarter of a polygon of twelve, between its inner and outer radius.
Ring quarter(double y, double inner, double outer, double from) {
  const double step = glm::pi<double>() / 6.0;
  Ring ring;
  for (int i = 0; i <= 3; ++i) {
    ring.emplace_back(outer * std::cos(from + i * step), y, outer * std::sin(from + i * step));
  }
  for (const int i : {3, 0}) {
    ring.emplace_back(inner * std::cos(from + i * step), y, inner * std::sin(from + i * step));
  }
  return ring;
}

constexpr int kHandleSegments = 6;

/// The square section of a half ring that goes from wall to wall.
Ring handleSection(int i) {
  constexpr double kInside = 0.18;
  constexpr double kOutside = 0.24;
  constexpr double kHalfWidth = 0.03;
  const double angle = glm::pi<double>() * (static_cast<double>(i) / kHandleSegments - 0.5);
  Ring ring;
  for (const auto& [radius, z] : {std::pair(kInside, -kHalfWidth), std::pair(kOutside, -kHalfWidth),
                                  std::pair(kOutside, kHalfWidth), std::pair(kInside, kHalfWidth)}) {
    ring.emplace_back(0.28 + radius * std::cos(angle), 0.37 + radius * std::sin(angle), z);
  }
  return ring;
}

}  // namespace

Prop makeBarrel() {
  Prop barrel("barrel", 40.0F);
  constexpr int kStaves = 10;
  constexpr double kWall = 0.035;
  struct Hoop {
    double y, radius;
  };
  const Hoop hoops[]{{0.01, 0.25}, {0.22, 0.31}, {0.45, 0.33}, {0.68, 0.31}, {0.89, 0.25}};
  for (int layer = 0; layer < 4; ++layer) {
    const Hoop& low = hoops[layer];
    const Hoop& high = hoops[layer + 1];
    barrel.beginGroup();
    for (int stave = 0; stave < kStaves; ++stave) {
      const double turn = 2.0 * glm::pi<double>() / kStaves;
      barrel.addPanel({low.y, high.y, low.radius - kWall, low.radius, high.radius - kWall, high.radius,
                       turn * stave, turn * (stave + 1)});
    }
    const double wide = circumscribed(8) * 1.001;
    barrel.addMiddleHull(polygon(8, low.radius * wide, low.y), polygon(8, high.radius * wide, high.y));
    if (layer == 0) barrel.addFrustum(polygon(10, 0.20, 0.03), polygon(10, 0.20, 0.06));
    if (layer == 3) barrel.addFrustum(polygon(10, 0.20, 0.84), polygon(10, 0.20, 0.87));
  }
  return barrel;
}

Prop makeMug() {
  Prop mug("mug", 12.0F);
  constexpr int kSides = 12;
  constexpr double kOuter = 0.30;
  constexpr double kInner = 0.24;
  constexpr double kLow = 0.01;
  constexpr double kRim = 0.70;
  constexpr double kTurn = 2.0 * glm::pi<double>() / kSides;
  mug.beginGroup();
  for (int i = 0; i < kSides; ++i) {
    mug.addPanel({kLow, kRim, kInner, kOuter, kInner, kOuter, kTurn * i, kTurn * (i + 1)});
  }
  for (int i = 0; i < kSides; i += 3) {
    mug.addMiddleHull(quarter(kLow, kInner, kOuter, kTurn * i), quarter(kRim, kInner, kOuter, kTurn * i));
  }
  mug.beginGroup();
  mug.addFrustum(polygon(kSides, kInner, 0.03), polygon(kSides, kInner, 0.10));
  const double wide = kInner * circumscribed(8) * 1.001;
  mug.addMiddleHull(polygon(8, wide, 0.03), polygon(8, wide, 0.10));

  mug.beginGroup();
  for (int i = 0; i < kHandleSegments; ++i) mug.addFrustum(handleSection(i), handleSection(i + 1));
  return mug;
}

}  // namespace scatter::tools
