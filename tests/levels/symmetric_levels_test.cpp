#include <gtest/gtest.h>
#include <scatter/levels/build_levels.h>
#include <scatter/levels/level_symmetry.h>
#include <scatter/levels/measure_levels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "levels/meshes.h"
#include "levels/nesting.h"
#include "levels/part_geometry.h"
#include "trials.h"

namespace scatter {
namespace {

using namespace testing;  // the meshes

/// The mesh and its image, in the plane with this coordinate.
SurfaceMesh withMirrorImage(const SurfaceMesh& mesh, int axis, float offset = 0.0F) {
  SurfaceMesh image = insideOut(mesh);
  for (Vec3& vertex : image.vertices) vertex[axis] = 2.0F * offset - vertex[axis];
  return joined(mesh, image);
}

/// A body across the plane, and on either side a wing that enters it, a torus apart and some loose triangles.
SurfaceMesh randomCraft(std::uint64_t seed, int axis) {
  Random random(seed);
  const auto size = [&] { return random.uniform(0.1F, 0.6F); };
  const Vec3 side = random.inBox(Vec3(0.5F)) + Vec3(0.6F);
  const SurfaceMesh wing = boxMesh({size(), size(), size()}, side);
  const SurfaceMesh ring = moved(torusMesh(12, 6), size(), side + random.inBox(Vec3(1.0F)));
  const SurfaceMesh loose = moved(soupMesh(seed, 6), 1.0F, random.inBox(Vec3(0.5F)));
  const SurfaceMesh body = boxMesh({1.0F + size(), size(), size()});
  return joined(body, withMirrorImage(joined(joined(wing, ring), loose), axis));
}

/// The places that span a part, as they are stored.
using Places = std::set<std::array<double, 3>>;

Places placesOf(const ConvexPart& part, int mirroredAxis, double offset) {
  Places places;
  for (glm::dvec3 point : levels::roundedHull(part, 0.0).points) {
    if (mirroredAxis >= 0) point[mirroredAxis] = 2.0 * offset - point[mirroredAxis];
    places.insert({point.x + 0.0, point.y + 0.0, point.z + 0.0});
  }
  return places;
}

/// To the last bit.
void expectExactlySymmetric(const LevelSet& set, const SymmetryPlane& plane) {
  for (int level = 1; level <= set.count(); ++level) {
    std::multiset<Places> parts;
    std::multiset<Places> images;
    for (const ConvexPart& part : set.level(level).parts) {
      parts.insert(placesOf(part, -1, 0.0));
      images.insert(placesOf(part, plane.axis, static_cast<double>(plane.offset)));
    }
    EXPECT_EQ(parts, images) << "level " << level;
  }
}

LevelBuildDef symmetricDef(std::vector<int> counts) {
  LevelBuildDef definition;
  definition.partCounts = std::move(counts);
  definition.symmetry = MeshSymmetry::kRequired;
  return definition;
}

TEST(SymmetricLevels, OfRandomMeshesAreTheirOwnImageAndNest) {
  for (const std::uint64_t seed : test::seeds(1, 4)) {
    const int axis = static_cast<int>(seed % 3);
    SCOPED_TRACE("seed " + std::to_string(seed));
    const SurfaceMesh mesh = randomCraft(seed, axis);
    LevelBuildDef definition = symmetricDef({1, 6, 17});
    definition.fitPrimitives = seed % 2 == 0;
    definition.maxVertices = 6 + 2 * static_cast<int>(seed);
    const auto built = buildLevels(mesh, definition);
    ASSERT_TRUE(built.has_value()) << built.error().message;
    ASSERT_TRUE(built->symmetry.has_value());
    EXPECT_EQ(built->symmetry->axis, axis);
    EXPECT_EQ(built->symmetry->offset, 0.0F);
    expectExactlySymmetric(*built->levels, *built->symmetry);
    EXPECT_EQ(built->levels->mass().centerOfMass[axis], 0.0F);
    EXPECT_EQ(built->levels->mass().inertia[axis][(axis + 1) % 3], 0.0F);
    expectNested(*built->levels, mesh);
    for (int level = 1; level <= built->levels->count(); ++level) {
      const auto& parts = built->levels->level(level).parts;
      EXPECT_LE(parts.size(),
                static_cast<std::size_t>(definition.partCounts.at(static_cast<std::size_t>(level) - 1)));
      for (const ConvexPart& part : parts) {
        if (const auto* hull = std::get_if<ConvexHull>(&part.shape)) {
          EXPECT_LE(hull->vertices.size(), static_cast<std::size_t>(definition.maxVertices));
        }
      }
    }
  }
}

struct SymmetricMeshCase {
  const char* name;
  std::function<SurfaceMesh()> make;
  SymmetryPlane plane;
};

class SymmetricLevelsOf : public ::testing::TestWithParam<SymmetricMeshCase> {};

TEST_P(SymmetricLevelsOf, AreSymmetricAndHoldTheMesh) {
  const SurfaceMesh mesh = GetParam().make();
  const auto built = buildLevels(mesh, symmetricDef({1, 4, 13}));
  ASSERT_TRUE(built.has_value()) << built.error().message;
  ASSERT_TRUE(built->symmetry.has_value());
  EXPECT_EQ(built->symmetry->axis, GetParam().plane.axis);
  EXPECT_NEAR(built->symmetry->offset, GetParam().plane.offset,
              1e-4F * std::max(1.0F, GetParam().plane.offset));
  expectNested(*built->levels, mesh);
  const auto symmetry = symmetryOf(*built->levels);
  ASSERT_TRUE(symmetry.has_value());
  EXPECT_EQ(symmetry->plane.axis, GetParam().plane.axis);
  ASSERT_EQ(symmetry->levels.size(), static_cast<std::size_t>(built->levels->count()));
  for (int level = 1; level <= built->levels->count(); ++level) {
    const auto [pairs, own] = symmetry->levels[static_cast<std::size_t>(level) - 1];
    EXPECT_EQ(static_cast<std::size_t>(2 * pairs + own), built->levels->level(level).parts.size());
  }
}

/// Vertices that an exporter has rounded, or an artist has not quite matched.
SurfaceMesh shaken(SurfaceMesh mesh, float by) {
  Random random(5);
  for (Vec3& vertex : mesh.vertices) vertex += random.inBox(Vec3(by));
  return mesh;
}

INSTANTIATE_TEST_SUITE_P(
    Meshes, SymmetricLevelsOf,
    ::testing::Values(
        SymmetricMeshCase{"BesideZero", [] { return withMirrorImage(knotMesh(18, 5), 0, 3.3F); }, {0, 3.3F}},
        SymmetricMeshCase{"FarAway",
                          [] {
                            const SurfaceMesh half = moved(knotMesh(18, 5), 1.0F, Vec3(0.4F, -300.0F, 7e3F));
                            return withMirrorImage(half, 2, 7001.0F);
                          },
                          {2, 7001.0F}},
        SymmetricMeshCase{
            "Shaken", [] { return shaken(withMirrorImage(knotMesh(18, 5), 2, 1.5F), 1e-4F); }, {2, 1.5F}},
        // Each quadrangle of the bent sheet has its diagonal the same way, and so another way in the mirror.
        SymmetricMeshCase{"OtherDiagonals",
                          [] {
                            return gridMesh(9, 7, false, false, [](std::uint32_t i, std::uint32_t j) {
                              const float x = static_cast<float>(i) / 4.0F - 1.0F;
                              const float y = static_cast<float>(j) / 6.0F;
                              return Vec3(x, y, 0.2F * x * x * y);
                            });
                          },
                          {0, 0.0F}},
        SymmetricMeshCase{"Ball", [] { return sphereMesh(12, 2.0F, Vec3(0.0F, 0.0F, 4.0F)); }, {0, 0.0F}},
        SymmetricMeshCase{"Box", [] { return boxMesh(Vec3(1.0F, 2.0F, 0.5F)); }, {0, 0.0F}},
        SymmetricMeshCase{
            "ApartPieces",
            [] { return withMirrorImage(moved(soupMesh(4, 20), 1.0F, Vec3(0.0F, 9.0F, 0.0F)), 1); },
            {1, 0.0F}},
        SymmetricMeshCase{"InThePlane",
                          [] {
                            return SurfaceMesh{{{0, 0, 0}, {4, 0, 0}, {1, 3, 0}}, {{0, 1, 2}}};
                          },
                          {2, 0.0F}}),
    [](const auto& each) { return each.param.name; });

TEST(SymmetricLevels, AreMadeOfMirrorImagesWhereNothingElseIs) {
  const auto built = buildLevels(withMirrorImage(moved(torusMesh(12, 6), 1.0F, Vec3(3.0F, 0.0F, 0.0F)), 0),
                                 symmetricDef({1, 2, 8}));
  ASSERT_TRUE(built.has_value()) << built.error().message;
  const auto symmetry = symmetryOf(*built->levels);
  ASSERT_TRUE(symmetry.has_value());
  EXPECT_EQ(symmetry->levels[0].own, 1);
  EXPECT_EQ(symmetry->levels[1].pairs, 1);
  EXPECT_EQ(symmetry->levels[2].pairs, 4);
}

TEST(SymmetricLevels, AreOfBallsAndCapsulesAcrossThePlaneToo) {
  // A ball, and a rod that leans forward in the plane.
  const SurfaceMesh ball = sphereMesh(14, 1.0F, Vec3(0.0F, 3.0F, 0.0F));
  SurfaceMesh rod = sphereMesh(14);
  for (Vec3& vertex : rod.vertices) {
    const float along = vertex.y + (vertex.y > 1e-3F ? 1.5F : -1.5F);
    vertex = Vec3(vertex.x, 0.8F * along - 0.6F * vertex.z, 0.6F * along + 0.8F * vertex.z);
  }
  const SurfaceMesh mesh = joined(ball, moved(rod, 1.0F, Vec3(0.0F, -3.0F, 0.0F)));
  const auto built = buildLevels(mesh, symmetricDef({2}));
  ASSERT_TRUE(built.has_value()) << built.error().message;
  ASSERT_EQ(built->symmetry->axis, 0);
  expectExactlySymmetric(*built->levels, *built->symmetry);
  expectNested(*built->levels, mesh);
  const auto& parts = built->levels->finest().parts;
  EXPECT_EQ(std::count_if(parts.begin(), parts.end(),
                          [](const ConvexPart& part) { return std::holds_alternative<Sphere>(part.shape); }),
            1);
  EXPECT_EQ(std::count_if(parts.begin(), parts.end(),
                          [](const ConvexPart& part) { return std::holds_alternative<Capsule>(part.shape); }),
            1);
}

TEST(SymmetricLevels, AreOfCylindersAcrossThePlaneToo) {
  // A roller that leans forward in the plane, and a leg on either side.
  SurfaceMesh roller = prismMesh(20, 0.5F, -2.0F, 2.0F);
  for (Vec3& vertex : roller.vertices)
    vertex = Vec3(vertex.x, 0.8F * vertex.y - 0.6F * vertex.z, 0.6F * vertex.y + 0.8F * vertex.z);
  const SurfaceMesh legs = withMirrorImage(prismMesh(20, 0.2F, -1.0F, 1.0F, Vec3(3.0F, 0.0F, 0.0F)), 0);
  const SurfaceMesh mesh = joined(roller, legs);
  const auto built = buildLevels(mesh, symmetricDef({1, 3}));
  ASSERT_TRUE(built.has_value()) << built.error().message;
  expectExactlySymmetric(*built->levels, *built->symmetry);
  expectNested(*built->levels, mesh);
  for (const ConvexPart& part : built->levels->finest().parts)
    EXPECT_TRUE(std::holds_alternative<Cylinder>(part.shape));
}

TEST(SymmetricLevels, NoTwoHaveAsManyParts) {
  SurfaceMesh mesh = boxMesh(Vec3(0.5F));
  for (const float x : {-4.0F, -2.0F, 2.0F, 4.0F})
    mesh = joined(mesh, boxMesh(Vec3(0.5F), Vec3(x, 0.0F, 0.1F * x * x)));
  const auto built = buildLevels(mesh, symmetricDef({1, 2, 3, 4, 5}));
  ASSERT_TRUE(built.has_value()) << built.error().message;
  ASSERT_EQ(built->levels->count(), 3);
  EXPECT_EQ(built->levels->level(2).parts.size(), 3U);
  EXPECT_EQ(built->levels->level(3).parts.size(), 5U);
  EXPECT_NE(built->notes.back().find("3 of 5 levels made: their parts come in pairs"), std::string::npos);
}

bool haveSamePlaces(const LevelSet& a, const LevelSet& b) {
  if (a.count() != b.count()) return false;
  for (int level = 1; level <= a.count(); ++level) {
    const auto& parts = a.level(level).parts;
    const auto& others = b.level(level).parts;
    const bool same =
        std::equal(parts.begin(), parts.end(), others.begin(), others.end(),
                   [](const auto& x, const auto& y) { return placesOf(x, -1, 0.0) == placesOf(y, -1, 0.0); });
    if (!same) return false;
  }
  return true;
}

TEST(SymmetricLevels, OtherMeshesAreRefusedOrLeftAsTheyAre) {
  // A torus with a box on one side.
  const SurfaceMesh mesh = joined(torusMesh(12, 6), boxMesh(Vec3(0.1F, 0.2F, 0.3F), Vec3(0.9F, 0.5F, 0.3F)));
  LevelBuildDef definition = symmetricDef({1, 8});
  const auto refused = buildLevels(mesh, definition);
  ASSERT_FALSE(refused.has_value());
  EXPECT_NE(refused.error().message.find("not symmetric"), std::string::npos);
  definition.symmetry = MeshSymmetry::kAutomatic;
  const auto automatic = buildLevels(mesh, definition);
  definition.symmetry = MeshSymmetry::kIgnore;
  const auto ignored = buildLevels(mesh, definition);
  ASSERT_TRUE(automatic.has_value() && ignored.has_value());
  EXPECT_FALSE(automatic->symmetry.has_value());
  EXPECT_TRUE(haveSamePlaces(*automatic->levels, *ignored->levels));
}

TEST(SymmetricLevels, AHoleOnOneSideIsNotSymmetric) {
  SurfaceMesh mesh = sphereMesh(12);
  ASSERT_TRUE(buildLevels(mesh, symmetricDef({4})).has_value());
  mesh.triangles.erase(mesh.triangles.begin() + 32, mesh.triangles.begin() + 34);
  EXPECT_FALSE(buildLevels(mesh, symmetricDef({4})).has_value());
}

TEST(SymmetricLevels, AreNotMadeUnasked) {
  LevelBuildDef ignoring;
  ignoring.partCounts = {1, 8};
  const auto built = buildLevels(randomCraft(3, 0), ignoring);
  ASSERT_TRUE(built.has_value());
  EXPECT_TRUE(built->symmetry.has_value());
  EXPECT_FALSE(symmetryOf(*built->levels).has_value());
}

/// Of the finest level: in the box on one side, in its image, and elsewhere.
std::vector<GapFigures> gapsOnBothSides(const BuiltLevels& built, const SurfaceMesh& mesh,
                                        const Bounds& box) {
  Bounds image = box;
  image.min.x = -box.max.x;
  image.max.x = -box.min.x;
  const auto measures = measureLevels(*built.levels, mesh, {.regions = {{"one", box}, {"other", image}}});
  EXPECT_TRUE(measures.has_value());
  return measures->levels.back().regionGaps;
}

TEST(SymmetricLevels, CountRegionsOnBothSides) {
  if (test::kSanitized) GTEST_SKIP() << "builds as other tests do";
  const SurfaceMesh mesh = withMirrorImage(moved(knotMesh(24, 6), 1.0F, Vec3(2.0F, 0.0F, 0.0F)), 0);
  // Behind the middle of the one knot.
  const Bounds end{{0.0F, 0.0F, -9.0F}, {9.0F, 9.0F, 9.0F}};
  LevelBuildDef definition = symmetricDef({1, 24});
  const auto plain = buildLevels(mesh, definition);
  definition.regions = {{"one", end, kKeptWeight, true}};
  const auto kept = buildLevels(mesh, definition);
  ASSERT_TRUE(plain.has_value() && kept.has_value());
  ASSERT_TRUE(kept->symmetry.has_value());
  expectExactlySymmetric(*kept->levels, *kept->symmetry);
  expectNested(*kept->levels, mesh);
  const std::vector<GapFigures> before = gapsOnBothSides(*plain, mesh, end);
  const std::vector<GapFigures> after = gapsOnBothSides(*kept, mesh, end);
  EXPECT_LT(after[0].p95, 0.8 * before[0].p95);
  EXPECT_NEAR(after[0].p95, after[1].p95, 0.05 * after[0].p95);
  EXPECT_GT(after[2].p95, before[2].p95) << "what is nearer here is paid elsewhere";
}

TEST(SymmetricLevels, KeepRegionsOfRandomMeshesApart) {
  for (const std::uint64_t seed : test::seeds(1, 4)) {
    const int axis = static_cast<int>(seed % 3);
    SCOPED_TRACE("seed " + std::to_string(seed));
    const SurfaceMesh mesh = randomCraft(seed, axis);
    Random random(seed);
    // Across the plane, on one side of it, or some triangles anywhere.
    LevelBuildDef definition = symmetricDef({1, 12});
    Bounds box{Vec3(-9.0F), Vec3(9.0F)};
    box.min[axis] = random.uniform(-0.3F, 0.3F);
    definition.regions = {{"box", box, random.uniform(0.1F, 8.0F), seed % 2 == 0},
                          {"triangles", std::vector<std::uint32_t>{3, 30, 50}, 2.0F, true}};
    const auto built = buildLevels(mesh, definition);
    ASSERT_TRUE(built.has_value()) << built.error().message;
    ASSERT_TRUE(built->symmetry.has_value());
    expectExactlySymmetric(*built->levels, *built->symmetry);
    expectNested(*built->levels, mesh);
  }
}

TEST(SymmetryOf, SeesWhatIsOffByLittle) {
  const auto levelsWith = [](float shift, float turn) {
    LevelSetDef set;
    const Quat left(std::cos(0.3F), 0.0F, std::sin(0.3F), 0.0F);
    const Quat right(std::cos(0.3F + turn), 0.0F, -std::sin(0.3F + turn), 0.0F);
    set.levels.push_back({{{Box{{1.0F, 2.0F, 3.0F}}, {Vec3(4.0F, 1.0F, 0.0F), left}},
                           {Box{{1.0F, 2.0F, 3.0F}}, {Vec3(-4.0F, 1.0F + shift, 0.0F), right}},
                           {Capsule{0.5F, 1.0F}, {Vec3(0.0F, 3.0F, 0.7F), kNoRotation}}}});
    return LevelSet::create(std::move(set)).value();
  };
  const auto symmetry = symmetryOf(*levelsWith(0.0F, 0.0F));
  ASSERT_TRUE(symmetry.has_value());
  EXPECT_EQ(symmetry->plane.axis, 0);
  EXPECT_EQ(symmetry->plane.offset, 0.0F);
  EXPECT_EQ(symmetry->levels.front().pairs, 1);
  EXPECT_EQ(symmetry->levels.front().own, 1);
  EXPECT_FALSE(symmetryOf(*levelsWith(1e-3F, 0.0F)).has_value());
  EXPECT_FALSE(symmetryOf(*levelsWith(0.0F, 1e-3F)).has_value());
}

}  // namespace
}  // namespace scatter
