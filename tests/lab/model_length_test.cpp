#include "lab/model_length.h"

#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>

namespace scatter {
namespace {

double lengthOf(const ConvexPart& part) {
  LevelSetDef def;
  def.name = "one";
  def.levels = {Level{{{Box{Vec3(50.0F)}, {}}}}, Level{{part}}};
  const auto levels = LevelSet::create(def);
  EXPECT_TRUE(levels) << levels.error().message;
  return lab::modelLength(**levels);
}

Transform turned(float angle, const Vec3& axis) {
  return {Vec3(3.0F, -1.0F, 2.0F), glm::angleAxis(angle, glm::normalize(axis))};
}

TEST(ModelLength, IsTheLongestSideOfTheFinestLevelsBox) {
  EXPECT_NEAR(lengthOf({Box{Vec3(1.0F, 2.0F, 3.0F)}, {}}), 6.0, 1e-5);
  EXPECT_NEAR(lengthOf({Sphere{2.0F}, turned(0.7F, {1, 2, 3})}), 4.0, 1e-5);
  EXPECT_NEAR(lengthOf({Capsule{0.5F, 2.0F}, turned(glm::half_pi<float>(), {1, 0, 0})}), 5.0, 1e-5);
  EXPECT_NEAR(lengthOf({Cylinder{0.5F, 2.0F}, turned(glm::half_pi<float>(), {0, 0, 1})}), 4.0, 1e-5);
}

TEST(ModelLength, IsAlongTheModelsAxes) {
  // Turned by 45 degrees about z, a box of 2 x 2 reaches from -sqrt(2) to sqrt(2).
  EXPECT_NEAR(lengthOf({Box{Vec3(1.0F, 1.0F, 0.1F)}, turned(glm::quarter_pi<float>(), {0, 0, 1})}),
              2.0 * glm::root_two<double>(), 1e-5);
  // A cylinder of radius 1 and height 4: half of (4 + 2) / sqrt(2) each way.
  EXPECT_NEAR(lengthOf({Cylinder{1.0F, 2.0F}, turned(glm::quarter_pi<float>(), {0, 0, 1})}),
              6.0 / glm::root_two<double>(), 1e-5);
}

TEST(ModelLength, SpansAllParts) {
  LevelSetDef def;
  def.name = "two";
  ConvexHull tetrahedron{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}};
  def.levels = {Level{{{Box{Vec3(50.0F)}, {}}}},
                Level{{{tetrahedron, {Vec3(10.0F, 0.0F, 0.0F), kNoRotation}},
                       {Box{Vec3(0.5F)}, {Vec3(-5.0F, 0.0F, 0.0F), kNoRotation}}}}};
  const auto levels = LevelSet::create(def);
  ASSERT_TRUE(levels) << levels.error().message;
  EXPECT_NEAR(lab::modelLength(**levels), 11.0 + 5.5, 1e-5);
}

}  // namespace
}  // namespace scatter
