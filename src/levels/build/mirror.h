#pragma once

#include <scatter/levels/convex_part.h>

#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace scatter::levels {

/// The plane through zero across a coordinate axis, of a work mesh. Nothing is rounded by it.
struct Mirror {
  int axis = 0;

  [[nodiscard]] glm::dvec3 operator()(glm::dvec3 point) const {
    point[axis] = 0.0 - point[axis];
    return point;
  }

  /// The nearest point on the plane.
  [[nodiscard]] glm::dvec3 flattened(glm::dvec3 point) const {
    point[axis] = 0.0;
    return point;
  }
};

/// The mirror image of a part whose frame is the model's, with the plane through `origin`.
[[nodiscard]] ConvexPart mirrored(const ConvexPart& part, const Mirror& mirror, const Vec3& origin);

/// Whether the image is exactly where it should be, which single precision may not allow far from zero.
[[nodiscard]] bool isMirroredExactly(const ConvexPart& part, const Mirror& mirror, const Vec3& origin);

/// Whether a box, sphere, capsule or cylinder is its own mirror image, exactly.
[[nodiscard]] bool isOwnImage(const ConvexPart& part, const Mirror& mirror, const Vec3& origin);

/// The points and their images, each once; what is within `epsilon` of the plane is moved onto it.
[[nodiscard]] std::vector<glm::dvec3> withImages(std::span<const glm::dvec3> points, const Mirror& mirror,
                                                 double epsilon = 0.0);

}  // namespace scatter::levels
