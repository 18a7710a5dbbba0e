#pragma once

#include <scatter/levels/convex_part.h>
#include <scatter/math.h>

#include <array>

namespace scatter {

/// A share of a hexahedron along its three edges, each from 0 to 1.
struct Share {
  Vec3 from{0.0F};
  Vec3 to{1.0F};
};

/// A convex solid with six flat faces, whose corner i lies at the ends of its edges that the bits of i say.
/// Made to be cut into smaller ones: every share of it lies inside, and shares that are apart do not overlap.
class Hexahedron {
 public:
  explicit Hexahedron(const std::array<Vec3, 8>& corners) : corners_(corners) {}

  [[nodiscard]] static Hexahedron box(const Vec3& low, const Vec3& high);

  /// The point at these shares along the edges.
  [[nodiscard]] Vec3 at(const Vec3& share) const;

  /// Flat-faced like the whole if opposite faces are parallel, or if all edges of one direction meet in a
  /// point.
  [[nodiscard]] Hexahedron cut(const Share& share) const;

  /// Smaller by at least `inset` metres at every face, for corners of no less than 50 degrees.
  [[nodiscard]] Hexahedron shrunk(float inset) const;

  [[nodiscard]] ConvexPart part() const;     ///< A hull.
  [[nodiscard]] ConvexPart boxPart() const;  ///< For what was cut from a box.

 private:
  [[nodiscard]] float shortestEdge(int axis) const;

  std::array<Vec3, 8> corners_;
};

}  // namespace scatter
