#include "viewer/drawing/surface_shading.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace scatter::test {
namespace {

/// Two squares that share an edge on the z axis and bend down by an angle.
SurfaceMesh roof(float angle) {
  const float x = std::cos(angle);
  const float y = -std::sin(angle);
  return {{{-1.0F, 0.0F, 0.0F},
           {-1.0F, 0.0F, 1.0F},
           {0.0F, 0.0F, 0.0F},
           {0.0F, 0.0F, 1.0F},
           {x, y, 0.0F},
           {x, y, 1.0F}},
          {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 5}}};
}

TEST(SurfaceShading, GentleBendsAreSmooth) {
  const viewer::MeshData mesh = viewer::shadeSurface(roof(0.3F));
  EXPECT_EQ(mesh.indices.size(), 12U);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    EXPECT_NEAR(glm::length(mesh.normals[i]), 1.0F, 1e-5F);
    // On the ridge: between straight up and 0.3 to the side.
    if (mesh.positions[i].x == 0.0F) {
      EXPECT_NEAR(std::atan2(mesh.normals[i].x, mesh.normals[i].y), 0.15F, 0.06F);
    }
  }
}

TEST(SurfaceShading, SharpBendsKeepTheirEdge) {
  const viewer::MeshData mesh = viewer::shadeSurface(roof(1.2F));
  EXPECT_EQ(mesh.positions.size(), 8U) << "the two vertices of the ridge are there twice";
  for (const Vec3& normal : mesh.normals) {
    const float angle = std::atan2(normal.x, normal.y);
    EXPECT_TRUE(std::abs(angle) < 1e-4F || std::abs(angle - 1.2F) < 1e-4F) << angle;
  }
}

TEST(SurfaceShading, TrianglesWithoutAreaAreLeftOut) {
  SurfaceMesh surface = roof(0.0F);
  surface.triangles.push_back({0, 1, 1});
  EXPECT_EQ(viewer::shadeSurface(surface).indices.size(), 12U);
}

}  // namespace
}  // namespace scatter::test
