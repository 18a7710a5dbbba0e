#include "viewer/action.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <vector>

#include "viewer/camera_rig.h"
#include "viewer/drawing/projection.h"

namespace scatter::viewer {
namespace {

Actor ballAt(const Vec3& position, float radius = 1.0F) {
  Actor actor;
  actor.position = position;
  actor.radius = radius;
  return actor;
}

/// So many bodies on a circle, none of which meet.
std::vector<Actor> ringOf(int count, float radius) {
  std::vector<Actor> actors;
  for (int i = 0; i < count; ++i) {
    const float angle = 6.2831853F * static_cast<float>(i) / static_cast<float>(count);
    actors.push_back(ballAt({radius * std::cos(angle), 0.0F, radius * std::sin(angle)}));
  }
  return actors;
}

TEST(Action, BodiesWhoseBallsOverlapMeet) {
  std::vector<Actor> actors{ballAt(Vec3(0.0F)), ballAt({1.9F, 0.0F, 0.0F}), ballAt({4.0F, 0.0F, 0.0F}),
                            ballAt({0.0F, 2.1F, 0.0F}), ballAt({9.0F, 0.0F, 0.0F}, 5.5F)};
  markMeetings(actors);
  EXPECT_TRUE(actors[0].meeting);
  EXPECT_TRUE(actors[1].meeting);
  EXPECT_TRUE(actors[2].meeting) << "with the large one";
  EXPECT_FALSE(actors[3].meeting);
  EXPECT_TRUE(actors[4].meeting);
}

TEST(Action, IsWhereBodiesMeetNotWhereTheyStart) {
  std::vector<Actor> actors = ringOf(40, 18.0F);
  const Ball before = findAction(actors).value();
  EXPECT_NEAR(before.radius, 19.0F, 1.0F);
  for (int i = 0; i < 10; ++i) actors.push_back(ballAt({0.3F * static_cast<float>(i), 2.0F, 0.0F}));
  markMeetings(actors);
  const Ball during = findAction(actors).value();
  EXPECT_LT(during.radius, 6.0F);
  EXPECT_LT(glm::distance(during.center, Vec3(1.5F, 2.0F, 0.0F)), 1.0F);
}

TEST(Action, StragglersDoNotCount) {
  std::vector<Actor> actors = ringOf(30, 8.0F);
  const Ball alone = findAction(actors).value();
  actors.push_back(ballAt({3000.0F, 0.0F, 0.0F}));
  actors.back().moved = 1.0F;
  const Ball with = findAction(actors).value();
  EXPECT_LT(glm::distance(alone.center, with.center), 2.0F);
  EXPECT_NEAR(alone.radius, with.radius, 2.0F);
}

TEST(Action, WhatMovesAmongMuchThatRestsIsInThePicture) {
  std::vector<Actor> actors = ringOf(30, 5.0F);
  for (Actor& actor : actors) actor.asleep = true;
  actors.push_back(ballAt({13.0F, 0.0F, 0.0F}));
  actors.back().asleep = true;
  const Ball atRest = findAction(actors).value();
  EXPECT_GT(glm::distance(atRest.center, actors.back().position), atRest.radius);
  actors.back().asleep = false;
  actors.back().moved = 0.1F;
  const Ball thrown = findAction(actors).value();
  EXPECT_LE(glm::distance(thrown.center, actors.back().position) + 1.0F, thrown.radius + 1e-3F);
}

TEST(Action, BodiesAreNeverSpecks) {
  const std::vector<Actor> sky = ringOf(100, 400.0F);
  const Ball action = findAction(sky).value();
  CameraRig rig;
  rig.watch(action, 1.3F, 0.0F);
  View view;
  view.camera = rig.camera();
  const glm::ivec2 window(1280, 720);
  const float middle = pixelOf(view, window, rig.pivot())->y;
  EXPECT_GT(middle - pixelOf(view, window, rig.pivot() + Vec3(0.0F, 1.0F, 0.0F))->y, 10.0F);
  EXPECT_FALSE(findAction({}).has_value());
}

TEST(Action, ACrowdIsMoreThanAFewThatMeetByChance) {
  std::vector<Actor> actors = ringOf(200, 300.0F);
  EXPECT_EQ(crowding(actors), 0.0F);
  actors[0].meeting = actors[1].meeting = true;
  EXPECT_LT(crowding(actors), 0.1F);
  for (std::size_t i = 0; i < 40; ++i) actors[i].meeting = true;
  EXPECT_EQ(crowding(actors), 1.0F);
}

}  // namespace
}  // namespace scatter::viewer
