#include "viewer/debug_views.h"

#include <gtest/gtest.h>
#include <scatter/bullet/bullet_physics.h>
#include <scatter/world/diagnostics.h>

#include <glm/geometric.hpp>

namespace scatter::viewer {
namespace {

BodyId add(World& world, Shape shape, Motion motion, Vec3 position) {
  BodyDef def;
  def.shape = std::move(shape);
  def.motion = motion;
  def.pose.position = position;
  const auto added = world.add(std::move(def));
  EXPECT_TRUE(added) << added.error().message;
  return (*added)->body();
}

TEST(DebugViews, DrawsPairsFromCentreToCentreButToTheNearestPlaceOfWhatDoesNotMove) {
  World world(makeBulletPhysics({}));
  add(world, Box{{50.0F, 1.0F, 50.0F}}, Motion::kStatic, {20.0F, -1.0F, 0.0F});
  add(world, Sphere{0.5F}, Motion::kDynamic, {0.0F, 0.5F, 0.0F});
  add(world, Sphere{0.5F}, Motion::kDynamic, {0.9F, 0.5F, 0.0F});
  world.step(1.0F / 60.0F);
  DebugViewSet views;
  views.set(DebugView::kPairs, true);
  Observation observed;
  world.physics().diagnostics().observe(views.parts(), observed);
  View view;
  addDebugLines(views, world, observed, view);
  ASSERT_EQ(view.linesOnTop.size(), 3U) << "two balls on a floor, side by side";
  for (const Line& line : view.linesOnTop) EXPECT_LT(glm::distance(line.from, line.to), 1.0F);
}

}  // namespace
}  // namespace scatter::viewer
