#pragma once

#include <scatter/levels/convex_part.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <random>
#include <utility>
#include <vector>

namespace scatter::testing {

inline ConvexPart box(const Vec3& halfExtents, const Vec3& position = Vec3(0.0F),
                      const Quat& rotation = kNoRotation) {
  return {Box{halfExtents}, {position, rotation}};
}

inline ConvexPart sphere(float radius, const Vec3& position = Vec3(0.0F)) {
  return {Sphere{radius}, {position, kNoRotation}};
}

inline ConvexPart capsule(float radius, float halfHeight, const Vec3& position = Vec3(0.0F)) {
  return {Capsule{radius, halfHeight}, {position, kNoRotation}};
}

inline ConvexPart cylinder(float radius, float halfHeight, const Vec3& position = Vec3(0.0F)) {
  return {Cylinder{radius, halfHeight}, {position, kNoRotation}};
}

inline ConvexPart hull(std::vector<Vec3> vertices, const Vec3& position = Vec3(0.0F)) {
  return {ConvexHull{std::move(vertices)}, {position, kNoRotation}};
}

inline std::vector<Vec3> boxCorners(const Vec3& halfExtents) {
  std::vector<Vec3> corners;
  for (const float x : {-1.0F, 1.0F}) {
    for (const float y : {-1.0F, 1.0F}) {
      for (const float z : {-1.0F, 1.0F}) corners.push_back(Vec3(x, y, z) * halfExtents);
    }
  }
  return corners;
}

inline ConvexPart boxHull(const Vec3& halfExtents, const Vec3& position = Vec3(0.0F)) {
  return hull(boxCorners(halfExtents), position);
}

/// The same numbers with every standard library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  float uniform(float low, float high) {
    const double unit = static_cast<double>(engine_() >> 11U) * 0x1.0p-53;
    return low + (high - low) * static_cast<float>(unit);
  }
  Vec3 inBox(const Vec3& halfExtents) {
    const float x = uniform(-1.0F, 1.0F);
    const float y = uniform(-1.0F, 1.0F);
    const float z = uniform(-1.0F, 1.0F);
    return Vec3(x, y, z) * halfExtents;
  }
  Vec3 direction() {
    for (;;) {
      const Vec3 v = inBox(Vec3(1.0F));
      const float length = glm::length(v);
      if (length > 0.1F && length <= 1.0F) return v / length;
    }
  }
  Quat rotation() { return glm::angleAxis(uniform(0.0F, 6.2F), direction()); }

  /// Points on an ellipsoid: all of them are corners of their hull.
  ConvexPart ellipsoidHull(int corners, const Vec3& radii, const Vec3& position) {
    std::vector<Vec3> vertices;
    vertices.reserve(static_cast<std::size_t>(corners));
    for (int i = 0; i < corners; ++i) vertices.push_back(direction() * radii);
    return {ConvexHull{std::move(vertices)}, {position, rotation()}};
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace scatter::testing
