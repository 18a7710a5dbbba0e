#include "levels/polytope.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <vector>

#include "levels/convex_hull.h"
#include "levels/part_builders.h"

namespace scatter::levels {
namespace {

using scatter::testing::Random;

Polytope unitBox() {
  return Polytope::box(glm::dvec3(0.0), glm::dmat3(1.0), glm::dvec3(1.0));
}

TEST(Polytope, BoxFacesLookOutward) {
  const Polytope box = Polytope::box({1.0, 2.0, 3.0}, glm::dmat3(1.0), {1.0, 2.0, 3.0});
  ASSERT_EQ(box.faces().size(), 6U);
  EXPECT_NEAR(box.moments().volume, 48.0, 1e-12);
  for (const Polytope::Face& face : box.faces()) {
    EXPECT_LT(face.plane.signedDistance({1.0, 2.0, 3.0}), 0.0);
    for (const std::uint32_t vertex : box.loop(face)) {
      EXPECT_NEAR(face.plane.signedDistance(box.vertices()[vertex]), 0.0, 1e-12);
    }
  }
}

TEST(Polytope, ClipCutsOffTheRest) {
  const Polytope half = unitBox().clipped({{1.0, 0.0, 0.0}, 0.5}, 1e-10);
  EXPECT_NEAR(half.moments().volume, 6.0, 1e-12);
  EXPECT_NEAR(half.moments().center.x, -0.25, 1e-12);
  EXPECT_EQ(half.faces().size(), 6U);
  EXPECT_EQ(half.vertices().size(), 8U);
}

TEST(Polytope, ClipThroughCornersAndEdges) {
  // Through four corners, along two diagonals: a triangular prism.
  const HalfSpace diagonal{glm::normalize(glm::dvec3(1.0, 1.0, 0.0)), 0.0};
  const Polytope prism = unitBox().clipped(diagonal, 1e-10);
  EXPECT_NEAR(prism.moments().volume, 4.0, 1e-12);
  EXPECT_EQ(prism.faces().size(), 5U);
  EXPECT_EQ(prism.vertices().size(), 6U);
}

TEST(Polytope, ClipThatMissesOrTakesAll) {
  EXPECT_EQ(unitBox().clipped({{0.0, 1.0, 0.0}, 2.0}, 1e-10).faces().size(), 6U);
  EXPECT_TRUE(unitBox().clipped({{0.0, 1.0, 0.0}, -2.0}, 1e-10).isEmpty());
  // Along a face: everything or nothing.
  EXPECT_NEAR(unitBox().clipped({{0.0, 1.0, 0.0}, 1.0}, 1e-10).moments().volume, 8.0, 1e-12);
  EXPECT_TRUE(unitBox().clipped({{0.0, -1.0, 0.0}, -1.0}, 1e-10).isEmpty());
}

TEST(Polytope, BothSidesOfRandomCutsMakeTheWhole) {
  Random random(5);
  for (int round = 0; round < 30; ++round) {
    std::vector<glm::dvec3> points;
    points.reserve(24);
    for (int i = 0; i < 24; ++i) points.emplace_back(random.direction());
    const Result<Polytope> hull = convexHull(points);
    ASSERT_TRUE(hull.has_value()) << hull.error().message;
    std::vector<Polytope> pieces{*hull};
    for (int cut = 0; cut < 6; ++cut) {
      // Now and then through three corners of what is left, where rounding is worst.
      HalfSpace plane{glm::dvec3(random.direction()), 0.2 * static_cast<double>(random.uniform(-1.0F, 1.0F))};
      if (cut % 2 == 1) {
        const auto& v = pieces.front().vertices();
        plane.normal = glm::normalize(glm::cross(v[1] - v[0], v[2] - v[0]));
        plane.offset = glm::dot(plane.normal, v[0]);
      }
      std::vector<Polytope> next;
      for (const Polytope& piece : pieces) {
        for (const HalfSpace& side : {plane, plane.flipped()}) {
          Polytope part = piece.clipped(side, 1e-10);
          if (!part.isEmpty()) next.push_back(std::move(part));
        }
      }
      pieces = std::move(next);
    }
    double volume = 0.0;
    for (const Polytope& piece : pieces) volume += piece.moments().volume;
    EXPECT_NEAR(volume, hull->moments().volume, 1e-9);
  }
}

TEST(Polytope, Distance) {
  EXPECT_EQ(unitBox().distance({0.2, -0.9, 0.0}), 0.0);
  EXPECT_NEAR(unitBox().distance({3.0, 0.5, 0.0}), 2.0, 1e-12);
  EXPECT_NEAR(unitBox().distance({4.0, 5.0, 0.0}), 5.0, 1e-12);  // an edge: 3, 4, 5
  EXPECT_NEAR(unitBox().distance({2.0, 3.0, 3.0}), 3.0, 1e-12);  // a corner: 1, 2, 2
  EXPECT_NEAR(unitBox().distance({-1.5, 0.0, 0.0}), 0.5, 1e-12);
}

}  // namespace
}  // namespace scatter::levels
