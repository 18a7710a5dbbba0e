#include "levels/mesh/mesh_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "levels/mesh/triangle.h"
#include "levels/meshes.h"

namespace scatter::levels {
namespace {

double distanceByAll(const WorkMesh& mesh, const glm::dvec3& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const Triangle& t : mesh.triangles) {
    const glm::dvec3 nearest =
        closestPoint(point, mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
    least = std::min(least, glm::length(nearest - point));
  }
  return least;
}

TEST(MeshTree, FindsTheNearestOfAllTriangles) {
  for (const std::uint32_t count : {1U, 3U, 40U, 500U}) {
    const auto mesh = makeWorkMesh(testing::soupMesh(count, count));
    ASSERT_TRUE(mesh.has_value());
    const MeshTree tree(*mesh);
    Random random(count);
    for (int i = 0; i < 200; ++i) {
      const glm::dvec3 point(random.inBox(Vec3(1.5F)));
      const double distance = distanceByAll(*mesh, point);
      EXPECT_DOUBLE_EQ(tree.distance(point), distance);
      EXPECT_DOUBLE_EQ(tree.distance(point, 0.5 * distance), 0.5 * distance) << "no further than asked for";
      EXPECT_DOUBLE_EQ(tree.distance(point, 2.0 * distance), distance);
      EXPECT_TRUE(tree.isWithin(point, 1.001 * distance));
      EXPECT_FALSE(tree.isWithin(point, 0.999 * distance));
    }
  }
}

TEST(MeshTree, WindsOnceAroundWhatIsInside) {
  const auto mesh = makeWorkMesh(testing::sphereMesh(16, 1.0F));
  ASSERT_TRUE(mesh.has_value());
  const MeshTree tree(*mesh);
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 point(random.inBox(Vec3(2.0F)));
    if (tree.distance(point) < 0.05) continue;
    EXPECT_NEAR(tree.winding(point), glm::length(point) < 1.0 ? 1.0 : 0.0, 0.05);
  }
}

}  // namespace
}  // namespace scatter::levels
