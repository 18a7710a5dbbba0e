#include "io/mesh/polygon.h"

#include <gtest/gtest.h>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

namespace scatter::io {
namespace {

glm::dvec3 areaOf(const std::vector<glm::dvec3>& corners, const std::array<std::uint32_t, 3>& t) {
  return 0.5 * glm::cross(corners[t[1]] - corners[t[0]], corners[t[2]] - corners[t[0]]);
}

/// A star in a slanted plane: every second corner is reflex.
std::vector<glm::dvec3> star(int points) {
  std::vector<glm::dvec3> corners;
  for (int i = 0; i < 2 * points; ++i) {
    const double radius = i % 2 == 0 ? 2.0 : 0.5;
    const double angle = std::numbers::pi * i / points;
    const double x = radius * std::cos(angle);
    corners.emplace_back(x, radius * std::sin(angle), 0.7 * x);
  }
  return corners;
}

TEST(Polygon, TrianglesOfAStarDoNotOverlap) {
  for (const int points : {3, 5, 12, 100}) {
    const auto corners = star(points);
    const auto triangles = triangulate(corners);
    ASSERT_EQ(triangles.size(), corners.size() - 2);
    glm::dvec3 sum{0.0};
    double total = 0.0;
    for (const auto& triangle : triangles) {
      sum += areaOf(corners, triangle);
      total += glm::length(areaOf(corners, triangle));
    }
    // Overlaps would need triangles that face the other way.
    EXPECT_NEAR(glm::length(sum), total, 1e-9 * total) << points;
    EXPECT_GT(sum.z, 0.0);
  }
}

TEST(Polygon, DegenerateOnesBecomeFans) {
  EXPECT_EQ(triangulate(std::vector<glm::dvec3>(5, glm::dvec3(1.0))).size(), 3U);
  std::vector<glm::dvec3> bowTie{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(triangulate(bowTie).size(), 2U);
  EXPECT_EQ(triangulate(std::vector<glm::dvec3>(5000, glm::dvec3(std::nan("")))).size(), 4998U);
}

}  // namespace
}  // namespace scatter::io
