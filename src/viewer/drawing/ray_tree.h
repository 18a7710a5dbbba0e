#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "viewer/renderer.h"

namespace scatter::viewer {

/// Triangles in a tree of boxes, to ask what a ray hits.
class RayTree {
 public:
  explicit RayTree(const MeshData& mesh);

  /// The distance of the nearest hit along a unit direction, or `limit` if there is none before.
  [[nodiscard]] float nearestHit(const Vec3& origin, const Vec3& direction, float limit) const;

 private:
  struct Triangle {
    Vec3 corner{0.0F};
    Vec3 edge1{0.0F};
    Vec3 edge2{0.0F};
  };
  struct Node {
    Bounds bounds{};
    std::uint32_t first = 0;
    std::uint32_t count = 0;  ///< 0 in a node with children.
    std::uint32_t left = 0;
    std::uint32_t right = 0;
  };

  std::uint32_t build(std::uint32_t first, std::uint32_t last);

  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
};

}  // namespace scatter::viewer
