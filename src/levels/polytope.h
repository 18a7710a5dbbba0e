#pragma once

#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <vector>

namespace scatter::levels {

/// The points with normal · x <= offset; the normal has unit length.
struct HalfSpace {
  glm::dvec3 normal{0.0, 1.0, 0.0};
  double offset = 0.0;

  /// Positive outside.
  [[nodiscard]] double signedDistance(const glm::dvec3& point) const {
    return glm::dot(normal, point) - offset;
  }
  [[nodiscard]] HalfSpace flipped() const { return {-normal, -offset}; }
  [[nodiscard]] HalfSpace movedOut(double distance) const { return {normal, offset + distance}; }
};

/// An axis-aligned box; holds nothing until a point is added.
struct DoubleBounds {
  glm::dvec3 min{std::numeric_limits<double>::infinity()};
  glm::dvec3 max{-std::numeric_limits<double>::infinity()};

  void add(const glm::dvec3& point);
  [[nodiscard]] bool overlaps(const DoubleBounds& other, double margin) const;
};

/// Of a homogeneous solid.
struct SolidMoments {
  double volume = 0.0;
  glm::dvec3 center{0.0};   ///< Centre of mass.
  glm::dmat3 inertia{0.0};  ///< Per unit of mass, about the centre of mass.
};

/// A bounded convex polytope: vertices, and faces as loops of vertices, counter-clockwise from outside.
/// Faces need not share vertices exactly: nothing here follows edges from face to face, so that
/// rounding cannot break it.
class Polytope {
 public:
  struct Face {
    HalfSpace plane;
    std::uint32_t first = 0;  ///< Into the list of all loops.
    std::uint32_t count = 0;
  };

  Polytope() = default;

  /// The box center ± axes · halfExtents.
  static Polytope box(const glm::dvec3& center, const glm::dmat3& axes, const glm::dvec3& halfExtents);

  [[nodiscard]] bool isEmpty() const { return faces_.size() < 4; }
  [[nodiscard]] const std::vector<glm::dvec3>& vertices() const { return vertices_; }
  [[nodiscard]] const std::vector<Face>& faces() const { return faces_; }

  /// The vertices of a face, as indices.
  [[nodiscard]] std::span<const std::uint32_t> loop(const Face& face) const;

  [[nodiscard]] DoubleBounds bounds() const;

  /// The part inside `halfSpace`. Vertices within `epsilon` of its plane count as lying on it.
  [[nodiscard]] Polytope clipped(const HalfSpace& halfSpace, double epsilon) const;

  /// By tetrahedra from a point within to the triangles of the faces.
  [[nodiscard]] SolidMoments moments() const;

  /// Euclidean distance of a point, 0 inside.
  [[nodiscard]] double distance(const glm::dvec3& point) const;

  std::uint32_t addVertex(const glm::dvec3& vertex);

  /// Adds the convex face that the given vertices span in `plane`; they may come in any order, and
  /// those that are no corners of it are left out. Adds nothing if they span no area.
  void addFace(const HalfSpace& plane, std::vector<std::uint32_t> members);

 private:
  void addOrderedFace(const HalfSpace& plane, std::span<const std::uint32_t> loop);
  void dropUnusedVertices();

  std::vector<glm::dvec3> vertices_;
  std::vector<Face> faces_;
  std::vector<std::uint32_t> loops_;
};

}  // namespace scatter::levels
