#include "viewer/shape_mesh.h"

#include <gtest/gtest.h>

#include <memory>

namespace scatter::test {
namespace {

TEST(ShapeMesh, AHeightFieldLooksLikeItsTriangles) {
  const HeightField field{.columns = 3, .rows = 3, .heights = {0, 1, 0, 2, 0, 1, 0, 3, 0}};
  const viewer::MeshData seen = viewer::meshOf(std::make_shared<const HeightField>(field));
  const viewer::MeshData same = viewer::meshOf(std::make_shared<const TriangleMesh>(trianglesOf(field)));
  EXPECT_EQ(seen.indices.size(), 3U * 8U);
  EXPECT_EQ(seen.positions, same.positions);
  EXPECT_EQ(seen.indices, same.indices);
  EXPECT_TRUE(seen.twoSided);
}

}  // namespace
}  // namespace scatter::test
