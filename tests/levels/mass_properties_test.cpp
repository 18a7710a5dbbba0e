#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <scatter/levels/mass_properties.h>

#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <numbers>

#include "levels/part_builders.h"

namespace scatter {
namespace {

using ::testing::HasSubstr;
using namespace testing;  // the part builders

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

MassProperties massOf(const std::vector<ConvexPart>& parts) {
  const Result<MassProperties> mass = massProperties(parts);
  EXPECT_TRUE(mass.has_value()) << (mass ? "" : mass.error().message);
  return mass.value_or(MassProperties{});
}

std::string massErrorOf(const std::vector<ConvexPart>& parts) {
  const Result<MassProperties> mass = massProperties(parts);
  return mass ? "no error" : mass.error().message;
}

void expectVector(const Vec3& actual, const Vec3& expected, float tolerance = 1e-5F) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], tolerance) << "component " << i;
}

void expectInertia(const Mat3& actual, const Mat3& expected, float tolerance = 1e-5F) {
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      EXPECT_NEAR(actual[column][row], expected[column][row], tolerance)
          << "element " << row << ", " << column;
    }
  }
}

Mat3 diagonal(float x, float y, float z) {
  return {x, 0.0F, 0.0F, 0.0F, y, 0.0F, 0.0F, 0.0F, z};
}

TEST(MassProperties, Box) {
  // 2 × 4 × 6: 48 m³; a cuboid has (b² + c²) / 12 = (16 + 36) / 12, (4 + 36) / 12, (4 + 16) / 12.
  const MassProperties mass = massOf({box({1.0F, 2.0F, 3.0F})});
  EXPECT_FLOAT_EQ(mass.volume, 48.0F);
  expectVector(mass.centerOfMass, Vec3(0.0F));
  expectInertia(mass.inertia, diagonal(52.0F / 12.0F, 40.0F / 12.0F, 20.0F / 12.0F));
}

TEST(MassProperties, Sphere) {
  // r = 2: 4/3 π 8 m³, 2/5 · 4 = 1.6.
  const MassProperties mass = massOf({sphere(2.0F, {5.0F, -1.0F, 2.0F})});
  EXPECT_FLOAT_EQ(mass.volume, 32.0F / 3.0F * kPi);
  expectVector(mass.centerOfMass, {5.0F, -1.0F, 2.0F});
  expectInertia(mass.inertia, diagonal(1.6F, 1.6F, 1.6F));
}

TEST(MassProperties, Cylinder) {
  // r = 2, height 6: 24 π m³; r²/2 = 2 along, (3 r² + 36) / 12 = 4 across.
  const MassProperties mass = massOf({cylinder(2.0F, 3.0F)});
  EXPECT_FLOAT_EQ(mass.volume, 24.0F * kPi);
  expectInertia(mass.inertia, diagonal(4.0F, 2.0F, 4.0F));
}

TEST(MassProperties, Capsule) {
  // r = 1, h = 1: middle 2 π, ends 4/3 π, so shares 0.6 and 0.4.
  // Along: 0.6 · 1/2 + 0.4 · 2/5 = 0.46. Across: middle 1/4 + 4/12 = 0.58333; a half ball 83/320 about its
  // own centre, which is 1 + 3/8 away: 0.259375 + 1.890625 = 2.15; 0.6 · 0.58333 + 0.4 · 2.15 = 1.21.
  const MassProperties mass = massOf({capsule(1.0F, 1.0F)});
  EXPECT_FLOAT_EQ(mass.volume, 10.0F / 3.0F * kPi);
  expectInertia(mass.inertia, diagonal(1.21F, 0.46F, 1.21F));
}

TEST(MassProperties, CapsuleWithoutHeightIsASphere) {
  const MassProperties flat = massOf({capsule(1.5F, 0.0F)});
  const MassProperties ball = massOf({sphere(1.5F)});
  EXPECT_FLOAT_EQ(flat.volume, ball.volume);
  expectInertia(flat.inertia, ball.inertia);
}

TEST(MassProperties, HullOfABoxIsTheBox) {
  const Vec3 half{0.7F, 1.1F, 0.4F};
  const Transform pose{{3.0F, -2.0F, 1.0F}, glm::angleAxis(0.8F, glm::normalize(Vec3(1.0F, 2.0F, -1.0F)))};
  const MassProperties exact = massOf({{Box{half}, pose}});
  const MassProperties byTetrahedra = massOf({{ConvexHull{boxCorners(half)}, pose}});
  EXPECT_NEAR(byTetrahedra.volume, exact.volume, 1e-5F);
  expectVector(byTetrahedra.centerOfMass, exact.centerOfMass);
  expectInertia(byTetrahedra.inertia, exact.inertia);
}

TEST(MassProperties, PointsInsideAHullChangeNothing) {
  std::vector<Vec3> points = boxCorners(Vec3(1.0F));
  points.insert(points.end(), {Vec3(0.0F), Vec3(0.5F, 0.2F, 0.1F), Vec3(1.0F, 0.0F, 0.0F), points.front()});
  const MassProperties mass = massOf({hull(points)});
  EXPECT_NEAR(mass.volume, 8.0F, 1e-5F);
  expectInertia(mass.inertia, diagonal(2.0F / 3.0F, 2.0F / 3.0F, 2.0F / 3.0F));
}

TEST(MassProperties, Tetrahedron) {
  // Corners at the origin and at 1 along each axis: volume 1/6, centre (1/4, 1/4, 1/4). About the origin
  // ∫x² = 6/60 = 1/10 and ∫xy = 6/120 = 1/20 per kilogram; about the centre 1/10 - 1/16 = 3/80 and
  // 1/20 - 1/16 = -1/80. So the inertia is 6/80 on the diagonal and +1/80 off it.
  const MassProperties mass =
      massOf({hull({Vec3(0.0F), {1.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}, {0.0F, 0.0F, 1.0F}})});
  EXPECT_NEAR(mass.volume, 1.0F / 6.0F, 1e-6F);
  expectVector(mass.centerOfMass, Vec3(0.25F), 1e-6F);
  const float d = 6.0F / 80.0F;
  const float o = 1.0F / 80.0F;
  expectInertia(mass.inertia, {d, o, o, o, d, o, o, o, d}, 1e-6F);
}

TEST(MassProperties, RotationTurnsTheInertia) {
  // A quarter turn around z exchanges x and y.
  const Transform pose{Vec3(0.0F), glm::angleAxis(kPi / 2.0F, Vec3(0.0F, 0.0F, 1.0F))};
  const MassProperties mass = massOf({{Box{{1.0F, 2.0F, 3.0F}}, pose}});
  expectInertia(mass.inertia, diagonal(40.0F / 12.0F, 52.0F / 12.0F, 20.0F / 12.0F));
}

TEST(MassProperties, TwoHalvesAreTheWhole) {
  // Parallel axes: a 4 × 2 × 2 box cut at x = 0.
  const MassProperties whole = massOf({box({2.0F, 1.0F, 1.0F}, {3.0F, 0.0F, 0.0F})});
  const MassProperties halves =
      massOf({box(Vec3(1.0F), {2.0F, 0.0F, 0.0F}), box(Vec3(1.0F), {4.0F, 0.0F, 0.0F})});
  EXPECT_FLOAT_EQ(halves.volume, whole.volume);
  expectVector(halves.centerOfMass, whole.centerOfMass);
  expectInertia(halves.inertia, whole.inertia);
}

TEST(MassProperties, HeavierPartsWeighMore) {
  // Volumes 8 at x = 0 and 1 at x = 4.5: centre 0.5. Inertia around x: (8 · 2/3 + 1 · 1/6) / 9 = 11/18;
  // around y and z, + (8 · 0.25 + 1 · 16) / 9 = 2.
  const MassProperties mass = massOf({box(Vec3(1.0F)), box(Vec3(0.5F), {4.5F, 0.0F, 0.0F})});
  EXPECT_FLOAT_EQ(mass.volume, 9.0F);
  expectVector(mass.centerOfMass, {0.5F, 0.0F, 0.0F});
  expectInertia(mass.inertia, diagonal(11.0F / 18.0F, 11.0F / 18.0F + 2.0F, 11.0F / 18.0F + 2.0F));
}

TEST(MassProperties, RandomHullsObeyTheLaws) {
  Random random(7);
  for (int i = 0; i < 50; ++i) {
    const ConvexPart part = random.ellipsoidHull(4 + i, {1.0F, 0.3F, 2.0F}, random.inBox(Vec3(5.0F)));
    const MassProperties mass = massOf({part});
    EXPECT_GT(mass.volume, 0.0F);
    EXPECT_LT(mass.volume, 4.0F / 3.0F * kPi * 0.6F);
    // Twice the size: eight times the volume, four times the inertia per kilogram.
    ConvexPart doubled = part;
    for (Vec3& vertex : std::get<ConvexHull>(doubled.shape).vertices) vertex *= 2.0F;
    const MassProperties larger = massOf({doubled});
    EXPECT_NEAR(larger.volume, 8.0F * mass.volume, 1e-4F * larger.volume);
    expectInertia(larger.inertia, 4.0F * mass.inertia, 1e-4F * larger.inertia[0][0]);
    // A solid's moments fulfil the triangle inequality.
    for (int axis = 0; axis < 3; ++axis) {
      const float others =
          mass.inertia[(axis + 1) % 3][(axis + 1) % 3] + mass.inertia[(axis + 2) % 3][(axis + 2) % 3];
      EXPECT_LT(mass.inertia[axis][axis], others);
    }
  }
}

TEST(MassProperties, ErrorsNameThePart) {
  const ConvexPart good = box(Vec3(1.0F));
  EXPECT_EQ(massErrorOf({}), "a solid needs at least one part");
  EXPECT_EQ(massErrorOf({good, box({1.0F, 0.0F, 2.0F})}),
            "part 2: box: half extents (1, 0, 2) must be positive and finite");
  EXPECT_EQ(massErrorOf({sphere(-1.0F)}), "part 1: sphere: radius -1 must be positive and finite");
  EXPECT_EQ(massErrorOf({capsule(0.0F, 1.0F)}), "part 1: capsule: radius 0 must be positive and finite");
  EXPECT_EQ(massErrorOf({capsule(1.0F, -1.0F)}),
            "part 1: capsule: half height -1 must be finite and not negative");
  EXPECT_EQ(massErrorOf({cylinder(1.0F, kInfinity)}),
            "part 1: cylinder: half height inf must be positive and finite");
  EXPECT_EQ(massErrorOf({hull({Vec3(0.0F), Vec3(1.0F)})}),
            "part 1: convex hull: its 2 vertices are fewer than 4");
  EXPECT_THAT(massErrorOf({box({kNan, 1.0F, 1.0F})}), HasSubstr("nan"));
  EXPECT_THAT(massErrorOf({box(Vec3(1.0F), {kNan, 0.0F, 0.0F})}),
              HasSubstr("position (nan, 0, 0) is not finite"));
  EXPECT_THAT(massErrorOf({{Box{}, {Vec3(0.0F), Quat(2.0F, 0.0F, 0.0F, 0.0F)}}}),
              HasSubstr("rotation has length 2"));
  EXPECT_THAT(massErrorOf({hull({Vec3(0.0F), Vec3(1.0F), {0.0F, kNan, 0.0F}})}), HasSubstr("vertex 3"));
  EXPECT_THAT(massErrorOf({box(Vec3(1e30F))}), HasSubstr("too large"));
  EXPECT_THAT(massErrorOf({cylinder(1.0F, 1e-7F)}), HasSubstr("differ by more than"));
}

}  // namespace
}  // namespace scatter
