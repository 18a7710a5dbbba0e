#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace scatter {

/// Lengths are metres, masses kilograms, times seconds, angles radians. Axes are right-handed.
using Vec3 = glm::vec3;
using Mat3 = glm::mat3;
using Quat = glm::quat;  ///< Components (w, x, y, z); always a unit quaternion in this library.

inline constexpr Quat kNoRotation{1.0F, 0.0F, 0.0F, 0.0F};

/// A rigid motion: rotate, then translate.
struct Transform {
  Vec3 position{0.0F};
  Quat rotation = kNoRotation;

  /// The point `local`, given in this frame, in the parent frame.
  [[nodiscard]] Vec3 operator()(const Vec3& local) const { return position + rotation * local; }

  /// `child`, given in this frame, in the parent frame.
  [[nodiscard]] Transform operator*(const Transform& child) const {
    return {(*this)(child.position), rotation * child.rotation};
  }

  [[nodiscard]] Transform inverse() const {
    const Quat back = glm::conjugate(rotation);
    return {back * -position, back};
  }
};

/// An axis-aligned box given by its corners.
struct Bounds {
  Vec3 min{0.0F};
  Vec3 max{0.0F};
};

}  // namespace scatter
