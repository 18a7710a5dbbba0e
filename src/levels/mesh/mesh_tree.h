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

  /// How often the triangles wind around the point: 1 inside a closed mesh, 0 outside, in between near
  /// holes. Distant triangles are taken together (Barill et al., Fast Winding Numbers, 2018).
  [[nodiscard]] double winding(const glm::dvec3& point) const;

 private:
  struct Node {
    DoubleBounds bounds;
    glm::dvec3 area{0.0};    ///< Sum of area vectors.
    glm::dvec3 center{0.0};  ///< Of area.
    double radius = 0.0;     ///< Around `center`, holds `bounds`.
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::uint32_t left = 0;  ///< 0 in a leaf.
    std::uint32_t right = 0;
  };
  using Corners = std::array<glm::dvec3, 3>;

  std::uint32_t build(std::size_t first, std::size_t last);
  void summarise(Node& node) const;

  std::vector<Corners> corners_;
  std::vector<Node> nodes_;
};

}  // namespace scatter::levels
