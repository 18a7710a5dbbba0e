#include "levels/part_geometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "levels/part_builders.h"

namespace scatter::levels {
namespace {

using scatter::testing::Random;

constexpr double kMargin = 0.05;
constexpr double kEpsilon = 1e-10;

/// One of each shape, its pose random, and how far a polytope may be from it.
struct Sample {
  ConvexPart part;
  double outerError;
  double innerError;
};

std::vector<Sample> samples(Random& random) {
  std::vector<Sample> all{{scatter::testing::box({0.5F, 1.0F, 2.0F}), 1e-9, 1e-9},
                          {scatter::testing::sphere(2.0F), 0.02, 0.02},
                          {scatter::testing::capsule(0.5F, 1.0F), 0.005, 0.005},
                          {scatter::testing::cylinder(0.8F, 0.5F), 0.004, 0.004},
                          // Only the faces of a coarser hull have its whole margin.
                          {scatter::testing::boxHull({0.5F, 1.0F, 2.0F}), 0.08 * kMargin, kMargin}};
  for (Sample& sample : all) sample.part.pose = {random.inBox(Vec3(3.0F)), random.rotation()};
  return all;
}

double reachOf(const std::vector<glm::dvec3>& points, const glm::dvec3& direction) {
  double reach = -std::numeric_limits<double>::infinity();
  for (const glm::dvec3& point : points) reach = std::max(reach, glm::dot(point, direction));
  return reach;
}

TEST(PartGeometry, SupportOfASphereAndABox) {
  const glm::dvec3 direction = glm::normalize(glm::dvec3(1.0, 2.0, 2.0));
  EXPECT_NEAR(support(scatter::testing::sphere(2.0F, {3.0F, 0.0F, 0.0F}), 0.0, direction), 1.0 + 2.0, 1e-6);
  // The corner (1, 1, 1): (1 + 2 + 2) / 3.
  EXPECT_NEAR(support(scatter::testing::box(Vec3(1.0F)), kMargin, direction), 5.0 / 3.0, 1e-6);
  EXPECT_NEAR(support(scatter::testing::boxHull(Vec3(1.0F)), kMargin, direction), 5.0 / 3.0 + kMargin, 1e-6);
}

TEST(PartGeometry, PolytopesEncloseAndFill) {
  Random random(9);
  for (int round = 0; round < 5; ++round) {
    for (const Sample& sample : samples(random)) {
      const Polytope outer = outerPolytope(sample.part, kMargin, {}, kEpsilon);
      const Polytope inner = innerPolytope(sample.part, kMargin, 0.0);
      for (int i = 0; i < 500; ++i) {
        const glm::dvec3 direction(random.direction());
        const double exact = support(sample.part, kMargin, direction);
        const double around = reachOf(outer.vertices(), direction);
        const double within = reachOf(inner.vertices(), direction);
        EXPECT_GE(around, exact - 1e-6) << "shape " << sample.part.shape.index();
        EXPECT_LE(within, exact + 1e-6) << "shape " << sample.part.shape.index();
        EXPECT_GE(within, exact - sample.innerError) << "shape " << sample.part.shape.index();
      }
      // No face of the polytope around is further out than promised.
      for (const Polytope::Face& face : outer.faces()) {
        const double exact = support(sample.part, kMargin, face.plane.normal);
        EXPECT_GE(face.plane.offset, exact - 1e-6) << "shape " << sample.part.shape.index();
        EXPECT_LE(face.plane.offset, exact + sample.outerError) << "shape " << sample.part.shape.index();
      }
    }
  }
}

TEST(PartGeometry, TangentsAreTouched) {
  Random random(10);
  for (const Sample& sample : samples(random)) {
    std::vector<glm::dvec3> tangents;
    tangents.reserve(10);
    for (int i = 0; i < 10; ++i) tangents.emplace_back(glm::normalize(glm::dvec3(random.direction())));
    const Polytope outer = outerPolytope(sample.part, kMargin, tangents, kEpsilon);
    for (const glm::dvec3& tangent : tangents) {
      EXPECT_NEAR(reachOf(outer.vertices(), tangent), support(sample.part, kMargin, tangent), 1e-6)
          << "shape " << sample.part.shape.index();
    }
  }
}

TEST(PartGeometry, InsetShrinksByTheMargin) {
  Random random(12);
  for (const Sample& sample : samples(random)) {
    const Polytope inner = innerPolytope(sample.part, kMargin, kMargin);
    for (int i = 0; i < 200; ++i) {
      const glm::dvec3 direction(random.direction());
      EXPECT_LE(reachOf(inner.vertices(), direction) + kMargin,
                support(sample.part, kMargin, direction) + 1e-6)
          << "shape " << sample.part.shape.index();
    }
  }
  EXPECT_TRUE(innerPolytope(scatter::testing::sphere(0.05F), 0.06, 0.06).isEmpty());
  EXPECT_TRUE(innerPolytope(scatter::testing::box({1.0F, 0.05F, 1.0F}), 0.06, 0.06).isEmpty());
  EXPECT_TRUE(innerPolytope(scatter::testing::cylinder(1.0F, 0.05F), 0.06, 0.06).isEmpty());
}

TEST(PartGeometry, OnlyBoxesAndHullsHaveAFlatSidedCore) {
  Random random(13);
  for (const Sample& sample : samples(random)) {
    const auto core = flatSidedCore(sample.part);
    ASSERT_TRUE(core.has_value());
    const bool isFlatSided = sample.part.shape.index() == 0 || sample.part.shape.index() == 4;
    EXPECT_EQ(core->has_value(), isFlatSided);
  }
}

}  // namespace
}  // namespace scatter::levels
