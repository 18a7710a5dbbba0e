#include <gtest/gtest.h>
#include <scatter/levels/build_levels.h>
#include <scatter/levels/measure_levels.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "levels/meshes.h"
#include "levels/nesting.h"
#include "trials.h"

namespace scatter {
namespace {

using namespace testing;  // the meshes

/// The part of the knot with the largest x.
const Bounds kEnd{{0.9F, -9.0F, -9.0F}, {9.0F, 9.0F, 9.0F}};

SurfaceMesh knot() {
  return knotMesh(36, 6);
}

LevelBuildDef withParts(std::vector<int> counts, std::vector<MeshRegion> regions) {
  LevelBuildDef definition;
  definition.partCounts = std::move(counts);
  definition.regions = std::move(regions);
  return definition;
}

MeshRegion region(std::variant<Bounds, std::vector<std::uint32_t>> extent, float weight, bool isKept) {
  return {"end", std::move(extent), weight, isKept};
}

/// Of the finest level: in the region, and elsewhere.
std::vector<GapFigures> gapsOf(const BuiltLevels& built, const SurfaceMesh& mesh, const MeshRegion& where) {
  const auto measures = measureLevels(*built.levels, mesh, {.regions = {where}});
  EXPECT_TRUE(measures.has_value());
  return measures->levels.back().regionGaps;
}

std::vector<GapFigures> gapsWith(const SurfaceMesh& mesh, const std::vector<MeshRegion>& regions) {
  const auto built = buildLevels(mesh, withParts({1, 16}, regions));
  EXPECT_TRUE(built.has_value());
  expectNested(*built->levels, mesh);
  EXPECT_EQ(built->levels->finest().parts.size(), 16U);
  return gapsOf(*built, mesh, region(kEnd, 1.0F, false));
}

TEST(MeshRegions, AreCloserWithAsManyParts) {
  if (test::kSanitized) GTEST_SKIP() << "builds as other tests do";
  // Fine enough for weights to show in the mean.
  const SurfaceMesh mesh = knotMesh(48, 8);
  std::vector<std::uint32_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0U);
  const std::vector<GapFigures> plain = gapsWith(mesh, {});
  // Of several weights the largest counts.
  const std::vector<GapFigures> heavy = gapsWith(mesh, {region(all, 1.0F, false), region(kEnd, 8.0F, false)});
  const std::vector<GapFigures> kept = gapsWith(mesh, {region(kEnd, kKeptWeight, true)});
  const std::vector<GapFigures> light = gapsWith(mesh, {region(kEnd, 0.1F, false)});
  EXPECT_LT(heavy[0].p95, 0.7 * plain[0].p95);
  EXPECT_LT(kept[0].p95, 0.7 * plain[0].p95);
  EXPECT_LT(kept[0].mean, 0.7 * plain[0].mean);
  EXPECT_GT(kept[1].mean, plain[1].mean);
  EXPECT_GT(light[0].mean, plain[0].mean);
  EXPECT_LT(light[1].mean, plain[1].mean);
}

/// Five cubes of 1 in a row, 1.5 apart.
SurfaceMesh row() {
  SurfaceMesh mesh;
  for (int i = 0; i < 5; ++i)
    mesh = joined(mesh, boxMesh(Vec3(0.5F), Vec3(1.5F * static_cast<float>(i), 0.0F, 0.0F)));
  return mesh;
}

/// Whether a cube has a part of its own.
bool isAlone(int cube, const Level& level) {
  const double x = 1.5 * cube;
  return std::any_of(level.parts.begin(), level.parts.end(), [x](const ConvexPart& part) {
    const PartOutside outside(part);
    const auto isInside = [&outside](double at) { return outside({{at, 0.0, 0.0}}) < 0.0; };
    return isInside(x) && !isInside(x - 0.6) && !isInside(x + 0.6);
  });
}

TEST(MeshRegions, AKeptOneIsNotMergedWhilePartsLast) {
  const SurfaceMesh mesh = row();
  std::vector<std::uint32_t> second;
  for (std::uint32_t i = 12; i < 24; ++i) second.push_back(i);
  const MeshRegion kept = region(second, 1.0F, true);
  const auto plain = buildLevels(mesh, withParts({1, 2}, {}));
  ASSERT_TRUE(plain.has_value()) << plain.error().message;
  const auto apart = buildLevels(mesh, withParts({1, 2, 4}, {kept}));
  ASSERT_TRUE(apart.has_value()) << apart.error().message;
  expectNested(*apart->levels, mesh);
  EXPECT_FALSE(isAlone(1, plain->levels->level(2)));
  EXPECT_TRUE(isAlone(1, apart->levels->level(2)));
  EXPECT_TRUE(isAlone(1, apart->levels->level(3)));
}

TEST(MeshRegions, TooFewPartsForAllThatIsKeptAreNoted) {
  const SurfaceMesh mesh = row();
  std::vector<MeshRegion> regions;
  for (std::uint32_t cube = 0; cube < 3; ++cube) {
    std::vector<std::uint32_t> triangles;
    for (std::uint32_t i = 0; i < 12; ++i) triangles.push_back(12 * cube + i);
    regions.push_back(region(triangles, 1.0F, true));
  }
  const auto built = buildLevels(mesh, withParts({1, 3}, regions));
  ASSERT_TRUE(built.has_value()) << built.error().message;
  EXPECT_NE(
      std::find(built->notes.begin(), built->notes.end(), "3 parts do not suffice to keep all regions apart"),
      built->notes.end());
  const auto enough = buildLevels(mesh, withParts({1, 4}, regions));
  ASSERT_TRUE(enough.has_value());
  for (const int cube : {0, 1, 2}) EXPECT_TRUE(isAlone(cube, enough->levels->finest())) << cube;
}

TEST(MeshRegions, TheFinestGapIsSmallerByTheWeight) {
  if (test::kSanitized) GTEST_SKIP() << "builds as other tests do";
  const SurfaceMesh mesh = knot();
  LevelBuildDef definition;
  definition.finestGap = GapLimit{{}, 0.06F};
  const MeshRegion heavy = region(kEnd, 3.0F, false);
  definition.regions = {heavy};
  const auto built = buildLevels(mesh, definition);
  ASSERT_TRUE(built.has_value()) << built.error().message;
  const std::vector<GapFigures> gaps = gapsOf(*built, mesh, heavy);
  const double limit = 0.06 * measureLevels(*built->levels, mesh)->diagonal;
  EXPECT_LE(gaps[0].max, 1.05 * limit / 3.0);
  EXPECT_LE(gaps[1].max, 1.05 * limit);
  EXPECT_GT(gaps[1].max, 1.5 * gaps[0].max);
}

TEST(MeshRegions, TheSameRegionsGiveTheSameBits) {
  if (test::kSanitized) GTEST_SKIP() << "builds as other tests do";
  const SurfaceMesh mesh = knot();
  LevelBuildDef definition = withParts({1, 12}, {region(kEnd, kKeptWeight, true)});
  const auto first = buildLevels(mesh, definition);
  const auto second = buildLevels(mesh, definition);
  ASSERT_TRUE(first.has_value() && second.has_value());
  for (int level = 1; level <= 2; ++level)
    EXPECT_TRUE(haveSameBits(first->levels->level(level), second->levels->level(level)));
  // Grouped as very large meshes are, too.
  definition.maxTriangles = 500;
  const auto grouped = buildLevels(mesh, definition);
  ASSERT_TRUE(grouped.has_value()) << grouped.error().message;
  expectNested(*grouped->levels, mesh);
}

TEST(MeshRegions, SheetsAndUnconnectedTrianglesHaveThemToo) {
  const Bounds half{{-9.0F, -9.0F, -9.0F}, {0.3F, 9.0F, 9.0F}};
  for (const SurfaceMesh& mesh : {sheetMesh(12), soupMesh(5, 1100, 0.05F)}) {
    const auto built = buildLevels(mesh, withParts({1, 4, 12}, {region(half, kKeptWeight, true)}));
    ASSERT_TRUE(built.has_value()) << built.error().message;
    expectNested(*built->levels, mesh);
  }
}

TEST(MeshRegions, FlatOnesGetBoxesThatFilesTake) {
  const SurfaceMesh mesh = boxMesh(Vec3(1.0F, 0.5F, 0.8F));
  const Bounds top{{-9.0F, 0.49F, -9.0F}, {9.0F, 9.0F, 9.0F}};
  const auto built = buildLevels(mesh, withParts({1, 2}, {region(top, 1.0F, true)}));
  ASSERT_TRUE(built.has_value());
  expectNested(*built->levels, mesh);
  float thinnest = 1.0F;
  for (const ConvexPart& part : built->levels->finest().parts) {
    const auto* box = std::get_if<Box>(&part.shape);
    ASSERT_NE(box, nullptr);
    thinnest = std::min({thinnest, box->halfExtents.x, box->halfExtents.y, box->halfExtents.z});
  }
  // A micrometre, half of what glTF has as the size.
  EXPECT_GE(static_cast<double>(thinnest), 1e-6);
  EXPECT_LT(thinnest, 1.01e-6F);
}

std::string refusalOf(const MeshRegion& wrong) {
  const auto built = buildLevels(row(), withParts({1, 2}, {wrong}));
  return built ? "" : built.error().message;
}

TEST(MeshRegions, WrongOnesGetOneLine) {
  EXPECT_EQ(
      refusalOf(region(Bounds{Vec3(9.0F), Vec3(10.0F)}, 1.0F, true)),
      "region \"end\": has nothing of the mesh, which reaches from (-0.5, -0.5, -0.5) to (6.5, 0.5, 0.5) m");
  EXPECT_EQ(refusalOf(region(std::vector<std::uint32_t>{60}, 1.0F, true)),
            "region \"end\": triangle 61 is none of the mesh's 60");
  EXPECT_NE(refusalOf(region(std::vector<std::uint32_t>{}, 1.0F, true)).find("has nothing"),
            std::string::npos);
  EXPECT_EQ(refusalOf(region(kEnd, 0.0F, false)), "region \"end\": a weight must be 0.01 to 100, not 0");
  const float none = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NE(refusalOf(region(kEnd, none, false)).find("weight"), std::string::npos);
  EXPECT_NE(refusalOf(region(Bounds{Vec3(none), Vec3(1.0F)}, 1.0F, false)).find("no numbers"),
            std::string::npos);
  const auto many =
      buildLevels(row(), withParts({1, 2}, std::vector<MeshRegion>(65, region(kEnd, 1.0F, false))));
  ASSERT_FALSE(many.has_value());
  EXPECT_NE(many.error().message.find("64 are the most"), std::string::npos);
}

}  // namespace
}  // namespace scatter
