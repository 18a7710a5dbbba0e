#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <scatter/levels/build_levels.h>
#include <scatter/levels/mass_properties.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "levels/meshes.h"
#include "levels/part_builders.h"
#include "trials.h"

namespace scatter {
namespace {

using ::testing::HasSubstr;
using namespace testing;  // the part and mesh builders

SolidMass unionOf(const std::vector<ConvexPart>& parts) {
  const Result<SolidMass> mass = massOfUnion(parts);
  EXPECT_TRUE(mass.has_value()) << (mass ? "" : mass.error().message);
  return mass.value_or(SolidMass{});
}

MassProperties massOf(const SurfaceMesh& mesh) {
  const Result<SolidMass> mass = massOfMesh(mesh);
  EXPECT_TRUE(mass.has_value()) << (mass ? "" : mass.error().message);
  return mass.value_or(SolidMass{}).properties;
}

float largest(const Mat3& inertia) {
  return std::max({inertia[0][0], inertia[1][1], inertia[2][2]});
}

/// Shares of the volume, of the largest extent, and of the largest moment of inertia.
void expectSame(const MassProperties& actual, const MassProperties& expected, float share) {
  EXPECT_NEAR(actual.volume, expected.volume, share * expected.volume);
  const float size = std::sqrt(largest(expected.inertia));
  EXPECT_LE(glm::length(actual.centerOfMass - expected.centerOfMass), share * size);
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      EXPECT_NEAR(actual.inertia[column][row], expected.inertia[column][row],
                  share * largest(expected.inertia))
          << row << ", " << column;
    }
  }
}

MassProperties boxMass(const Vec3& half, const Vec3& center = Vec3(0.0F)) {
  return *massProperties({box(half, center)});
}

TEST(UnionMass, OfPartsThatAreApartIsExact) {
  const SolidMass mass = unionOf({box(Vec3(1.0F)), sphere(1.0F, {5.0F, 0.0F, 0.0F})});
  EXPECT_EQ(mass.error, 0.0F);
  EXPECT_EQ(mass.shared, 0.0F);
  EXPECT_FLOAT_EQ(mass.properties.volume, 8.0F + 4.0F / 3.0F * std::numbers::pi_v<float>);
}

TEST(UnionMass, CountsWhatPartsShareOnce) {
  const SolidMass mass = unionOf({box({2.0F, 1.0F, 1.0F}), box({2.0F, 1.0F, 1.0F}, {1.0F, 0.0F, 0.0F}),
                                  boxHull({1.5F, 1.0F, 1.0F}, {0.5F, 0.0F, 0.0F})});
  expectSame(mass.properties, boxMass({2.5F, 1.0F, 1.0F}, {0.5F, 0.0F, 0.0F}), 0.002F);
  EXPECT_NEAR(mass.shared, 24.0F / 20.0F, 0.01F);
  EXPECT_LE(mass.error, 0.01F);
}

TEST(UnionMass, OfWhatLiesWithinIsThatOfTheOuter) {
  const std::vector<ConvexPart> parts{
      box(Vec3(1.0F)), sphere(0.7F, {0.2F, 0.1F, 0.0F}), capsule(0.2F, 0.5F), cylinder(0.3F, 0.6F),
      hull({{0.5F, 0.0F, 0.0F}, {0.0F, 0.5F, 0.0F}, {0.0F, 0.0F, 0.5F}, {-0.2F, -0.2F, -0.2F}})};
  expectSame(unionOf(parts).properties, boxMass(Vec3(1.0F)), 0.005F);
  const std::vector<ConvexPart> reversed(parts.rbegin(), parts.rend());
  expectSame(unionOf(reversed).properties, boxMass(Vec3(1.0F)), 0.005F);
}

TEST(UnionMass, OfACylinderAndTwoBallsIsACapsule) {
  const SolidMass mass =
      unionOf({cylinder(0.5F, 1.0F), sphere(0.5F, {0.0F, 1.0F, 0.0F}), sphere(0.5F, {0.0F, -1.0F, 0.0F})});
  expectSame(mass.properties, *massProperties({capsule(0.5F, 1.0F)}), 0.003F);
}

// What was worked out is kept, by all that it depends on.
TEST(UnionMass, IsThatOfTheseParts) {
  const auto with = [](const ConvexPart& part) { return unionOf({box(Vec3(1.0F)), part}); };
  const SolidMass first = with(capsule(0.5F, 1.0F));
  EXPECT_EQ(with(capsule(0.5F, 1.0F)).properties.inertia, first.properties.inertia);
  EXPECT_EQ(with(capsule(0.5F, 1.0F)).shared, first.shared);
  EXPECT_NE(with(cylinder(0.5F, 1.0F)).shared, first.shared);
  EXPECT_NE(with(capsule(0.5F, 0.9F)).shared, first.shared);
  EXPECT_NE(with(capsule(0.5F, 1.0F, {0.0F, 0.1F, 0.0F})).shared, first.shared);
  EXPECT_NE(with({Capsule{0.5F, 1.0F}, {{}, Quat(0.8F, 0.6F, 0.0F, 0.0F)}}).shared, first.shared);
}

// Boxes that together fill a box of random sides, turned and moved as one.
TEST(UnionMass, OfOverlappingPiecesIsTheWhole) {
  Random random(5);
  for (int round = 0; round < test::trials(60); ++round) {
    const Vec3 half(random.uniform(0.02F, 1.0F), random.uniform(0.1F, 1.0F), random.uniform(0.3F, 1.0F));
    const Transform pose{random.direction() * (round % 2 == 0 ? 3.0F : 1e2F), random.rotation()};
    const ConvexPart whole{Box{half}, pose};
    std::vector<ConvexPart> parts;
    constexpr int kPieces = 6;
    for (int i = 0; i < kPieces; ++i) {
      // Pieces of a third of the length, a sixth apart but at the ends.
      const float from = 2.0F * static_cast<float>(i) / kPieces - 1.0F;
      const float to = std::min(1.0F, from + 2.0F / 3.0F);
      const Vec3 center(0.0F, 0.0F, 0.5F * (from + to) * half.z);
      const Vec3 extents(half.x, half.y, 0.5F * (to - from) * half.z);
      parts.push_back({Box{extents}, pose * Transform{center, kNoRotation}});
    }
    const SolidMass mass = unionOf(parts);
    const MassProperties expected = *massProperties({whole});
    expectSame(mass.properties, expected, 0.01F);
    EXPECT_NEAR(mass.properties.volume, expected.volume, (4.0F * mass.error + 2e-3F) * expected.volume);
  }
}

TEST(UnionMass, IsTheSameEveryTime) {
  const std::vector<ConvexPart> parts{box(Vec3(1.0F)), sphere(1.2F), capsule(0.5F, 1.0F)};
  const SolidMass first = unionOf(parts);
  const SolidMass second = unionOf(parts);
  EXPECT_EQ(first.properties.volume, second.properties.volume);
  EXPECT_EQ(first.properties.centerOfMass, second.properties.centerOfMass);
  EXPECT_EQ(first.properties.inertia, second.properties.inertia);
}

TEST(MeshMass, OfABoxIsTheBoxes) {
  const Vec3 half(0.5F, 1.0F, 0.125F);
  for (const Vec3 at : {Vec3(0.0F), Vec3(3.0F, -2.0F, 1.0F), Vec3(1e4F, 0.0F, 1e4F)}) {
    expectSame(massOf(boxMesh(half, at)), boxMass(half, at), 1e-3F);
    expectSame(massOf(insideOut(boxMesh(half, at))), boxMass(half, at), 1e-3F);
  }
}

TEST(MeshMass, OfRoundSolidsIsAnalytic) {
  MassProperties ball;
  ball.volume = 4.0F / 3.0F * std::numbers::pi_v<float>;
  ball.inertia = Mat3(0.4F);
  expectSame(massOf(sphereMesh(256)), ball, 1e-3F);

  // A torus of radii 1 and r: 2 pi² r² m³; 1 + 3/4 r² about its axis, 1/2 + 5/8 r² across.
  const float r = 0.3F;
  const MassProperties torus = massOf(torusMesh(384, 192, r));
  const float pi = std::numbers::pi_v<float>;
  EXPECT_NEAR(torus.volume, 2.0F * pi * pi * r * r, 1e-3F * torus.volume);
  std::array<float, 3> moments{torus.inertia[0][0], torus.inertia[1][1], torus.inertia[2][2]};
  std::sort(moments.begin(), moments.end());
  EXPECT_NEAR(moments[2], 1.0F + 0.75F * r * r, 1e-3F);
  EXPECT_NEAR(moments[0], 0.5F + 0.625F * r * r, 1e-3F);
  EXPECT_NEAR(moments[1], 0.5F + 0.625F * r * r, 1e-3F);
}

TEST(MeshMass, LeavesCavitiesEmpty) {
  const MassProperties hollow = massOf(joined(sphereMesh(128), insideOut(sphereMesh(128, 0.5F))));
  EXPECT_NEAR(hollow.volume, 4.0F / 3.0F * std::numbers::pi_v<float> * (1.0F - 0.125F), 0.005F);
  EXPECT_NEAR(hollow.inertia[0][0], 0.4F * (1.0F - 1.0F / 32.0F) / (1.0F - 1.0F / 8.0F), 0.002F);
}

TEST(MeshMass, CountsWhatShellsShareOnce) {
  const Vec3 half(2.0F, 1.0F, 0.5F);
  const SurfaceMesh boxes = joined(boxMesh(half), boxMesh(half, {1.0F, 0.0F, 0.0F}));
  const auto mass = massOfMesh(joined(boxes, sphereMesh(32, 0.4F, {0.5F, 0.2F, 0.0F})));
  ASSERT_TRUE(mass.has_value());
  expectSame(mass->properties, boxMass({2.5F, 1.0F, 0.5F}, {0.5F, 0.0F, 0.0F}), 1e-3F);
  EXPECT_NEAR(mass->shared, (6.0F + 4.0F / 3.0F * std::numbers::pi_v<float> * 0.064F) / 10.0F, 0.01F);
  EXPECT_LT(mass->error, 1e-2F);
}

// The same turned every way: columns see models from one side only.
TEST(MeshMass, OfOverlappingShellsDoesNotDependOnTheirTurn) {
  Random random(8);
  for (int round = 0; round < test::trials(12); ++round) {
    const Quat turn = random.rotation();
    const Vec3 half(1.0F, 0.05F, 0.3F);
    SurfaceMesh mesh = joined(boxMesh(half), boxMesh(half, {0.7F, 0.0F, 0.0F}));
    for (Vec3& vertex : mesh.vertices) vertex = turn * vertex;
    const auto mass = massOfMesh(mesh);
    ASSERT_TRUE(mass.has_value());
    const std::vector<ConvexPart> whole{{Box{{1.35F, 0.05F, 0.3F}}, {turn * Vec3(0.35F, 0.0F, 0.0F), turn}}};
    expectSame(mass->properties, *massProperties(whole), 2e-3F);
  }
}

TEST(MeshMass, TellsWhyThereIsNone) {
  const auto errorOf = [](const SurfaceMesh& mesh) {
    const auto mass = massOfMesh(mesh);
    return mass ? std::string("no error") : mass.error().message;
  };
  EXPECT_THAT(errorOf(sheetMesh()), HasSubstr("open"));
  EXPECT_THAT(errorOf(openCylinderMesh()), HasSubstr("open"));
  EXPECT_THAT(errorOf(flatMesh()), HasSubstr("open"));
}

TEST(MeshMass, IsThatOfLevelsBuiltFromAClosedMesh) {
  LevelBuildDef def;
  def.finestParts = 24;
  const SurfaceMesh torus = test::kSanitized ? torusMesh(16, 8) : torusMesh(24, 12);
  const auto built = buildLevels(torus, def);
  ASSERT_TRUE(built.has_value());
  EXPECT_TRUE(built->hasMassOfMesh);
  EXPECT_EQ(built->levels->mass().volume, massOf(torus).volume);
  const auto open = buildLevels(openCylinderMesh(), def);
  ASSERT_TRUE(open.has_value());
  EXPECT_FALSE(open->hasMassOfMesh);
  EXPECT_THAT(open->notes, ::testing::Contains(HasSubstr("mass properties are those of the finest level")));
}

}  // namespace
}  // namespace scatter
