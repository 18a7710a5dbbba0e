#include "viewer/camera_rig.h"

#include "viewer/drawing/projection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace scatter::viewer {
namespace {

void expectNear(const Vec3& a, const Vec3& b, float tolerance = 1e-4F) {
  EXPECT_LT(glm::length(a - b), tolerance)
      << a.x << " " << a.y << " " << a.z << " and " << b.x << " " << b.y << " " << b.z;
}

TEST(CameraRig, LooksFromWhereItIsTold) {
  CameraRig rig;
  rig.look(Vec3(1.0F, 2.0F, 3.0F), 0.0F, 0.0F, 10.0F);
  expectNear(rig.eye(), Vec3(1.0F, 2.0F, 13.0F));
  rig.look(Vec3(0.0F), 90.0F, 0.0F, 5.0F);
  expectNear(rig.eye(), Vec3(5.0F, 0.0F, 0.0F));
  rig.look(Vec3(0.0F), 0.0F, 30.0F, 2.0F);
  expectNear(rig.eye(), Vec3(0.0F, 1.0F, std::sqrt(3.0F)));
}

TEST(CameraRig, OrbitsAroundItsMiddle) {
  CameraRig rig;
  rig.look(Vec3(1.0F), 20.0F, 10.0F, 8.0F);
  rig.turn(0.7F, 0.3F);
  EXPECT_NEAR(glm::length(rig.eye() - Vec3(1.0F)), 8.0F, 1e-4F);
  expectNear(rig.pivot(), Vec3(1.0F));
  rig.zoom(2.0F);
  EXPECT_NEAR(glm::length(rig.eye() - Vec3(1.0F)), 4.0F, 1e-4F);
}

TEST(CameraRig, FlyingTurnsWhereItStands) {
  CameraRig rig;
  rig.setMode(CameraMode::kFly);
  const Vec3 eye = rig.eye();
  rig.turn(0.7F, 0.3F);
  expectNear(rig.eye(), eye, 1e-3F);
}

TEST(CameraRig, FollowsOnlyWhenToldTo) {
  CameraRig rig;
  rig.look(Vec3(0.0F), 0.0F, 0.0F, 5.0F);
  rig.follow(Vec3(9.0F));
  expectNear(rig.pivot(), Vec3(0.0F));
  rig.setMode(CameraMode::kFollow);
  rig.follow(Vec3(9.0F));
  expectNear(rig.pivot(), Vec3(9.0F));
}

TEST(CameraRig, FramesABall) {
  CameraRig rig;
  rig.frame(Vec3(0.0F), 10.0F);
  View view;
  view.camera = rig.camera();
  const glm::ivec2 window(600, 600);
  // The ball touches the edge of the picture: what is inside is seen, what is further up is not.
  const Vec3 up = glm::normalize(glm::cross(glm::cross(-rig.eye(), Vec3(0.0F, 1.0F, 0.0F)), -rig.eye()));
  EXPECT_GT(pixelOf(view, window, 9.0F * up)->y, 0.0F);
  EXPECT_LT(pixelOf(view, window, 12.0F * up)->y, 0.0F);
}

}  // namespace
}  // namespace scatter::viewer
