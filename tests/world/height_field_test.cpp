#include <gmock/gmock.h>
#include <scatter/world/shape.h>

#include <glm/geometric.hpp>

namespace scatter {
namespace {

HeightField twoCells() {
  return {.columns = 3, .rows = 2, .spacingX = 2.0F, .spacingZ = 5.0F, .heights = {1, 2, 3, 4, 5, 6}};
}

TEST(HeightField, HasItsMiddleAtTheOrigin) {
  const HeightField field = twoCells();
  EXPECT_EQ(field.point(0, 0), Vec3(-2.0F, 1.0F, -2.5F));
  EXPECT_EQ(field.point(1, 0), Vec3(0.0F, 2.0F, -2.5F));
  EXPECT_EQ(field.point(2, 1), Vec3(2.0F, 6.0F, 2.5F));
}

TEST(HeightField, HasTwoTrianglesACellThatLookUp) {
  const TriangleMesh mesh = trianglesOf(twoCells());
  ASSERT_EQ(mesh.vertices.size(), 6U);
  ASSERT_EQ(mesh.triangles.size(), 4U);
  EXPECT_EQ(mesh.vertices[5], Vec3(2.0F, 6.0F, 2.5F));
  for (const auto& triangle : mesh.triangles) {
    const Vec3 a = mesh.vertices[triangle[0]];
    EXPECT_GT(glm::cross(mesh.vertices[triangle[1]] - a, mesh.vertices[triangle[2]] - a).y, 0.0F);
  }
  // From the least x and the largest z to the one across.
  EXPECT_THAT(mesh.triangles[0], testing::ElementsAre(0U, 3U, 1U));
  EXPECT_THAT(mesh.triangles[1], testing::ElementsAre(1U, 3U, 4U));
}

}  // namespace
}  // namespace scatter
