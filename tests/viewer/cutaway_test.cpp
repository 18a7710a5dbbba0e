#include "viewer/cutaway.h"

#include <gtest/gtest.h>

#include <vector>

#include "viewer/shapes.h"

namespace scatter::viewer {
namespace {

/// A room 20 m wide and 10 m high with walls and slabs 2 m thick, and bodies on its floor.
class CutawayTest : public testing::Test {
 protected:
  CutawayTest() {
    add(kFloor, {0.0F, -1.0F, 0.0F});
    add(kCeiling, {0.0F, 11.0F, 0.0F});
    add(kFront, {0.0F, 5.0F, 11.0F});
    add(kBack, {0.0F, 5.0F, -11.0F});
    for (int x = -4; x <= 4; ++x) {
      for (int z = -4; z <= 4; ++z)
        actors_.push_back({Vec3(2.0F * static_cast<float>(x), 0.5F, 2.0F * static_cast<float>(z)), 0.5F});
    }
  }

  void add(BodyId body, const Vec3& position) {
    const bool slab = body == kFloor || body == kCeiling;
    obstacles_.push_back({body, {position, kNoRotation}, 15.0F, slab ? &slab_ : &wall_});
  }

  [[nodiscard]] bool isCut(BodyId body) const { return cutaway_.share(body) > 0.5F; }

  static constexpr BodyId kFloor{1};
  static constexpr BodyId kCeiling{2};
  static constexpr BodyId kFront{3};
  static constexpr BodyId kBack{4};
  static constexpr BodyId kPost{5};
  const RayTree slab_{test::boxMesh(Vec3(12.0F, 1.0F, 12.0F))};
  const RayTree wall_{test::boxMesh(Vec3(12.0F, 5.0F, 1.0F))};
  const RayTree post_{test::boxMesh(Vec3(0.4F, 1.0F, 0.4F))};
  std::vector<Actor> actors_;
  std::vector<Obstacle> obstacles_;
  Cutaway cutaway_;
};

TEST_F(CutawayTest, OnlyWhatIsBetweenEyeAndBodiesIsCutAway) {
  cutaway_.update({0.0F, 5.0F, 40.0F}, actors_, obstacles_, 0.0F);
  EXPECT_TRUE(isCut(kFront));
  EXPECT_FALSE(isCut(kBack));
  EXPECT_FALSE(isCut(kFloor));
  EXPECT_FALSE(isCut(kCeiling));
}

TEST_F(CutawayTest, FromAboveTheCeilingIsCutAwayAndFromBelowTheFloor) {
  cutaway_.update({0.0F, 50.0F, 3.0F}, actors_, obstacles_, 0.0F);
  EXPECT_TRUE(isCut(kCeiling));
  EXPECT_FALSE(isCut(kFloor));
  EXPECT_FALSE(isCut(kFront));
  cutaway_.update({0.0F, -50.0F, 3.0F}, actors_, obstacles_, 10.0F);
  EXPECT_TRUE(isCut(kFloor));
  EXPECT_FALSE(isCut(kCeiling));
}

TEST_F(CutawayTest, AFloorStaysWhenBodiesFallThroughIt) {
  for (std::size_t i = 0; i < actors_.size(); i += 5) actors_[i].position.y = -6.0F;
  cutaway_.update({0.0F, 20.0F, 40.0F}, actors_, obstacles_, 0.0F);
  EXPECT_FALSE(isCut(kFloor));
}

TEST_F(CutawayTest, WhatHidesLittleStays) {
  obstacles_.push_back({kPost, {Vec3(0.0F, 1.0F, 0.0F), kNoRotation}, 1.2F, &post_});
  const Vec3 eye(3.0F, 8.0F, 9.0F);
  EXPECT_LT(hiddenShare(obstacles_.back(), eye, actors_), 0.25F);
  cutaway_.update(eye, actors_, obstacles_, 0.0F);
  EXPECT_FALSE(isCut(kPost));
}

TEST_F(CutawayTest, FadesInAFractionOfASecond) {
  const Vec3 inside(0.0F, 5.0F, 8.0F);
  const Vec3 outside(0.0F, 5.0F, 40.0F);
  cutaway_.update(inside, actors_, obstacles_, 0.0F);
  EXPECT_EQ(cutaway_.share(kFront), 0.0F);
  cutaway_.update(outside, actors_, obstacles_, 0.1F);
  EXPECT_GT(cutaway_.share(kFront), 0.1F);
  EXPECT_LT(cutaway_.share(kFront), 0.9F);
  cutaway_.update(outside, actors_, obstacles_, 1.0F);
  EXPECT_EQ(cutaway_.share(kFront), 1.0F);
}

TEST_F(CutawayTest, HandsReachBehindWhatIsCutAway) {
  const Ray ray{{0.0F, 5.0F, 40.0F}, {0.0F, 0.0F, -1.0F}};
  EXPECT_EQ(cutaway_.depthBehind(ray, obstacles_), 0.0F);
  cutaway_.update(ray.origin, actors_, obstacles_, 0.0F);
  EXPECT_NEAR(cutaway_.depthBehind(ray, obstacles_), 30.0F, 1e-3F);
}

}  // namespace
}  // namespace scatter::viewer
