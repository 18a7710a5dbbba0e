#include <gtest/gtest.h>
#include <scatter/io/model_library.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "scenes/scene_world.h"
#include "scenes/worlds.h"
#include "trials.h"

namespace scatter::test {
namespace {

constexpr int kFrames = kSanitized ? 300 : 700;  ///< Under sanitizers until they have arrived.
constexpr int kLift = 30;
constexpr int kThrow = 150;
constexpr float kRoom = 12.0F;
constexpr float kThingHeight = 9.0F;

/// Of the dynamic objects.
std::vector<Vec3> centers(const World& world) {
  std::vector<Vec3> centers;
  for (const auto& object : world.objects()) {
    if (object->def().motion == Motion::kDynamic) centers.push_back(object->state().centerOfMass);
  }
  return centers;
}

float meanDistance(const std::vector<Vec3>& points) {
  const Vec3 target(0.0F, 2.2F, 0.0F);
  float sum = 0.0F;
  for (const Vec3& point : points) sum += glm::length(point - target);
  return sum / static_cast<float>(points.size());
}

class Telekinesis : public testing::TestWithParam<WorldCase> {};

TEST_P(Telekinesis, ThrowsEverythingAtOnePointAndKeepsItInTheRoom) {
  SceneWorld scene("telekinesis", GetParam().def);
  const std::vector<Vec3> start = centers(scene.world);
  double peakEnergy = 0.0;
  float nearest = meanDistance(start);
  EXPECT_GT(nearest, 7.0F);
  for (int i = 0; i < kFrames; ++i) {
    if (i == kLift) {
      const std::vector<Vec3> now = centers(scene.world);
      for (std::size_t k = 0; k < now.size(); ++k) EXPECT_LT(glm::length(now[k] - start[k]), 0.05F);
    }
    scene.step();
    ASSERT_FALSE(scene.world.physics().findInvalidState()) << "frame " << i;
    ASSERT_EQ(objectsOutside(scene.world, kRoom, kThingHeight), std::vector<std::string>{}) << "frame " << i;
    peakEnergy = std::max(peakEnergy, scene.world.physics().kineticEnergy());
    if (i >= kThrow) nearest = std::min(nearest, meanDistance(centers(scene.world)));
  }
  EXPECT_LT(nearest, 3.5F) << "they arrive together";
  if (kSanitized) return;
  EXPECT_LT(scene.world.physics().kineticEnergy(), 0.01 * peakEnergy) << "they come to rest";
  float highest = 0.0F;
  for (const Vec3& at : centers(scene.world)) highest = std::max(highest, at.y);
  EXPECT_LT(highest, 5.0F) << "they lie in a heap";
}

INSTANTIATE_TEST_SUITE_P(Worlds, Telekinesis, testing::ValuesIn(everyWorld()),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(TelekinesisTest, OverloadsWhenEverythingArrives) {
  SceneWorld scene("telekinesis", everyWorld()[1].def);
  int before = 0;
  int after = 0;
  for (int i = 0; i < 300; ++i) {
    scene.step();
    int& peak = i < kThrow ? before : after;
    peak = std::max(peak, scene.counters().pairWork.childPairs);
  }
  EXPECT_GT(after, 10 * before);
}

TEST(TelekinesisTest, WhatIsLeftIsLiftedWithItsOwnSpin) {
  SceneWorld whole("telekinesis");
  SceneWorld without("telekinesis");
  without.remove(*without.world.find("table-1"));
  for (int i = 0; i < kLift; ++i) {
    whole.step();
    without.step();
  }
  // Before the step, in which contacts with the floor change spins a little.
  whole.update();
  without.update();
  for (const char* name : {"chair-1", "table-2", "barrel-26"}) {
    const Vec3 spin = whole.world.find(name)->state().angularVelocity;
    EXPECT_GT(glm::length(spin), 0.1F) << name;
    EXPECT_EQ(without.world.find(name)->state().angularVelocity, spin) << name;
  }
}

TEST(TelekinesisTest, ItsThingsHaveTwentyToSixtyPartsAndThreeLevels) {
  for (const char* name : {"table", "chair", "shelf", "lamp", "crate", "barrel"}) {
    const auto model = loadModel(name);
    ASSERT_TRUE(model) << model.error().message;
    ASSERT_EQ((*model)->levels->count(), 3) << name;
    EXPECT_EQ((*model)->levels->coarsest().parts.size(), 1U) << name;
    EXPECT_GE((*model)->levels->level(2).parts.size(), 4U) << name;
    EXPECT_LE((*model)->levels->level(2).parts.size(), 10U) << name;
    EXPECT_GE((*model)->levels->finest().parts.size(), 20U) << name;
    EXPECT_LE((*model)->levels->finest().parts.size(), 60U) << name;
  }
}

}  // namespace
}  // namespace scatter::test
