#include <gtest/gtest.h>

#include "viewer/drawing/draw_list.h"
#include "viewer/drawing/scenery_geometry.h"
#include "viewer/shapes.h"

namespace scatter::test {
namespace {

using namespace viewer;

class DrawListTest : public testing::Test {
 protected:
  [[nodiscard]] DrawList list() const {
    return listDraws(view_, {0, 0, 640, 400}, [this](MeshId) -> const MeshOutline& { return outline_; });
  }

  void add(const Vec3& position, float alpha = 1.0F) {
    Item item;
    item.pose.position = position;
    item.color.a = alpha;
    view_.items.push_back(item);
  }

  View view_;
  // Three details of a sphere of 1 m, with errors of 0, 1 and 10 cm.
  MeshOutline outline_{Vec3(0.0F), 1.0F, {0.0F, 0.01F, 0.1F}, {1000, 100, 10}};
};

TEST_F(DrawListTest, SolidItemsComeNearestFirstAndGhostsFarthestFirst) {
  add({0.0F, 0.0F, -5.0F});
  add({0.0F, 0.0F, 5.0F});
  add({0.0F, 0.0F, 0.0F}, 0.5F);
  add({0.0F, 0.0F, -20.0F}, 0.5F);
  const DrawList draws = list();
  ASSERT_EQ(draws.solid.size(), 2U);
  EXPECT_EQ(draws.solid[0].item, &view_.items[1]);
  EXPECT_EQ(draws.solid[0].distance, 5.0F);
  ASSERT_EQ(draws.seeThrough.size(), 2U);
  EXPECT_EQ(draws.seeThrough[0].item, &view_.items[3]);
}

TEST_F(DrawListTest, ItemsThatReachIntoTheViewAreKept) {
  // At 10 m the view reaches 4.23 m up and 6.76 m to the side; a sphere's edge may touch it from 1 m farther,
  // measured at a right angle to the slanted side.
  add({0.0F, 5.3F, 0.0F});
  add({0.0F, 5.4F, 0.0F});
  add({-7.9F, 0.0F, 0.0F});
  add({-8.1F, 0.0F, 0.0F});
  const DrawList draws = list();
  EXPECT_EQ(draws.solid.size(), 2U);
  EXPECT_EQ(draws.culled, 2U);
}

TEST_F(DrawListTest, DetailFallsWithDistance) {
  // 473 pixels for a metre at 1 m: 1 cm is 2 pixels at 2.4 m from the nearest point, 10 cm at 24 m.
  view_.camera.eye = {0.0F, 0.0F, 0.0F};
  view_.camera.target = {0.0F, 0.0F, -1.0F};
  add({0.0F, 0.0F, -3.0F});
  add({0.0F, 0.0F, -6.0F});
  add({0.0F, 0.0F, -40.0F});
  const DrawList draws = list();
  ASSERT_EQ(draws.solid.size(), 3U);
  EXPECT_EQ(draws.solid[0].detail, 0U);
  EXPECT_EQ(draws.solid[1].detail, 1U);
  EXPECT_EQ(draws.solid[2].detail, 2U);
}

TEST_F(DrawListTest, LargeItemsKeepTheirDetail) {
  add({0.0F, 0.0F, -40.0F});
  view_.items[0].scale = {1.0F, 20.0F, 1.0F};
  EXPECT_EQ(list().solid[0].detail, 0U);
}

TEST_F(DrawListTest, ShadowsLieOnTheGroundAwayFromTheLight) {
  view_.camera.eye = {0.0F, 10.0F, 10.0F};
  view_.scenery.ground = 1.0F;
  view_.scenery.toLight = {1.0F, 1.0F, 0.0F};
  add({0.0F, 3.0F, 0.0F});
  const DrawList draws = list();
  ASSERT_EQ(draws.shadows.size(), 1U);
  const glm::vec4 spot = draws.shadows[0].model * glm::vec4(0.0F, 0.0F, 0.0F, 1.0F);
  // 2 m above the ground, light from 45°: the shadow is 2 m to the other side.
  EXPECT_NEAR(spot.x, -2.0F, 1e-5F);
  EXPECT_NEAR(spot.y, 1.0F, 1e-5F);
  EXPECT_NEAR(spot.z, 0.0F, 1e-5F);
}

TEST_F(DrawListTest, NothingCastsAShadowThatCannot) {
  view_.camera.eye = {0.0F, 10.0F, 10.0F};
  add({0.0F, 3.0F, 0.0F});
  EXPECT_TRUE(list().shadows.empty()) << "no ground";
  view_.scenery.ground = 0.0F;
  EXPECT_EQ(list().shadows.size(), 1U);
  view_.items[0].color.a = 0.5F;
  EXPECT_TRUE(list().shadows.empty()) << "a ghost";
  view_.items[0].color.a = 1.0F;
  view_.items[0].pose.position.y = -3.0F;
  EXPECT_TRUE(list().shadows.empty()) << "below the ground";
  view_.items[0].pose.position.y = 3.0F;
  view_.camera.eye.y = -1.0F;
  EXPECT_TRUE(list().shadows.empty()) << "the camera is below the ground";
}

TEST(SceneryGeometry, GridHasABoundedNumberOfLines) {
  View view;
  view.scenery.ground = -1.0F;
  view.scenery.gridStep = 1e-3F;
  EXPECT_LT(groundGrid(view).vertices.size(), 4000U);
  EXPECT_FALSE(groundGrid(view).vertices.empty());
}

TEST(SceneryGeometry, GridStaysInPlaceWhenTheCameraMoves) {
  View view;
  view.scenery.ground = 0.0F;
  view.scenery.gridStep = 2.0F;
  view.camera.eye = {0.7F, 5.0F, 13.3F};
  const PaintedMesh grid = groundGrid(view);
  for (std::size_t i = 0; i < grid.vertices.size(); i += 9) {
    const Vec3& place = grid.vertices[i].position;
    const float off =
        std::min(std::abs(std::remainder(place.x, 2.0F)), std::abs(std::remainder(place.z, 2.0F)));
    EXPECT_NEAR(off, 0.0F, 1e-4F);
  }
}

TEST_F(DrawListTest, ShadowsFallOnAFloorAsFarAsItReaches) {
  add({0.0F, -3.0F, 0.0F});
  view_.items.back().isFloor = true;
  view_.items.back().scale = Vec3(4.0F, 0.5F, 4.0F);
  add({0.0F, -1.0F, 0.0F});
  add({20.0F, -1.0F, 0.0F});
  add({1.0F, -1.0F, 0.0F});
  view_.items.back().castsShadow = false;
  const DrawList draws = list();
  ASSERT_EQ(draws.floors.size(), 1U);
  EXPECT_EQ(draws.floors[0].item, view_.items.data());
  ASSERT_EQ(draws.shadows.size(), 1U);
  EXPECT_EQ(draws.shadows[0].item, &view_.items[1]);
  const glm::vec4 shadow = draws.shadows[0].model * glm::vec4(0.3F, 0.9F, -0.2F, 1.0F);
  EXPECT_NEAR(shadow.y, -2.5F, 1e-4F);
}

TEST_F(DrawListTest, AFloorThatIsSeenFromBelowTakesNoShadows) {
  add({0.0F, 3.0F, 0.0F});
  view_.items.back().isFloor = true;
  add({0.0F, 5.0F, 0.0F});
  EXPECT_TRUE(list().shadows.empty());
}

}  // namespace
}  // namespace scatter::test
