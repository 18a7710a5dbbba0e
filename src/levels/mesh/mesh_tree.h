#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "levels/mesh/work_mesh.h"
#include "levels/polytope.h"

namespace scatter::levels {

/// Triangles in a tree of boxes, for distances and winding numbers.
class MeshTree {
 public:
  /// `mesh` has triangles.
  explicit MeshTree(const WorkMesh& mesh);

  /// The distance of a point from the nearest triangle, or `limit` if that is nearer.
  [[nodiscard]] double distance(const glm::dvec3& point,
                                double limit = std::numeric_limits<double>::infinity()) const;

  /// Whether a triangle is nearer to the point than `reach`.
  [[nodiscard]] bool isWithin(const glm::dvec3& point, double reach) const;

  /// How often the triangles wind around the point: 1 inside a closed mesh, 0 outside, in between near
  /// holes. Distant triangles are taken together (Barill et al., Fast Winding Numbers, 2018).
  [[nodiscard]] double winding(const glm::dvec3& point) const;

 private:
  /// As large as a cache line; its children are beside each other.
  struct alignas(64) Node {
    DoubleBounds bounds;
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::uint32_t left = 0;  ///< The right one comes behind it; 0 in a leaf.
  };

  /// Of a node's triangles, seen from afar.
  struct Sum {
    glm::dvec3 area{0.0};    ///< Of area vectors.
    glm::dvec3 center{0.0};  ///< Of area.
    double radius = 0.0;     ///< Around `center`, holds the bounds.
  };

  class Visits;

  using Corners = std::array<glm::dvec3, 3>;

  void build(std::uint32_t index, std::size_t first, std::size_t last);
  void summarise(std::uint32_t index);
  [[nodiscard]] double leafDistance(const Node& leaf, const glm::dvec3& point, double best) const;

  std::vector<Corners> corners_;
  std::vector<Node> nodes_;
  std::vector<Sum> sums_;  ///< Of each node.
};

}  // namespace scatter::levels
