#pragma once

#include <scatter/math.h>

#include <glm/geometric.hpp>

namespace scatter {

/// A rigid motion with its rotation as a matrix, for inner loops; unlike Transform it is what engines hand
/// over each step, rounding included.
struct Frame {
  Vec3 row[3]{{1.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}, {0.0F, 0.0F, 1.0F}};  ///< Of the rotation.
  Vec3 origin{0.0F};

  [[nodiscard]] Vec3 rotate(const Vec3& v) const {
    return {glm::dot(row[0], v), glm::dot(row[1], v), glm::dot(row[2], v)};
  }
  [[nodiscard]] Vec3 rotateBack(const Vec3& v) const { return row[0] * v.x + row[1] * v.y + row[2] * v.z; }
  [[nodiscard]] Vec3 operator()(const Vec3& local) const { return rotate(local) + origin; }
  [[nodiscard]] Vec3 toLocal(const Vec3& point) const { return rotateBack(point - origin); }

  [[nodiscard]] bool operator==(const Frame&) const = default;
};

/// `b` in the frame of `a`, both given in the same frame.
[[nodiscard]] Frame relativeFrame(const Frame& a, const Frame& b);

/// How far something has moved: upper bounds.
struct Displacement {
  float length = 0.0F;  ///< Of any of its points, metres.
  float turn = 0.0F;    ///< Twice the sine of half the angle.
};

/// Of a ball that is fixed to the moving frame: |change of the centre| + |change of the rotation| · radius,
/// rounding included. The operator norm of a difference of two rotations is its Frobenius norm over the
/// square root of two.
[[nodiscard]] Displacement displacementBound(const Frame& before, const Frame& after, const Vec3& center,
                                             float radius);

/// Displacement::turn of it.
[[nodiscard]] float turnBound(const Frame& before, const Frame& after);

}  // namespace scatter
