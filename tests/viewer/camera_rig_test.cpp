#include "viewer/camera_rig.h"

#include "viewer/drawing/projection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

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
  rig.frame({Vec3(0.0F), 10.0F}, 1.0F);
  View view;
  view.camera = rig.camera();
  const glm::ivec2 window(600, 600);
  // The ball touches the edge of the picture: what is inside is seen, what is further up is not.
  const Vec3 up = glm::normalize(glm::cross(glm::cross(-rig.eye(), Vec3(0.0F, 1.0F, 0.0F)), -rig.eye()));
  EXPECT_GT(pixelOf(view, window, 9.0F * up)->y, 0.0F);
  EXPECT_LT(pixelOf(view, window, 12.0F * up)->y, 0.0F);
}

TEST(CameraRig, ABallFitsANarrowPictureToo) {
  CameraRig wide;
  wide.frame({Vec3(0.0F), 10.0F}, 2.0F);
  CameraRig narrow;
  narrow.frame({Vec3(0.0F), 10.0F}, 0.5F);
  EXPECT_NEAR(wide.distance(), 10.0F / std::sin(0.4F), 1e-3F);
  EXPECT_NEAR(narrow.distance(), 10.0F / std::sin(std::atan(0.5F * std::tan(0.4F))), 1e-3F);
}

TEST(CameraRig, WatchesTheActionSmoothly) {
  CameraRig rig;
  rig.watch({Vec3(0.0F), 10.0F}, 1.0F, 0.0F);
  expectNear(rig.pivot(), Vec3(0.0F));
  const float far = rig.distance();
  rig.watch({Vec3(8.0F, 0.0F, 0.0F), 5.0F}, 1.0F, 1.0F / 60.0F);
  EXPECT_GT(rig.pivot().x, 0.05F);
  EXPECT_LT(rig.pivot().x, 1.0F);
  EXPECT_LT(rig.distance(), far);
  EXPECT_GT(rig.distance(), 0.9F * far);
  for (int i = 0; i < 300; ++i) rig.watch({Vec3(8.0F, 0.0F, 0.0F), 5.0F}, 1.0F, 1.0F / 60.0F);
  expectNear(rig.pivot(), Vec3(8.0F, 0.0F, 0.0F), 0.01F);
  EXPECT_NEAR(rig.distance(), 0.5F * far, 0.01F * far);
}

TEST(CameraRig, WatchesUntilItIsSteeredAndAgainWhenAsked) {
  const Ball action{Vec3(50.0F, 0.0F, 0.0F), 5.0F};
  for (const auto& steer : std::vector<void (*)(CameraRig&)>{
           [](CameraRig& rig) { rig.turn(0.1F, 0.0F); }, [](CameraRig& rig) { rig.pan(0.1F, 0.0F); },
           [](CameraRig& rig) { rig.zoom(1.1F); }, [](CameraRig& rig) { rig.frame({}, 1.0F); },
           [](CameraRig& rig) { rig.look(Vec3(0.0F), 0.0F, 0.0F, 5.0F); }}) {
    CameraRig rig;
    rig.watch({}, 1.0F, 0.0F);
    EXPECT_EQ(rig.mode(), CameraMode::kAction);
    steer(rig);
    EXPECT_EQ(rig.mode(), CameraMode::kOrbit);
    const Vec3 pivot = rig.pivot();
    rig.watch(action, 1.0F, 1.0F);
    expectNear(rig.pivot(), pivot);
    rig.setMode(CameraMode::kAction);
    rig.watch(action, 1.0F, 10.0F);
    expectNear(rig.pivot(), action.center, 0.01F);
  }
}

}  // namespace
}  // namespace scatter::viewer
