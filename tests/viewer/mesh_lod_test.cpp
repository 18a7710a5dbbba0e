#include "viewer/drawing/mesh_lod.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <set>

#include "viewer/shapes.h"

namespace scatter::test {
namespace {

using viewer::MeshData;
using viewer::MeshDetail;

/// A ball of 1 m.
MeshData ballMesh(std::uint32_t rings, std::uint32_t around) {
  MeshData mesh;
  for (std::uint32_t i = 0; i <= rings; ++i) {
    const float polar = glm::pi<float>() * static_cast<float>(i) / static_cast<float>(rings);
    for (std::uint32_t j = 0; j < around; ++j) {
      const float angle = glm::two_pi<float>() * static_cast<float>(j) / static_cast<float>(around);
      mesh.positions.emplace_back(std::sin(polar) * std::cos(angle), std::cos(polar),
                                  std::sin(polar) * std::sin(angle));
    }
  }
  mesh.normals = mesh.positions;
  for (std::uint32_t i = 0; i < rings; ++i) {
    for (std::uint32_t j = 0; j < around; ++j) {
      const std::uint32_t a = i * around + j;
      const std::uint32_t b = i * around + (j + 1) % around;
      mesh.indices.insert(mesh.indices.end(), {a, b, a + around, b, b + around, a + around});
    }
  }
  return mesh;
}

TEST(MeshLod, DetailsGetCoarserAndSayHowMuch) {
  const auto details = viewer::makeDetails(ballMesh(60, 80));
  ASSERT_GE(details.size(), 3U);
  EXPECT_EQ(details[0].error, 0.0F);
  EXPECT_EQ(details[0].mesh.indices.size(), ballMesh(60, 80).indices.size());
  for (std::size_t i = 1; i < details.size(); ++i) {
    EXPECT_LT(details[i].mesh.indices.size(), details[i - 1].mesh.indices.size());
    EXPECT_GT(details[i].error, details[i - 1].error);
  }
  EXPECT_LT(details.back().mesh.indices.size(), details[0].mesh.indices.size() / 10);
}

TEST(MeshLod, ErrorBoundsTheUsualDistanceFromTheSurface) {
  for (const MeshDetail& detail : viewer::makeDetails(ballMesh(60, 80))) {
    float sum = 0.0F;
    for (const Vec3& position : detail.mesh.positions) sum += std::abs(1.0F - glm::length(position));
    EXPECT_LE(sum / static_cast<float>(detail.mesh.positions.size()), detail.error + 1e-5F);
  }
}

TEST(MeshLod, CoarserBallsFaceOutward) {
  for (const MeshDetail& detail : viewer::makeDetails(ballMesh(60, 80))) {
    const MeshData& mesh = detail.mesh;
    float outward = 0.0F;
    float inward = 0.0F;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
      const Vec3& a = mesh.positions[mesh.indices[i]];
      const Vec3& b = mesh.positions[mesh.indices[i + 1]];
      const Vec3& c = mesh.positions[mesh.indices[i + 2]];
      const Vec3 across = 0.5F * glm::cross(b - a, c - a);
      (glm::dot(across, a + b + c) >= 0.0F ? outward : inward) += glm::length(across);
    }
    // A sphere of 1 m has 12.6 m². Clusters may fold a triangle over, behind another one.
    EXPECT_GT(outward, 11.0F) << mesh.indices.size() / 3;
    EXPECT_LT(inward, 0.02F * outward) << mesh.indices.size() / 3;
  }
}

TEST(MeshLod, SharpEdgesStaySharp) {
  const MeshDetail detail = viewer::clusterVertices(boxMesh(), 0.1F);
  std::set<std::tuple<float, float, float>> normals;
  for (const Vec3& normal : detail.mesh.normals) normals.insert({normal.x, normal.y, normal.z});
  EXPECT_EQ(normals.size(), 6U);
  EXPECT_EQ(detail.mesh.indices.size(), 36U);
  EXPECT_EQ(detail.error, 0.0F);
}

TEST(MeshLod, ColoursAndOcclusionComeAlong) {
  MeshData mesh = ballMesh(60, 80);
  mesh.colors.assign(mesh.positions.size(), glm::vec3(0.25F, 0.5F, 0.75F));
  mesh.occlusion.assign(mesh.positions.size(), 0.5F);
  mesh.twoSided = true;
  const MeshData coarse = viewer::makeDetails(mesh).back().mesh;
  ASSERT_EQ(coarse.colors.size(), coarse.positions.size());
  ASSERT_EQ(coarse.occlusion.size(), coarse.positions.size());
  EXPECT_NEAR(coarse.colors[0].g, 0.5F, 1e-4F);
  EXPECT_NEAR(coarse.occlusion[0], 0.5F, 1e-4F);
  EXPECT_TRUE(coarse.twoSided);
}

TEST(MeshLod, MeshesWithoutSizeHaveOneDetail) {
  EXPECT_EQ(viewer::makeDetails({}).size(), 1U);
  MeshData point;
  point.positions.assign(3, Vec3(1.0F));
  point.normals.assign(3, Vec3(0.0F, 1.0F, 0.0F));
  point.indices = {0, 1, 2};
  EXPECT_EQ(viewer::makeDetails(point).size(), 1U);
}

TEST(MeshLod, OutlineHoldsTheMesh) {
  MeshData mesh = boxMesh({1.0F, 2.0F, 3.0F});
  for (Vec3& position : mesh.positions) position += Vec3(5.0F, 0.0F, 0.0F);
  const auto outline = viewer::outlineOf(viewer::makeDetails(mesh));
  EXPECT_NEAR(glm::distance(outline.center, Vec3(5.0F, 0.0F, 0.0F)), 0.0F, 1e-5F);
  EXPECT_NEAR(outline.radius, std::sqrt(14.0F), 1e-4F);
}

}  // namespace
}  // namespace scatter::test
