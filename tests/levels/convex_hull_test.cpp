#include "levels/convex_hull.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <vector>

#include "levels/part_builders.h"

namespace scatter::levels {
namespace {

using scatter::testing::Random;
using ::testing::HasSubstr;

std::vector<glm::dvec3> toDouble(const std::vector<Vec3>& points) {
  return {points.begin(), points.end()};
}

std::string errorOf(const std::vector<glm::dvec3>& points, double rounding = 0.0) {
  const Result<Polytope> hull = convexHull(points, rounding);
  return hull ? "no error" : hull.error().message;
}

TEST(ConvexHull, OfACubeHasSixSquares) {
  const auto points = toDouble(scatter::testing::boxCorners(Vec3(1.0F)));
  const Result<Polytope> hull = convexHull(points);
  ASSERT_TRUE(hull.has_value()) << hull.error().message;
  EXPECT_EQ(hull->vertices().size(), 8U);
  ASSERT_EQ(hull->faces().size(), 6U);
  for (const Polytope::Face& face : hull->faces()) {
    EXPECT_EQ(hull->loop(face).size(), 4U);
    EXPECT_NEAR(face.plane.offset, 1.0, 1e-12);
  }
  EXPECT_NEAR(hull->moments().volume, 8.0, 1e-12);
}

TEST(ConvexHull, HoldsItsPointsAndIsClosed) {
  Random random(3);
  for (int round = 0; round < 40; ++round) {
    std::vector<glm::dvec3> points;
    points.reserve(60);
    // Coarse coordinates make many coplanar and equal points.
    for (int i = 0; i < 60; ++i) points.push_back(glm::round(glm::dvec3(random.inBox(Vec3(3.0F)))));
    const Result<Polytope> hull = convexHull(points);
    ASSERT_TRUE(hull.has_value()) << hull.error().message;
    glm::dvec3 areas{0.0};
    std::size_t corners = 0;
    for (const Polytope::Face& face : hull->faces()) {
      for (const glm::dvec3& point : points) EXPECT_LE(face.plane.signedDistance(point), 1e-12);
      const auto loop = hull->loop(face);
      corners += loop.size();
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const glm::dvec3& a = hull->vertices()[loop[i]];
        EXPECT_NEAR(face.plane.signedDistance(a), 0.0, 1e-9);
        areas += 0.5 * glm::cross(a, hull->vertices()[loop[(i + 1) % loop.size()]]);
      }
    }
    // The area vectors of a closed surface cancel, and Euler: V - E + F = 2.
    EXPECT_NEAR(glm::length(areas), 0.0, 1e-9);
    EXPECT_EQ(hull->vertices().size() + hull->faces().size(), corners / 2 + 2);
  }
}

TEST(ConvexHull, FlatSetsFail) {
  EXPECT_EQ(errorOf({}), "its 0 vertices are fewer than 4");
  EXPECT_EQ(errorOf(std::vector<glm::dvec3>(5, glm::dvec3(1.0))), "its 5 vertices lie in one plane");
  const std::vector<glm::dvec3> line{{0.0, 0.0, 0.0}, {1.0, 1.0, 0.0}, {2.0, 2.0, 0.0}, {3.0, 3.0, 0.0}};
  EXPECT_THAT(errorOf(line), HasSubstr("lie in one plane"));
  std::vector<glm::dvec3> square{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {1.0, 1.0, 0.0}};
  EXPECT_THAT(errorOf(square), HasSubstr("lie in one plane"));
  square.back().z = 1e-8;
  EXPECT_THAT(errorOf(square), HasSubstr("lie in one plane"));
  square.back().z = 1e-4;
  EXPECT_EQ(errorOf(square), "no error");
  EXPECT_THAT(errorOf(square, 1e-3), HasSubstr("lie in one plane"));
}

TEST(ConvexHull, ThinPlatesWork) {
  Random random(11);
  for (int round = 0; round < 40; ++round) {
    const glm::dquat turn(random.rotation());
    std::vector<glm::dvec3> points;
    for (int i = 0; i < 40; ++i) {
      const glm::dvec3 p(random.inBox(Vec3(1.0F)));
      points.push_back(turn * glm::dvec3(p.x, p.y, i % 2 == 0 ? 1e-4 : 0.0));
    }
    const Result<Polytope> hull = convexHull(points);
    ASSERT_TRUE(hull.has_value()) << hull.error().message;
    const double volume = hull->moments().volume;
    EXPECT_GT(volume, 1e-4);
    EXPECT_LT(volume, 4.1e-4);
  }
}

TEST(ConvexHull, FailureIsSilent) {
  ::testing::internal::CaptureStderr();
  ::testing::internal::CaptureStdout();
  EXPECT_NE(errorOf({{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.3, 0.3, 0.0}}), "no error");
  std::vector<glm::dvec3> notFinite = toDouble(scatter::testing::boxCorners(Vec3(1.0F)));
  notFinite[3].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(errorOf(notFinite), "no error");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
}

}  // namespace
}  // namespace scatter::levels
