#include "viewer/mesh_refinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "viewer/shape_mesh.h"

namespace scatter::viewer {
namespace {

struct Sizes {
  float longest = 0.0F;
  float area = 0.0F;
};

Sizes sizesOf(const MeshData& mesh) {
  Sizes sizes;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Vec3& a = mesh.positions[mesh.indices[i]];
    const Vec3& b = mesh.positions[mesh.indices[i + 1]];
    const Vec3& c = mesh.positions[mesh.indices[i + 2]];
    sizes.longest = std::max({sizes.longest, glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
    sizes.area += 0.5F * glm::length(glm::cross(b - a, c - a));
  }
  return sizes;
}

TEST(MeshRefinement, CutsEdgesAndKeepsTheSurface) {
  const MeshData box = unitBox();
  const MeshData fine = refined(box, 0.3F, 100'000);
  EXPECT_LE(sizesOf(fine).longest, 0.3F);
  EXPECT_NEAR(sizesOf(fine).area, 24.0F, 1e-3F);
  ASSERT_EQ(fine.normals.size(), fine.positions.size());
  for (const Vec3& normal : fine.normals) EXPECT_NEAR(glm::length(normal), 1.0F, 1e-5F);
  // Both triangles of an edge share its new vertex: of a side of n x n squares less than 2 (n + 1)^2 remain.
  EXPECT_LT(fine.positions.size(), fine.indices.size() / 3);
}

TEST(MeshRefinement, StopsAtSoManyTriangles) {
  EXPECT_LE(refined(unitBox(), 0.001F, 500).indices.size() / 3, 501U);
  EXPECT_EQ(refined(unitBox(), 10.0F, 500).indices.size(), unitBox().indices.size());
}

}  // namespace
}  // namespace scatter::viewer
