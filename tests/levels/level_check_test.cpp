#include <scatter/levels/level_check.h>

#include <gmock/gmock.h>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <string>
#include <vector>

#include "levels/part_builders.h"

namespace scatter {
namespace {

using scatter::testing::box;
using scatter::testing::boxHull;
using scatter::testing::capsule;
using scatter::testing::cylinder;
using scatter::testing::hull;
using scatter::testing::Random;
using scatter::testing::sphere;
using ::testing::HasSubstr;

SurfaceMesh boxMesh(const Vec3& halfExtents, const Vec3& center = Vec3(0.0F)) {
  SurfaceMesh mesh;
  for (const Vec3& corner : scatter::testing::boxCorners(halfExtents))
    mesh.vertices.push_back(center + corner);
  // Corners in the order x, y, z with z fastest.
  mesh.triangles = {{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
                    {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
  return mesh;
}

SurfaceMesh triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  return {{a, b, c}, {{0, 1, 2}}};
}

LevelCheck check(const std::vector<Level>& levels, const SurfaceMesh& mesh, float margin = 0.0F,
                 const LevelCheckDef& def = {}) {
  const auto result = checkLevels(levels, margin, &mesh, def);
  EXPECT_TRUE(result.has_value()) << result.error().message;
  return result.value_or(LevelCheck{});
}

TEST(LevelCheck, AcceptsAMeshOnThePartsSurface) {
  for (const ConvexPart& part : {box(Vec3(1, 2, 3)), boxHull(Vec3(1, 2, 3))}) {
    const LevelCheck result = check({Level{{part}}}, boxMesh(Vec3(1, 2, 3)));
    EXPECT_TRUE(result.passed());
    EXPECT_EQ(result.mesh->count, 12U);
    EXPECT_EQ(result.mesh->outside, 0U);
    EXPECT_NEAR(result.mesh->clearance, 0.0, 1e-9);
  }
}

TEST(LevelCheck, MeasuresTheClearance) {
  const LevelCheck result = check({Level{{box(Vec3(1, 2, 3))}}}, boxMesh(Vec3(0.9F, 1.5F, 2.75F)));
  EXPECT_TRUE(result.passed());
  EXPECT_NEAR(result.mesh->clearance, 0.1, 1e-6);
}

TEST(LevelCheck, SaysWhereAndByHowMuch) {
  const LevelCheck result = check({Level{{box(Vec3(1.0F))}}}, boxMesh(Vec3(0.9F), Vec3(0.3F, 0.0F, 0.0F)));
  EXPECT_FALSE(result.passed());
  ASSERT_TRUE(result.mesh->worst.has_value());
  EXPECT_NEAR(result.mesh->worst->distance, 0.2, 1e-3);
  EXPECT_NEAR(result.mesh->worst->point.x, 1.2F, 1e-3F);
  // The side at x = 1.2 and a strip of four others.
  EXPECT_EQ(result.mesh->outside, 10U);
  EXPECT_NEAR(result.mesh->areaOutside, (4 * 0.2 * 1.8 + 1.8 * 1.8) / (6 * 1.8 * 1.8), 1e-4);
}

TEST(LevelCheck, ProvesWhatSeveralPartsHoldTogether) {
  const Level halves{{box(Vec3(1, 1, 1), Vec3(-1, 0, 0)), box(Vec3(1, 1, 1), Vec3(1, 0, 0))}};
  const LevelCheck result = check({halves}, boxMesh(Vec3(1.9F, 0.9F, 0.9F)));
  EXPECT_TRUE(result.passed());
  EXPECT_EQ(result.mesh->shared, 8U);
}

TEST(LevelCheck, FindsACrackBetweenParts) {
  const Level apart{{box(Vec3(1, 1, 1), Vec3(-1.01F, 0, 0)), box(Vec3(1, 1, 1), Vec3(1.01F, 0, 0))}};
  // All corners are inside a part; only the middle is not.
  const LevelCheck result = check({apart}, triangle({-1, 0, 0}, {1, 0, 0}, {1, 0.5F, 0}));
  EXPECT_EQ(result.mesh->outside, 1U);
  EXPECT_NEAR(result.mesh->worst->distance, 0.01, 1e-4);
  EXPECT_NEAR(result.mesh->worst->point.x, 0.0F, 1e-3F);
}

TEST(LevelCheck, HandlesRoundParts) {
  const SurfaceMesh inside = boxMesh(Vec3(0.5F));
  EXPECT_TRUE(check({Level{{sphere(0.867F)}}}, inside).passed());
  EXPECT_FALSE(check({Level{{sphere(0.865F)}}}, inside).passed());
  EXPECT_TRUE(check({Level{{cylinder(0.708F, 0.5F)}}}, inside).passed());
  EXPECT_FALSE(check({Level{{cylinder(0.706F, 0.5F)}}}, inside).passed());
  EXPECT_TRUE(check({Level{{capsule(0.708F, 0.5F)}}}, inside).passed());
  EXPECT_FALSE(check({Level{{capsule(0.706F, 0.5F)}}}, inside).passed());
}

TEST(LevelCheck, ProvesWhatRoundPartsHoldTogether) {
  const SurfaceMesh strip = triangle({-1.2F, 0, 0}, {1.2F, 0, 0}, {0, 0.3F, 0});
  EXPECT_TRUE(check({Level{{sphere(1, Vec3(-0.5F, 0, 0)), sphere(1, Vec3(0.5F, 0, 0))}}}, strip).passed());
  EXPECT_TRUE(
      check({Level{{sphere(1, Vec3(-0.5F, 0, 0)), box(Vec3(0.8F), Vec3(0.5F, 0, 0))}}}, strip).passed());
  const LevelCheck apart = check({Level{{sphere(0.9F, Vec3(-1, 0, 0)), sphere(0.9F, Vec3(1, 0, 0))}}}, strip);
  EXPECT_FALSE(apart.passed());
  EXPECT_NEAR(apart.mesh->worst->distance, std::hypot(1.0, 0.3) - 0.9, 1e-3);
}

TEST(LevelCheck, HandlesDegenerateTriangles) {
  const Level level{{box(Vec3(1.0F))}};
  EXPECT_TRUE(check({level}, triangle(Vec3(0.5F), Vec3(0.5F), Vec3(0.5F))).passed());
  const LevelCheck point = check({level}, triangle(Vec3(2, 0, 0), Vec3(2, 0, 0), Vec3(2, 0, 0)));
  EXPECT_FALSE(point.passed());
  EXPECT_NEAR(point.mesh->worst->distance, 1.0, 1e-6);
  const LevelCheck line = check({level}, triangle(Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(1, 0, 0)));
  EXPECT_NEAR(line.mesh->worst->distance, 2.0, 1e-6);
}

/// A ring of hulls whose mesh touches every one of them.
struct Ring {
  static constexpr std::uint32_t kSegments = 24;
  static constexpr std::uint32_t kAround = 12;

  Ring() {
    for (std::uint32_t i = 0; i < kSegments; ++i) {
      for (std::uint32_t k = 0; k < kAround; ++k) mesh.vertices.push_back(at(i, k, 0.3F));
    }
    for (std::uint32_t i = 0; i < kSegments; ++i) {
      const std::uint32_t next = (i + 1) % kSegments;
      std::vector<Vec3> corners;
      for (std::uint32_t k = 0; k < kAround; ++k) {
        const std::uint32_t beside = (k + 1) % kAround;
        mesh.triangles.push_back({i * kAround + k, next * kAround + k, next * kAround + beside});
        mesh.triangles.push_back({i * kAround + k, next * kAround + beside, i * kAround + beside});
        corners.push_back(mesh.vertices[i * kAround + k]);
        corners.push_back(mesh.vertices[next * kAround + k]);
      }
      level.parts.push_back(hull(corners));
    }
  }

  static Vec3 at(std::uint32_t segment, std::uint32_t step, float radius) {
    const float a = 6.2831853F * static_cast<float>(segment) / static_cast<float>(kSegments);
    const float b = 6.2831853F * static_cast<float>(step) / static_cast<float>(kAround);
    const float reach = 1.0F + radius * std::cos(b);
    return {reach * std::cos(a), radius * std::sin(b), reach * std::sin(a)};
  }

  SurfaceMesh mesh;
  Level level;
};

TEST(LevelCheck, FindsOneMovedVertexAnywhere) {
  const Ring ring;
  ASSERT_TRUE(check({ring.level}, ring.mesh).passed());
  // 0.1 % of the size, which is the diagonal of 2.6 by 0.6 by 2.6.
  const float out = 0.001F * std::sqrt(2.6F * 2.6F * 2.0F + 0.6F * 0.6F);
  for (std::uint32_t vertex = 0; vertex < Ring::kSegments * Ring::kAround; vertex += 5) {
    SurfaceMesh moved = ring.mesh;
    moved.vertices[vertex] = Ring::at(vertex / Ring::kAround, vertex % Ring::kAround, 0.3F + out);
    const LevelCheck result = check({ring.level}, moved);
    ASSERT_EQ(result.mesh->outside, 6U) << vertex;
    EXPECT_LT(glm::length(result.mesh->worst->point - moved.vertices[vertex]), 1e-5F) << vertex;
    EXPECT_GT(result.mesh->worst->distance, 0.9 * static_cast<double>(out)) << vertex;
    EXPECT_LT(result.mesh->worst->distance, 1.01 * static_cast<double>(out)) << vertex;
  }
}

TEST(LevelCheck, FindsACornerMissingFromAnyPart) {
  const Ring ring;
  for (std::size_t part = 0; part < ring.level.parts.size(); ++part) {
    Level broken = ring.level;
    auto& vertices = std::get<ConvexHull>(broken.parts[part].shape).vertices;
    // The outermost corner, moved inward by 0.1 % of the size.
    vertices[0] *= 1.0F - 0.0037F / glm::length(vertices[0]);
    EXPECT_FALSE(check({broken}, ring.mesh).passed()) << part;
  }
}

TEST(LevelCheck, ChecksEachLevelAgainstTheCoarserOne) {
  const std::vector<Level> nested{Level{{box(Vec3(3.0F))}},
                                  Level{{box(Vec3(1.0F), Vec3(-1, 0, 0)), box(Vec3(1.0F), Vec3(1, 0, 0))}},
                                  Level{{box(Vec3(1.5F, 0.5F, 0.5F))}}};
  const auto result = checkLevels(nested, 0.02F, nullptr);
  ASSERT_TRUE(result.has_value());
  EXPECT_TRUE(result->passed());
  EXPECT_FALSE(result->mesh.has_value());
  ASSERT_EQ(result->levels.size(), 2U);
  EXPECT_EQ(result->levels[0].count, 2U);
  EXPECT_NEAR(result->levels[0].clearance, 1.0, 1e-9);
  EXPECT_EQ(result->levels[1].shared, 1U);
}

TEST(LevelCheck, NamesThePartThatSticksOut) {
  const std::vector<Level> levels{Level{{box(Vec3(1.0F))}},
                                  Level{{sphere(0.5F), sphere(0.7F, Vec3(0.5F, 0, 0))}}};
  const auto result = checkLevels(levels, 0.0F, nullptr);
  ASSERT_TRUE(result.has_value());
  EXPECT_FALSE(result->passed());
  EXPECT_EQ(result->levels[0].outside, 1U);
  EXPECT_EQ(result->levels[0].worst->index, 1U);
  EXPECT_NEAR(result->levels[0].worst->distance, 0.2, 0.01);
}

TEST(LevelCheck, CountsMarginsBetweenLevelsOnly) {
  const Level fine{{boxHull(Vec3(1.0F))}};
  const SurfaceMesh mesh = boxMesh(Vec3(1.0F));
  EXPECT_TRUE(check({Level{{box(Vec3(1.03F))}}, fine}, mesh, 0.02F).passed());
  const LevelCheck tight = check({Level{{box(Vec3(1.0F))}}, fine}, mesh, 0.02F);
  EXPECT_FALSE(tight.passed());
  EXPECT_NEAR(tight.levels[0].worst->distance, 0.02, 2e-3);
  // Two hulls have the same margin.
  EXPECT_TRUE(check({Level{{boxHull(Vec3(1.0F))}}, fine}, mesh, 0.02F).passed());
  // The mesh may not use the margin of the finest level.
  EXPECT_FALSE(check({fine}, boxMesh(Vec3(1.01F)), 0.02F).passed());
}

TEST(LevelCheck, TakesATolerance) {
  const SurfaceMesh mesh = boxMesh(Vec3(1.001F));
  EXPECT_FALSE(check({Level{{box(Vec3(1.0F))}}}, mesh).passed());
  EXPECT_TRUE(check({Level{{box(Vec3(1.0F))}}}, mesh, 0.0F, {.tolerance = 0.002}).passed());
  EXPECT_TRUE(check({Level{{box(Vec3(1.0F))}}}, boxMesh(Vec3(1.0F)), 0.0F, {.tolerance = 0.0}).passed());
}

/// Random levels: every triangle of random points in a part passes, every one with a corner far out fails.
TEST(LevelCheck, AgreesWithRandomTriangles) {
  Random random(7);
  for (int round = 0; round < 40; ++round) {
    Level level;
    for (int i = 0; i < 6; ++i)
      level.parts.push_back(random.ellipsoidHull(14, Vec3(0.8F, 0.5F, 0.4F), random.inBox(Vec3(1.5F))));
    const ConvexPart& part = level.parts[static_cast<std::size_t>(round % 6)];
    const auto& corners = std::get<ConvexHull>(part.shape).vertices;
    const auto within = [&] {
      const float share = random.uniform(0.0F, 1.0F);
      const auto pick = [&] { return static_cast<std::size_t>(random.uniform(0.0F, 13.99F)); };
      return part.pose(share * corners[pick()] + (1.0F - share) * corners[pick()]);
    };
    const Vec3 a = within();
    const Vec3 b = within();
    EXPECT_TRUE(check({level}, triangle(a, b, within())).passed());
    const LevelCheck result = check({level}, triangle(a, b, Vec3(50.0F)));
    EXPECT_FALSE(result.passed());
    EXPECT_GT(result.mesh->worst->distance, 80.0);
  }
}

TEST(LevelCheck, RefusesWhatItCannotCheck) {
  const auto message = [](const std::vector<Level>& levels, const SurfaceMesh& mesh, float margin,
                          double tolerance) {
    const auto result = checkLevels(levels, margin, &mesh, {.tolerance = tolerance});
    return result ? std::string() : result.error().message;
  };
  const Level good{{box(Vec3(1.0F))}};
  const SurfaceMesh mesh = boxMesh(Vec3(1.0F));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(message({}, mesh, 0.0F, 0.0), HasSubstr("no levels"));
  EXPECT_THAT(message({good, Level{}}, mesh, 0.0F, 0.0), HasSubstr("level 2 has no parts"));
  EXPECT_THAT(message({good, Level{{box(Vec3(1.0F)), sphere(-1.0F)}}}, mesh, 0.0F, 0.0),
              HasSubstr("level 2, part 2"));
  EXPECT_THAT(message({Level{{hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}})}}}, mesh, 0.0F, 0.0),
              HasSubstr("one plane"));
  EXPECT_THAT(message({good}, mesh, -1.0F, 0.0), HasSubstr("margin"));
  EXPECT_THAT(message({good}, mesh, 0.0F, -1.0), HasSubstr("tolerance"));
  EXPECT_THAT(message({good}, triangle(Vec3(nan), Vec3(0.0F), Vec3(1.0F)), 0.0F, 0.0),
              HasSubstr("not finite"));
  EXPECT_THAT(message({good}, SurfaceMesh{{Vec3(0.0F)}, {{0, 0, 1}}}, 0.0F, 0.0), HasSubstr("vertex 1 of 1"));
}

}  // namespace
}  // namespace scatter
