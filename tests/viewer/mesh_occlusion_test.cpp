#include "viewer/mesh_occlusion.h"

#include <gmock/gmock.h>

#include "viewer/drawing/ray_tree.h"
#include "viewer/shapes.h"

namespace scatter::test {
namespace {

using testing::Each;
using viewer::MeshData;

/// A floor of 4 m by 4 m with a vertex in its middle, and a wall that stands on its edge at x = `wall`.
MeshData floorAndWall(float wall) {
  MeshData mesh;
  for (const float x : {-2.0F, 0.0F}) {
    for (const float z : {-2.0F, 0.0F})
      addQuad(mesh, {Vec3(x, 0.0F, z), Vec3(x, 0.0F, z + 2.0F), Vec3(x + 2.0F, 0.0F, z + 2.0F),
                     Vec3(x + 2.0F, 0.0F, z)});
  }
  addQuad(mesh,
          {Vec3(wall, 0.0F, -2.0F), Vec3(wall, 0.0F, 2.0F), Vec3(wall, 4.0F, 2.0F), Vec3(wall, 4.0F, -2.0F)});
  return mesh;
}

/// At the middle of the floor.
float occlusionInTheMiddle(const MeshData& mesh) {
  const auto occlusion = viewer::bakeOcclusion(mesh);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (mesh.positions[i] == Vec3(0.0F)) return occlusion[i];
  }
  return -1.0F;
}

TEST(MeshOcclusion, ConvexMeshesHaveNone) {
  EXPECT_THAT(viewer::bakeOcclusion(boxMesh()), Each(0.0F));
}

TEST(MeshOcclusion, TheNearerAWallTheDarker) {
  const float far = occlusionInTheMiddle(floorAndWall(1.8F));
  const float near = occlusionInTheMiddle(floorAndWall(0.2F));
  EXPECT_GT(far, 0.0F);
  EXPECT_GT(near, far + 0.1F);
  // A wall covers half of the sky.
  EXPECT_LE(near, 0.55F);
}

TEST(MeshOcclusion, InsideAFlatBoxIsDark) {
  MeshData mesh = boxMesh({0.5F, 0.1F, 0.5F});
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) std::swap(mesh.indices[i], mesh.indices[i + 1]);
  for (Vec3& normal : mesh.normals) normal = -normal;
  // A vertex in the middle of a face, since those in the corners see along the sides.
  mesh.positions.emplace_back(0.0F, -0.1F, 0.0F);
  mesh.normals.emplace_back(0.0F, 1.0F, 0.0F);
  EXPECT_GT(viewer::bakeOcclusion(mesh).back(), 0.4F);
}

TEST(MeshOcclusion, IsTheSameEveryTime) {
  const MeshData mesh = floorAndWall(0.5F);
  EXPECT_EQ(viewer::bakeOcclusion(mesh), viewer::bakeOcclusion(mesh));
}

TEST(MeshOcclusion, ANumberForEachVertexEvenWithoutTriangles) {
  MeshData mesh = boxMesh();
  mesh.indices.clear();
  EXPECT_THAT(viewer::bakeOcclusion(mesh), testing::AllOf(testing::SizeIs(24), Each(0.0F)));
  EXPECT_TRUE(viewer::bakeOcclusion({}).empty());
}

TEST(RayTree, FindsTheNearestHit) {
  MeshData mesh;
  for (int i = 0; i < 100; ++i) {
    const float z = -1.0F - static_cast<float>((37 * i) % 100);
    addQuad(mesh, {Vec3(-1.0F, -1.0F, z), Vec3(1.0F, -1.0F, z), Vec3(1.0F, 1.0F, z), Vec3(-1.0F, 1.0F, z)});
  }
  const viewer::RayTree tree(mesh);
  EXPECT_NEAR(tree.nearestHit({0.3F, 0.2F, 0.0F}, {0.0F, 0.0F, -1.0F}, 1000.0F), 1.0F, 1e-5F);
  EXPECT_NEAR(tree.nearestHit({0.3F, 0.2F, -41.5F}, {0.0F, 0.0F, -1.0F}, 1000.0F), 0.5F, 1e-4F);
  EXPECT_EQ(tree.nearestHit({0.3F, 0.2F, -41.5F}, {0.0F, 0.0F, -1.0F}, 0.25F), 0.25F);
  EXPECT_EQ(tree.nearestHit({1.5F, 0.2F, 0.0F}, {0.0F, 0.0F, -1.0F}, 1000.0F), 1000.0F);
  EXPECT_EQ(tree.nearestHit({0.3F, 0.2F, 0.0F}, {0.0F, 0.0F, 1.0F}, 1000.0F), 1000.0F);
}

}  // namespace
}  // namespace scatter::test
