#include "levels/measure/gap_over_mesh.h"

#include <gtest/gtest.h>

#include <utility>

#include "levels/meshes.h"

namespace scatter::levels {
namespace {

using namespace testing;  // the meshes

const glm::dvec3 kRight(1.0, 0.0, 0.0);
const glm::dvec3 kUp(0.0, 1.0, 0.0);

MeshSpace spaceOf(const SurfaceMesh& mesh, MeshInterior interior = MeshInterior::kAutomatic) {
  return makeMeshSpace(makeWorkMesh(mesh).value(), interior);
}

ConvexPart box(const Vec3& halfExtents, const Vec3& at = Vec3(0.0F)) {
  return {Box{halfExtents}, {at, kNoRotation}};
}

TEST(GapOverMesh, IsHowFarTheLevelEndsFromTheMesh) {
  const MeshSpace space = spaceOf(boxMesh(Vec3(1.0F, 0.5F, 0.8F), Vec3(5.0F, 0.0F, 0.0F)));
  const GapOverMesh gap({{box({1.0F, 0.7F, 0.8F}, {5.0F, 0.0F, 0.0F})}}, 0.0, space);
  EXPECT_NEAR(gap.at({5.3, 0.5, 0.1}, kUp), 0.2, 1e-4);
  for (const glm::dvec3& normal : {kUp, -kUp}) EXPECT_EQ(outward(space, {5.3, 0.5, 0.1}, normal), kUp);
  EXPECT_NEAR(gap.at({6.0, 0.1, 0.1}, kRight), 0.0, 1e-4);
}

TEST(GapOverMesh, GoesThroughPartsThatTouchAndCountsTheMarginOfHulls) {
  const MeshSpace space = spaceOf(boxMesh(Vec3(0.5F)));
  ConvexHull hull;
  for (const Vec3& corner : boxCorners(Vec3(0.5F, 0.1F, 0.5F))) hull.vertices.push_back(corner);
  const GapOverMesh gap({{box(Vec3(0.5F)), {hull, {{0.0F, 0.6F, 0.0F}, kNoRotation}}}}, 0.05, space);
  EXPECT_NEAR(gap.at({0.0, 0.5, 0.0}, kUp), 0.2 + 0.05, 1e-4);
}

TEST(GapOverMesh, EndsWhereTheMeshComesAgain) {
  // Two walls, two metres apart: between them the mesh is at most one metre away.
  const MeshSpace space = spaceOf(joined(boxMesh(Vec3(0.1F, 1.0F, 1.0F), Vec3(-1.1F, 0.0F, 0.0F)),
                                         boxMesh(Vec3(0.1F, 1.0F, 1.0F), Vec3(1.1F, 0.0F, 0.0F))));
  const GapOverMesh gap({{box({1.2F, 1.0F, 1.0F})}}, 0.0, space);
  EXPECT_NEAR(gap.at({-1.0, 0.0, 0.0}, kRight), 1.0, 0.02);
  EXPECT_NEAR(gap.at({-1.2, 0.0, 0.0}, -kRight), 0.0, 1e-4);
}

TEST(GapOverMesh, OfASheetIsTheLargerOfBothSides) {
  const SurfaceMesh sheet{{{0.0F, 0.0F, 0.0F}, {2.0F, 0.0F, 0.0F}, {2.0F, 0.0F, 2.0F}, {0.0F, 0.0F, 2.0F}},
                          {{0, 2, 1}, {0, 3, 2}}};
  const MeshSpace space = spaceOf(sheet, MeshInterior::kSurface);
  const GapOverMesh gap({{box({1.0F, 0.2F, 1.0F}, {1.0F, 0.1F, 1.0F})}}, 0.0, space);
  EXPECT_NEAR(gap.at({1.0, 0.0, 1.0}, kUp), 0.3, 1e-4);
  EXPECT_NEAR(gap.at({1.0, 0.0, 1.0}, -kUp), 0.3, 1e-4);
}

TEST(GapOverMesh, IsNothingWhereTheLevelIsNot) {
  const MeshSpace space = spaceOf(boxMesh(Vec3(0.5F)));
  const GapOverMesh gap({{box(Vec3(0.3F))}}, 0.0, space);
  EXPECT_EQ(gap.at({0.0, 0.5, 0.0}, kUp), 0.0);
}

}  // namespace
}  // namespace scatter::levels
