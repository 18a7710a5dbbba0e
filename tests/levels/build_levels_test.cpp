#include <gtest/gtest.h>
#include <scatter/levels/build_levels.h>
#include <scatter/levels/measure_levels.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "levels/meshes.h"
#include "levels/nesting.h"
#include "levels/part_geometry.h"
#include "trials.h"

namespace scatter {
namespace {

using namespace testing;  // the meshes

LevelBuildDef withCounts(std::vector<int> counts) {
  LevelBuildDef definition;
  definition.partCounts = std::move(counts);
  return definition;
}

std::string errorOf(const SurfaceMesh& mesh, const LevelBuildDef& definition = {}) {
  const auto built = buildLevels(mesh, definition);
  return built ? "" : built.error().message;
}

bool hasNote(const BuiltLevels& built, std::string_view text) {
  return std::any_of(built.notes.begin(), built.notes.end(),
                     [&](const std::string& note) { return note.find(text) != std::string::npos; });
}

struct NamedMesh {
  const char* name;
  std::function<SurfaceMesh()> make;
  MeshInterior interior = MeshInterior::kAutomatic;
};

class BuildLevelsTorture : public ::testing::TestWithParam<NamedMesh> {};

TEST_P(BuildLevelsTorture, EnclosesTheMeshAndNests) {
  const SurfaceMesh mesh = GetParam().make();
  LevelBuildDef definition;
  definition.levels = test::kSanitized ? 3 : 6;
  definition.finestParts = 24;
  definition.interior = GetParam().interior;
  const auto built = buildLevels(mesh, definition);
  ASSERT_TRUE(built.has_value()) << built.error().message;
  expectNested(*built->levels, mesh);
  EXPECT_EQ(built->levels->coarsest().parts.size(), 1U);
  EXPECT_LE(built->levels->count(), definition.levels);
}

INSTANTIATE_TEST_SUITE_P(
    Meshes, BuildLevelsTorture,
    ::testing::Values(
        NamedMesh{"Sphere", [] { return sphereMesh(test::kSanitized ? 14 : 20); }},
        NamedMesh{"Torus", [] { return torusMesh(24, 12); }},
        NamedMesh{"Knot", [] { return knotMesh(64, 10); }},
        NamedMesh{"Box", [] { return boxMesh(Vec3(1.0F)); }},
        NamedMesh{"ThinPlate", [] { return boxMesh(Vec3(1.0F, 2.0F, 1e-5F)); }},
        NamedMesh{"Needle", [] { return boxMesh(Vec3(1e-5F, 2.0F, 1e-5F)); }},
        NamedMesh{"Wire", [] { return wireMesh(); }}, NamedMesh{"Sheet", [] { return sheetMesh(); }},
        NamedMesh{"Flat", [] { return flatMesh(); }},
        NamedMesh{"OpenCylinder", [] { return openCylinderMesh(); }},
        NamedMesh{"Soup", [] { return soupMesh(1, 200); }},
        NamedMesh{"Dust", [] { return soupMesh(2, 1500, 1e-4F); }},
        NamedMesh{"Shells", [] { return shellsMesh(); }},
        NamedMesh{"InsideOut", [] { return insideOut(torusMesh(16, 8)); }, MeshInterior::kSolid},
        NamedMesh{"Room", [] { return roomMesh(); }, MeshInterior::kSurface},
        NamedMesh{"Unwelded", [] { return unwelded(torusMesh(16, 8)); }},
        NamedMesh{"Tiny", [] { return moved(torusMesh(16, 8), 1e-4F, Vec3(0.0F)); }},
        NamedMesh{"Huge", [] { return moved(torusMesh(16, 8), 1e7F, Vec3(0.0F)); }},
        NamedMesh{"FarAway", [] { return moved(torusMesh(16, 8), 1.0F, Vec3(20000.0F, -3000.0F, 7e4F)); }},
        NamedMesh{"OneTriangle", [] { return soupMesh(3, 1); }}),
    [](const auto& each) { return each.param.name; });

TEST(BuildLevels, GivesThePartsAskedFor) {
  const auto built = buildLevels(knotMesh(40, 8), withCounts({1, 5, 20, 40}));
  ASSERT_TRUE(built.has_value()) << built.error().message;
  ASSERT_EQ(built->levels->count(), 4);
  EXPECT_EQ(built->levels->level(1).parts.size(), 1U);
  EXPECT_EQ(built->levels->level(2).parts.size(), 5U);
  EXPECT_EQ(built->levels->level(3).parts.size(), 20U);
  EXPECT_EQ(built->levels->level(4).parts.size(), 40U);
}

TEST(BuildLevels, KeepsHullsSmall) {
  if (test::kSanitized) GTEST_SKIP() << "builds as other tests do";
  for (const int most : {8, 24}) {
    LevelBuildDef definition = withCounts({1, 4, 16});
    definition.maxVertices = most;
    const auto built = buildLevels(knotMesh(40, 8), definition);
    ASSERT_TRUE(built.has_value()) << built.error().message;
    for (int level = 1; level <= 3; ++level) {
      for (const ConvexPart& part : built->levels->level(level).parts) {
        if (const auto* hull = std::get_if<ConvexHull>(&part.shape)) {
          EXPECT_LE(hull->vertices.size(), static_cast<std::size_t>(most));
        }
      }
    }
  }
}

TEST(BuildLevels, AConvexMeshNeedsOnePart) {
  const auto built = buildLevels(boxMesh(Vec3(1.0F, 0.5F, 2.0F)), {});
  ASSERT_TRUE(built.has_value()) << built.error().message;
  EXPECT_EQ(built->levels->count(), 1);
  EXPECT_EQ(built->levels->finest().parts.size(), 1U);
  EXPECT_TRUE(hasNote(*built, "levels made"));
}

TEST(BuildLevels, BoxesBecomeBoxesAndBallsBalls) {
  if (test::kSanitized) GTEST_SKIP() << "builds as other tests do";
  const auto box = buildLevels(boxMesh(Vec3(1.0F, 0.5F, 2.0F), Vec3(0.3F, 0.0F, 0.0F)), {});
  ASSERT_TRUE(box.has_value()) << box.error().message;
  const ConvexPart& part = box->levels->finest().parts.front();
  ASSERT_TRUE(std::holds_alternative<Box>(part.shape));
  const Vec3 half = std::get<Box>(part.shape).halfExtents;
  EXPECT_NEAR(half.x * half.y * half.z, 1.0F, 1e-4F);
  EXPECT_NEAR(part.pose.position.x, 0.3F, 1e-5F);

  const SurfaceMesh ballMesh = sphereMesh(16);
  const auto ball = buildLevels(ballMesh, withCounts({1}));
  ASSERT_TRUE(ball.has_value()) << ball.error().message;
  const auto* sphere = std::get_if<Sphere>(&ball->levels->finest().parts.front().shape);
  ASSERT_NE(sphere, nullptr);
  EXPECT_NEAR(sphere->radius, 1.0F, 0.01F);

  LevelBuildDef hullsOnly = withCounts({1});
  hullsOnly.fitPrimitives = false;
  const auto hull = buildLevels(ballMesh, hullsOnly);
  ASSERT_TRUE(hull.has_value()) << hull.error().message;
  EXPECT_TRUE(std::holds_alternative<ConvexHull>(hull->levels->finest().parts.front().shape));
}

/// Turned and moved, as one finds it in a model.
SurfaceMesh placed(SurfaceMesh mesh, const Transform& pose) {
  for (Vec3& vertex : mesh.vertices) vertex = pose(vertex);
  return mesh;
}

TEST(BuildLevels, RoundBarsBecomeOneCylinder) {
  if (test::kSanitized) GTEST_SKIP() << "builds as other tests do";
  Random random(8);
  for (int round = 0; round < 2; ++round) {
    const std::uint32_t sides = 36 + static_cast<std::uint32_t>(random.uniform(0.0F, 8.0F));
    // As wide as long, too, and flat.
    const float radius = random.uniform(0.1F, 1.0F);
    const float half = round % 2 == 0 ? radius : random.uniform(0.1F, 2.0F);
    const Transform pose{random.inBox(Vec3(3.0F)), random.rotation()};
    const SurfaceMesh mesh = placed(prismMesh(sides, radius, -half, half), pose);
    const auto built = buildLevels(mesh, {});
    ASSERT_TRUE(built.has_value()) << built.error().message;
    expectNested(*built->levels, mesh);
    ASSERT_EQ(built->levels->finest().parts.size(), 1U) << "round " << round;
    const ConvexPart& part = built->levels->finest().parts.front();
    const auto* cylinder = std::get_if<Cylinder>(&part.shape);
    ASSERT_NE(cylinder, nullptr) << "round " << round;
    EXPECT_NEAR(cylinder->radius, radius, 0.002F * radius);
    EXPECT_NEAR(cylinder->halfHeight, half, 0.002F * (radius + half));
    EXPECT_GT(std::abs(glm::dot(part.pose.rotation * Vec3(0.0F, 1.0F, 0.0F),
                                pose.rotation * Vec3(0.0F, 1.0F, 0.0F))),
              0.9999F);
  }
}

// Where a gap is asked for, a cylinder around a prism of few sides is not near enough.
TEST(BuildLevels, ACylinderKeepsTheGapToo) {
  if (test::kSanitized) GTEST_SKIP() << "builds as other tests do";
  const SurfaceMesh mesh = prismMesh(12, 0.5F, -1.0F, 1.0F);
  LevelBuildDef definition;
  definition.finestGap = GapLimit{0.02F, {}};
  const auto loose = buildLevels(mesh, definition);
  ASSERT_TRUE(loose.has_value()) << loose.error().message;
  EXPECT_TRUE(std::holds_alternative<Cylinder>(loose->levels->finest().parts.front().shape));
  definition.finestGap = GapLimit{0.01F, {}};
  const auto close = buildLevels(mesh, definition);
  ASSERT_TRUE(close.has_value()) << close.error().message;
  EXPECT_GT(close->levels->finest().parts.size(), 1U);
}

// Around cylinders of a finer level, coarser parts are no wider than the prisms by which they are judged.
TEST(BuildLevels, CoarserPartsHoldCylinders) {
  const SurfaceMesh mesh = joined(prismMesh(20, 0.4F, -0.05F, 0.05F, Vec3(0.5F, 0.0F, 0.0F)),
                                  prismMesh(20, 0.1F, -1.0F, 1.0F, Vec3(-0.5F, 0.0F, 0.0F)));
  const auto built = buildLevels(mesh, withCounts({1, 2}));
  ASSERT_TRUE(built.has_value()) << built.error().message;
  expectNested(*built->levels, mesh);
  for (const ConvexPart& part : built->levels->finest().parts)
    EXPECT_TRUE(std::holds_alternative<Cylinder>(part.shape));
}

TEST(BuildLevels, PrimitivesHoldTheMarginsOfFinerHulls) {
  // A slab of two halves with a slit: the coarsest part is a box around hulls with a large margin.
  const SurfaceMesh mesh = joined(boxMesh(Vec3(1.0F, 0.5F, 0.4F), Vec3(-1.05F, 0.0F, 0.0F)),
                                  sphereMesh(24, 0.5F, Vec3(0.6F, 0.0F, 0.0F)));
  LevelBuildDef definition = withCounts({1, 2, 6});
  definition.hullMargin = 0.1F;
  const auto built = buildLevels(mesh, definition);
  ASSERT_TRUE(built.has_value()) << built.error().message;
  expectNested(*built->levels, mesh);
}

TEST(BuildLevels, TheFinestGapIsKept) {
  const SurfaceMesh mesh = torusMesh(32, 16);
  std::size_t last = 0;
  for (const float gap : test::trials<float>({0.06F, 0.02F})) {
    LevelBuildDef definition;
    definition.finestGap = GapLimit{{}, gap};
    const auto built = buildLevels(mesh, definition);
    ASSERT_TRUE(built.has_value()) << built.error().message;
    const auto measures = measureLevels(*built->levels, mesh);
    ASSERT_TRUE(measures.has_value());
    EXPECT_LE(measures->levels.back().maxGap, 1.03 * static_cast<double>(gap) * measures->diagonal);
    EXPECT_GT(built->levels->finest().parts.size(), last);
    last = built->levels->finest().parts.size();
  }
}

TEST(BuildLevels, AGapBelowTheMarginIsRefused) {
  LevelBuildDef definition;
  definition.hullMargin = 0.02F;
  definition.finestGap = GapLimit{0.015F, {}};
  EXPECT_EQ(errorOf(torusMesh(32, 16), definition),
            "a gap of 0.015 m cannot be kept with a hull margin of 0.02 m, which counts in it: give a "
            "smaller margin or "
            "a larger gap");
}

TEST(BuildLevels, TheMarginIsSmallBesideTheMeshAndTheGap) {
  if (test::kSanitized) GTEST_SKIP() << "builds as other tests do";
  const SurfaceMesh mesh = torusMesh(24, 12);
  const auto built = buildLevels(mesh, withCounts({1, 6, 24}));
  ASSERT_TRUE(built.has_value()) << built.error().message;
  EXPECT_NEAR(static_cast<double>(built->levels->hullMargin()), 5e-4 * 3.72, 2e-5);
  const auto large = buildLevels(moved(mesh, 100.0F, Vec3(0.0F)), withCounts({1, 6, 24}));
  ASSERT_TRUE(large.has_value()) << large.error().message;
  EXPECT_FLOAT_EQ(large->levels->hullMargin(), 0.02F);
}

TEST(BuildLevels, SameInputSameBits) {
  if (test::kSanitized) GTEST_SKIP() << "builds as other tests do";
  const SurfaceMesh mesh = torusMesh(16, 8);
  const LevelBuildDef definition = withCounts({1, 4, 16});
  const auto first = buildLevels(mesh, definition);
  const auto second = buildLevels(mesh, definition);
  ASSERT_TRUE(first.has_value() && second.has_value());
  for (int level = 1; level <= first->levels->count(); ++level) {
    EXPECT_TRUE(haveSameBits(first->levels->level(level), second->levels->level(level))) << "level " << level;
  }
}

TEST(BuildLevels, OrderOfTrianglesNeverBreaksContainment) {
  // Another order of the triangles breaks ties another way, and so merges in another order.
  Random random(7);
  SurfaceMesh mesh = knotMesh(40, 8);
  for (int round = 0; round < test::trials(4); ++round) {
    for (std::size_t i = mesh.triangles.size() - 1; i > 0; --i) {
      const auto other = static_cast<std::size_t>(random.uniform(0.0F, static_cast<float>(i)));
      std::swap(mesh.triangles[i], mesh.triangles[other]);
    }
    const auto built = buildLevels(mesh, withCounts({1, 4, 16}));
    ASSERT_TRUE(built.has_value()) << built.error().message;
    expectNested(*built->levels, mesh);
  }
}

TEST(BuildLevels, RandomMeshesNest) {
  for (const std::uint64_t seed : test::seeds(10, 12)) {
    const SurfaceMesh mesh = soupMesh(seed, 1 + static_cast<std::uint32_t>(seed * seed % 97), 0.5F);
    const auto built = buildLevels(mesh, withCounts({1, 3, 7, 20}));
    ASSERT_TRUE(built.has_value()) << "seed " << seed << ": " << built.error().message;
    expectNested(*built->levels, mesh);
  }
}

TEST(BuildLevels, TurnsShellsAndLeavesCavities) {
  const auto built = buildLevels(shellsMesh(), withCounts({1, 8}));
  ASSERT_TRUE(built.has_value());
  EXPECT_TRUE(built->isSolid);
  EXPECT_TRUE(hasNote(*built, "1 inside-out shell"));
}

/// Whether some part of the level reaches the point, by its bounds in all directions that are tried.
bool fills(const Level& level, const Vec3& point) {
  Random random(5);
  std::vector<glm::dvec3> directions;
  for (int i = 0; i < 200; ++i) directions.emplace_back(random.direction());
  return std::any_of(level.parts.begin(), level.parts.end(), [&](const ConvexPart& part) {
    return std::all_of(directions.begin(), directions.end(), [&](const glm::dvec3& direction) {
      return levels::support(part, 0.0, direction) >= glm::dot(direction, glm::dvec3(point));
    });
  });
}

TEST(BuildLevels, ARoomSeenFromWithinIsAskedAbout) {
  EXPECT_EQ(errorOf(roomMesh()),
            "the mesh is inside out, like a room that is seen from within: say whether its interior is "
            "solid, which turns "
            "it, or a surface, which keeps it open");
  // A sheet has no inside to be turned out.
  EXPECT_EQ(errorOf(insideOut(levelSheet())), "");
}

TEST(BuildLevels, ARoomStaysOpenWhenItsInteriorIsASurface) {
  for (const SurfaceMesh& mesh : {roomMesh(), insideOut(roomMesh())}) {
    LevelBuildDef definition = withCounts({1, 8, 32});
    definition.interior = MeshInterior::kSurface;
    const auto built = buildLevels(mesh, definition);
    ASSERT_TRUE(built.has_value()) << built.error().message;
    for (const Vec3& inside : {Vec3(0.0F), Vec3(-1.5F, 0.8F, 1.2F), Vec3(1.0F, 0.5F, -1.0F)}) {
      EXPECT_FALSE(fills(built->levels->finest(), inside));
      EXPECT_TRUE(fills(built->levels->coarsest(), inside));
    }
    EXPECT_TRUE(fills(built->levels->finest(), {2.5F, 0.3F, 0.2F}));
    const auto measures = measureLevels(*built->levels, mesh, {.interior = MeshInterior::kSurface});
    ASSERT_TRUE(measures.has_value()) << measures.error().message;
    // The plates' rims; and the middle of a room that is filled.
    EXPECT_LT(measures->levels.back().maxGap, static_cast<double>(kSheetThickness));
    EXPECT_GT(measures->levels.front().maxGap, 1.0);
  }
}

TEST(BuildLevels, AClosedHollowIsNotFilled) {
  // The walls of a room, 0.1 thick: nothing of its outside tells that there is one within.
  const SurfaceMesh mesh = joined(boxMesh({2.5F, 1.5F, 2.0F}), insideOut(boxMesh({2.4F, 1.4F, 1.9F})));
  const auto built = buildLevels(mesh, withCounts({1, 6, 24}));
  ASSERT_TRUE(built.has_value()) << built.error().message;
  EXPECT_TRUE(built->isSolid);
  EXPECT_FALSE(fills(built->levels->finest(), Vec3(0.0F)));
  const auto measures = measureLevels(*built->levels, mesh);
  ASSERT_TRUE(measures.has_value()) << measures.error().message;
  EXPECT_LT(measures->levels.back().maxGap, 0.01);
  EXPECT_NEAR(measures->levels.front().maxGap, 1.4, 0.1);
}

TEST(BuildLevels, SaysWhatIsSwallowed) {
  const auto built = buildLevels(joined(boxMesh(Vec3(2.0F)), boxMesh(Vec3(0.3F), {0.5F, -1.7F, 0.0F})), {});
  ASSERT_TRUE(built.has_value()) << built.error().message;
  EXPECT_TRUE(hasNote(*built, "1 of its shells lie inside of others"));
  const auto apart = buildLevels(joined(boxMesh(Vec3(2.0F)), boxMesh(Vec3(0.3F), {2.2F, 0.0F, 0.0F})), {});
  ASSERT_TRUE(apart.has_value()) << apart.error().message;
  EXPECT_FALSE(hasNote(*apart, "inside of others"));
}

TEST(BuildLevels, SheetsAreAsThickAsIsAsked) {
  if (test::kSanitized) GTEST_SKIP() << "builds as other tests do";
  const SurfaceMesh mesh = moved(levelSheet(), 2.0F, Vec3(0.0F));
  for (const std::optional<float> asked :
       {std::optional<float>(), std::optional(0.03F), std::optional(0.0F)}) {
    LevelBuildDef definition = withCounts({1, 8});
    definition.thickness = asked;
    const auto built = buildLevels(mesh, definition);
    ASSERT_TRUE(built.has_value()) << built.error().message;
    const double expected = asked.value_or(0.05F * std::sqrt(8.0F));
    for (const ConvexPart& part : built->levels->finest().parts) {
      const double up = levels::support(part, 0.0, {0.0, 1.0, 0.0});
      const double down = levels::support(part, 0.0, {0.0, -1.0, 0.0});
      EXPECT_NEAR(up, 0.5 * expected, 3e-4);
      EXPECT_NEAR(down, 0.5 * expected, 3e-4);
    }
    EXPECT_EQ(hasNote(*built, "a ball of 3 cm passes through them above"), expected > 0.0);
  }
}

TEST(BuildLevels, ThickPlatesFollowABentSheet) {
  if (test::kSanitized) GTEST_SKIP() << "builds as other tests do";
  // Parts without thickness say how near so many can be.
  const SurfaceMesh mesh = sheetMesh(20);
  LevelBuildDef definition = withCounts({1, 32});
  definition.thickness = 0.0F;
  const auto thin = buildLevels(mesh, definition);
  definition.thickness = 0.1F;
  const auto thick = buildLevels(mesh, definition);
  ASSERT_TRUE(thin && thick);
  EXPECT_EQ(thick->levels->finest().parts.size(), thin->levels->finest().parts.size());
  const auto gapOf = [&](const BuiltLevels& built) {
    return measureLevels(*built.levels, mesh)->levels.back();
  };
  EXPECT_LT(gapOf(*thick).p95Gap, gapOf(*thin).p95Gap + 0.06);
}

TEST(BuildLevels, TakesSheetsAsSurfaces) {
  for (const SurfaceMesh& mesh : {sheetMesh(10), flatMesh(), soupMesh(4, 100)}) {
    const auto built = buildLevels(mesh, withCounts({1, 8}));
    ASSERT_TRUE(built.has_value()) << built.error().message;
    EXPECT_FALSE(built->isSolid);
    EXPECT_TRUE(hasNote(*built, "not closed"));
  }
}

TEST(BuildLevels, GroupsWhatIsTooMuch) {
  const SurfaceMesh mesh = torusMesh(32, 16);
  LevelBuildDef definition = withCounts({1, 8, 32});
  definition.maxTriangles = 600;
  const auto built = buildLevels(mesh, definition);
  ASSERT_TRUE(built.has_value()) << built.error().message;
  EXPECT_TRUE(hasNote(*built, "grouped"));
  expectNested(*built->levels, mesh);
}

TEST(BuildLevels, ReportsProgress) {
  double last = 0.0;
  std::string stages;
  const BuildProgress progress = [&](std::string_view stage, double share) {
    EXPECT_GE(share, 0.0);
    EXPECT_LE(share, 1.0);
    if (!stages.ends_with(stage)) stages += " " + std::string(stage);
    last = share;
  };
  ASSERT_TRUE(buildLevels(torusMesh(16, 8), withCounts({1, 8}), progress).has_value());
  EXPECT_EQ(stages, " shells distances patches merging parts levels check");
}

TEST(BuildLevels, BadMeshesGetOneLine) {
  EXPECT_EQ(errorOf({}), "the mesh has no triangles");
  SurfaceMesh mesh = soupMesh(1, 3);
  mesh.triangles[2][1] = 9;
  EXPECT_EQ(errorOf(mesh), "triangle 3 refers to vertex 10, but the mesh has 9");
  mesh.triangles[2][1] = 7;
  mesh.vertices[7].y = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NE(errorOf(mesh).find("vertex 8 ("), std::string::npos) << errorOf(mesh);
  EXPECT_EQ(errorOf(mesh).find('\n'), std::string::npos);
  mesh.vertices.assign(9, Vec3(1.0F));
  EXPECT_EQ(errorOf(mesh), "all vertices of the mesh are at one point");
  EXPECT_NE(errorOf(moved(boxMesh(Vec3(1.0F)), 1e12F, Vec3(0.0F))).find("scale it"), std::string::npos);
  EXPECT_NE(errorOf(moved(boxMesh(Vec3(1.0F)), 1e-9F, Vec3(0.0F))).find("scale it"), std::string::npos);
}

TEST(BuildLevels, BadDefinitionsGetOneLine) {
  const SurfaceMesh mesh = boxMesh(Vec3(1.0F));
  EXPECT_NE(errorOf(mesh, withCounts({4, 2})).find("increase"), std::string::npos);
  EXPECT_NE(errorOf(mesh, withCounts({0, 2})).find("positive"), std::string::npos);
  EXPECT_NE(errorOf(mesh, withCounts({1, 100000})).find("100000"), std::string::npos);
  LevelBuildDef definition;
  definition.maxVertices = 3;
  EXPECT_NE(errorOf(mesh, definition).find("8 to 64"), std::string::npos);
  definition = {};
  definition.levels = 0;
  EXPECT_NE(errorOf(mesh, definition).find("levels"), std::string::npos);
  definition = {};
  definition.hullMargin = -1.0F;
  EXPECT_NE(errorOf(mesh, definition).find("margin"), std::string::npos);
  definition = {};
  definition.finestGap = GapLimit{0.01F, 0.01F};
  EXPECT_NE(errorOf(mesh, definition).find("either"), std::string::npos);
  definition.finestGap = GapLimit{0.0F, {}};
  EXPECT_NE(errorOf(mesh, definition).find("positive"), std::string::npos);
}

}  // namespace
}  // namespace scatter
