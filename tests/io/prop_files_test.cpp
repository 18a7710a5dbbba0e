#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <ostream>
#include <set>
#include <string>
#include <utility>

#include "io/loaded_model.h"

namespace scatter {
namespace {

struct ExpectedProp : test::ExpectedModel {
  float mass;
  float height;
  std::size_t middleParts;
  std::size_t finestParts;
};

using Prop = test::LoadedModel<ExpectedProp>;

TEST_P(Prop, HasTheLevelsAndTheMassThatItsPageStates) {
  ASSERT_EQ(model_->levels->count(), 3);
  EXPECT_EQ(model_->levels->coarsest().parts.size(), 1U);
  EXPECT_EQ(model_->levels->level(2).parts.size(), GetParam().middleParts);
  EXPECT_EQ(model_->levels->finest().parts.size(), GetParam().finestParts);
  EXPECT_EQ(model_->mass, GetParam().mass);
}

TEST_P(Prop, StandsOnTheOriginAndIsAsHighAsStated) {
  float low = 1e9F;
  float high = -1e9F;
  for (const Vec3& vertex : model_->mesh.vertices) {
    low = std::min(low, vertex.y);
    high = std::max(high, vertex.y);
  }
  EXPECT_NEAR(low, 0.0F, 0.02F);
  EXPECT_NEAR(high, GetParam().height, 0.02F);
}

TEST_P(Prop, HasCoarseHullsOfAtMostSixteenVertices) {
  for (const ConvexPart& part : model_->levels->level(2).parts) {
    const auto* hull = std::get_if<ConvexHull>(&part.shape);
    EXPECT_TRUE(hull == nullptr || hull->vertices.size() <= 16U);
  }
}

TEST_P(Prop, HasAMeshOfClosedSolidsThatFaceOutward) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  float sixfoldVolume = 0.0F;
  for (const auto& [a, b, c] : model_->mesh.triangles) {
    const auto& v = model_->mesh.vertices;
    sixfoldVolume += glm::dot(v[a], glm::cross(v[b], v[c]));
    for (const auto& edge : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      EXPECT_TRUE(edges.insert(edge).second) << "an edge with two triangles on the same side";
    }
  }
  for (const auto& [from, to] : edges) ASSERT_TRUE(edges.contains({to, from})) << "an open edge";
  // The solids hardly overlap, so that their volumes add up to that of the parts.
  EXPECT_NEAR(sixfoldVolume / 6.0F, model_->levels->mass().volume, 0.15F * model_->levels->mass().volume);
}

/// Within rounding; true only for the corners of a hull, which is what a mesh is made of.
bool holds(const ConvexPart& part, const Vec3& point) {
  if (const auto* box = std::get_if<Box>(&part.shape)) {
    const Vec3 local = glm::abs(part.pose.inverse()(point)) - box->halfExtents;
    return std::max({local.x, local.y, local.z}) <= 1e-5F;
  }
  const auto& vertices = std::get<ConvexHull>(part.shape).vertices;
  return std::find(vertices.begin(), vertices.end(), point) != vertices.end();
}

TEST_P(Prop, HasItsMeshInsideTheFinestLevel) {
  const auto& parts = model_->levels->finest().parts;
  for (const auto& triangle : model_->mesh.triangles) {
    const bool inside = std::any_of(parts.begin(), parts.end(), [&](const ConvexPart& part) {
      return std::all_of(triangle.begin(), triangle.end(),
                         [&](std::uint32_t corner) { return holds(part, model_->mesh.vertices[corner]); });
    });
    ASSERT_TRUE(inside) << "triangle " << triangle[0] << " " << triangle[1] << " " << triangle[2];
  }
}

INSTANTIATE_TEST_SUITE_P(
    Models, Prop,
    testing::Values(ExpectedProp{"table", 25.0F, 0.76F, 7, 25}, ExpectedProp{"chair", 7.0F, 1.0F, 7, 29},
                    ExpectedProp{"shelf", 45.0F, 1.8F, 8, 36}, ExpectedProp{"crate", 30.0F, 0.8F, 6, 34},
                    ExpectedProp{"barrel", 40.0F, 0.89F, 4, 42}, ExpectedProp{"lamp", 9.0F, 1.58F, 5, 24},
                    ExpectedProp{"mug", 12.0F, 0.7F, 6, 19}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace scatter
