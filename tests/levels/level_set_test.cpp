#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <scatter/levels/level_set.h>

#include <limits>

#include "levels/part_builders.h"

namespace scatter {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using namespace testing;  // the part builders

LevelSetDef hunter() {
  LevelSetDef def;
  def.name = "hunter";
  def.levels = {{{box({3.0F, 1.0F, 1.0F})}},
                {{box({1.5F, 1.0F, 1.0F}, {-1.5F, 0.0F, 0.0F}), box({1.5F, 0.5F, 0.5F}, {1.5F, 0.0F, 0.0F})}},
                {{box({2.5F, 0.4F, 0.4F}), sphere(0.9F, {-1.5F, 0.0F, 0.0F})}}};
  return def;
}

std::string errorOf(LevelSetDef def) {
  const auto made = LevelSet::create(std::move(def));
  return made ? "no error" : made.error().message;
}

TEST(LevelSet, HoldsWhatItWasMadeOf) {
  const auto made = LevelSet::create(hunter());
  ASSERT_TRUE(made.has_value()) << made.error().message;
  const LevelSet& levels = **made;
  EXPECT_EQ(levels.name(), "hunter");
  EXPECT_EQ(levels.count(), 3);
  EXPECT_EQ(levels.coarsest().parts.size(), 1U);
  EXPECT_EQ(&levels.level(1), &levels.coarsest());
  EXPECT_EQ(&levels.level(3), &levels.finest());
  EXPECT_FLOAT_EQ(levels.hullMargin(), 0.02F);
}

TEST(LevelSet, MassIsThatOfTheFinestLevel) {
  const auto made = LevelSet::create(hunter());
  ASSERT_TRUE(made.has_value()) << made.error().message;
  const auto finest = massProperties(hunter().levels.back().parts);
  ASSERT_TRUE(finest.has_value());
  EXPECT_EQ((*made)->mass().volume, finest->volume);
  EXPECT_EQ((*made)->mass().centerOfMass, finest->centerOfMass);
  EXPECT_EQ((*made)->mass().inertia, finest->inertia);
}

TEST(LevelSet, GivenMassIsKept) {
  LevelSetDef def = hunter();
  def.mass = MassProperties{2.0F, {0.5F, 0.0F, 0.0F}, Mat3(3.0F)};
  const auto made = LevelSet::create(def);
  ASSERT_TRUE(made.has_value()) << made.error().message;
  EXPECT_EQ((*made)->mass().volume, 2.0F);
  EXPECT_EQ((*made)->mass().inertia, Mat3(3.0F));
}

TEST(LevelSet, OneLevelIsEnough) {
  LevelSetDef def;
  def.levels = {{{sphere(1.0F)}}};
  EXPECT_EQ(errorOf(def), "no error");
}

TEST(LevelSet, NotNestedNamesPartAndDistance) {
  LevelSetDef def = hunter();
  // Level 2 ends at 0.5 around its right half; this reaches y = 0.75.
  def.levels[2].parts.push_back(box({0.1F, 0.1F, 0.1F}, {2.0F, 0.65F, 0.0F}));
  EXPECT_THAT(errorOf(def),
              StartsWith("model \"hunter\": level 3, part 3 sticks out of level 2 by 0.25 m at ("));
  EXPECT_THAT(errorOf(def), HasSubstr("; enlarge level 2 there or move the part"));
}

TEST(LevelSet, MarginIsPartOfTheNesting) {
  LevelSetDef def;
  def.name = "rock";
  def.levels = {{{box(Vec3(1.0F))}}, {{boxHull(Vec3(0.98F))}}};
  def.hullMargin = 0.02F;
  EXPECT_EQ(errorOf(def), "no error");
  def.hullMargin = 0.05F;
  EXPECT_THAT(errorOf(def), StartsWith("model \"rock\": level 2, part 1 sticks out of level 1 by 0.0"));
}

TEST(LevelSet, ErrorsAreClear) {
  LevelSetDef def = hunter();
  def.levels.clear();
  EXPECT_EQ(errorOf(def), "model \"hunter\": has no levels; give at least one");

  def = hunter();
  def.levels[1].parts.clear();
  EXPECT_EQ(errorOf(def), "model \"hunter\": level 2 has no parts; give at least one");

  def = hunter();
  def.levels[2].parts[0] = box({1.0F, -1.0F, 1.0F});
  EXPECT_EQ(errorOf(def),
            "model \"hunter\": level 3, part 1: box: half extents (1, -1, 1) must be positive and finite");

  def = hunter();
  def.levels[2].parts[1] = hull({Vec3(0.0F), {1.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}, {1.0F, 1.0F, 0.0F}});
  EXPECT_EQ(errorOf(def), "model \"hunter\": level 3, part 2: convex hull: its 4 vertices lie in one plane");
}

TEST(LevelSet, BadMarginOrMass) {
  LevelSetDef def = hunter();
  def.hullMargin = -0.01F;
  EXPECT_EQ(errorOf(def), "model \"hunter\": hull margin -0.01 must be finite and not negative");
  def.hullMargin = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(errorOf(def), "model \"hunter\": hull margin nan must be finite and not negative");

  const std::string badMass =
      "model \"hunter\": mass properties must be finite, with a positive volume and inertia";
  def = hunter();
  def.mass = MassProperties{};
  EXPECT_EQ(errorOf(def), badMass);
  def.mass = MassProperties{1.0F, Vec3(std::numeric_limits<float>::infinity()), Mat3(1.0F)};
  EXPECT_EQ(errorOf(def), badMass);
}

}  // namespace
}  // namespace scatter
