#include "viewer/drawing/shadow_map.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "viewer/shapes.h"

namespace scatter::test {
namespace {

using namespace viewer;

constexpr MeshId kBox{0};
constexpr MeshId kTwoSidedSquare{1};

MeshData twoSided(MeshData mesh) {
  mesh.twoSided = true;
  return mesh;
}

/// A view from 20 m, from the front and above, with the light straight from above.
class ShadowMapTest : public testing::Test {
 protected:
  ShadowMapTest() {
    view_.camera.eye = {0.0F, 12.0F, 16.0F};
    view_.scenery.toLight = {0.0F, 1.0F, 0.0F};
    view_.scenery.shadows = Shadows::kEverything;
  }

  Item& add(const Vec3& position, const Vec3& scale, MeshId mesh = kBox) {
    Item& item = view_.items.emplace_back();
    item.mesh = mesh;
    item.pose.position = position;
    item.scale = scale;
    return item;
  }

  [[nodiscard]] bool draw() {
    const PixelArea pixels{0, 0, 640, 400};
    const auto outlineOf = [this](MeshId mesh) -> const MeshOutline& {
      return outlines_[static_cast<std::size_t>(mesh)];
    };
    return map_.draw(view_, pixels, listDraws(view_, pixels, outlineOf), outlineOf);
  }

  /// As the shader has it, at the nearest texel.
  [[nodiscard]] bool isLit(const Vec3& place, const Vec3& normal) const {
    const Vec3 found(map_.fromWorld() * glm::vec4(place + map_.lift() * normal, 1.0F));
    const auto texel = [](float share) { return static_cast<int>(share * ShadowMap::kSize); };
    const int index = texel(found.y) * ShadowMap::kSize + texel(found.x);
    return std::min(found.z, 0.999F) * 0xffffff <=
           static_cast<float>(map_.texels().at(static_cast<std::size_t>(index)));
  }

  View view_;
  ShadowMap map_;
  std::array<MeshOutline, 2> outlines_{outlineOf(makeDetails(boxMesh())),
                                       outlineOf(makeDetails(twoSided(squareMesh())))};
};

const Vec3 kUp(0.0F, 1.0F, 0.0F);

TEST_F(ShadowMapTest, WhatLiesUnderAnItemIsInItsShadow) {
  // The plate's upper side is at 0.
  add({0.0F, -0.5F, 0.0F}, {8.0F, 1.0F, 8.0F});
  add({1.0F, 2.0F, 0.0F}, Vec3(1.0F));
  ASSERT_TRUE(draw());
  EXPECT_FALSE(isLit({1.0F, 0.0F, 0.0F}, kUp));
  EXPECT_FALSE(isLit({1.4F, 0.0F, 0.4F}, kUp));
  EXPECT_TRUE(isLit({1.6F, 0.0F, 0.0F}, kUp));
  EXPECT_TRUE(isLit({-1.0F, 0.0F, 0.0F}, kUp));
  EXPECT_TRUE(isLit({1.0F, 2.5F, 0.0F}, kUp)) << "the box itself";
  EXPECT_FALSE(isLit({1.0F, 1.5F, 0.0F}, -kUp)) << "its lower side";
  // 45 degrees: 2 m above the plate is 2 m to the side.
  view_.scenery.toLight = {1.0F, 1.0F, 0.0F};
  ASSERT_TRUE(draw());
  EXPECT_FALSE(isLit({-1.0F, 0.0F, 0.0F}, kUp));
  EXPECT_TRUE(isLit({1.0F, 0.0F, 0.0F}, kUp));
}

TEST_F(ShadowMapTest, SidesThatTheLightMeetsAreNotSpeckled) {
  // Three boxes that do not shade each other, however they are turned.
  for (const float x : {-3.0F, 0.0F, 3.0F}) add({x, 0.3F * x, 0.0F}, {1.0F, 0.4F, 1.7F});
  for (int turn = 0; turn < 40; ++turn) {
    const float angle = static_cast<float>(turn) * 0.37F;
    view_.scenery.toLight = {0.2F * std::sin(angle), 1.0F, 0.5F * std::cos(angle)};
    for (Item& item : view_.items)
      item.pose.rotation =
          glm::angleAxis(angle + item.pose.position.x, glm::normalize(Vec3(1.0F, 0.4F, 0.7F)));
    ASSERT_TRUE(draw());
    const MeshData box = boxMesh();
    for (const Item& item : view_.items) {
      for (std::size_t corner = 0; corner < box.positions.size(); corner += 4) {
        const Vec3 normal = item.pose.rotation * box.normals[corner];
        if (glm::dot(normal, glm::normalize(view_.scenery.toLight)) < 0.1F) continue;
        const Vec3 u = box.positions[corner + 1] - box.positions[corner];
        const Vec3 v = box.positions[corner + 3] - box.positions[corner];
        for (int i = 0; i < 10; ++i) {
          for (int k = 0; k < 10; ++k) {
            const float right = 0.05F + 0.1F * static_cast<float>(i);
            const float up = 0.05F + 0.1F * static_cast<float>(k);
            const Vec3 place = box.positions[corner] + right * u + up * v;
            EXPECT_TRUE(isLit(item.pose(item.scale * place), normal)) << turn << ", " << right << ", " << up;
          }
        }
      }
    }
  }
}

TEST_F(ShadowMapTest, GhostsWiresAndWallsThrowNone) {
  add({0.0F, -0.5F, 0.0F}, {8.0F, 1.0F, 8.0F}).castsShadow = false;
  add({-2.0F, 2.0F, 0.0F}, Vec3(1.0F)).color.a = 0.5F;
  add({0.0F, 2.0F, 0.0F}, Vec3(1.0F)).wireframe = true;
  EXPECT_FALSE(draw()) << "there is nothing that throws a shadow";
  add({2.0F, 2.0F, 0.0F}, Vec3(1.0F));
  add({-3.5F, 2.0F, 0.0F}, Vec3(0.1F));
  ASSERT_TRUE(draw());
  EXPECT_TRUE(isLit({-2.0F, 0.0F, 0.0F}, kUp));
  EXPECT_TRUE(isLit({0.0F, 0.0F, 0.0F}, kUp));
  EXPECT_FALSE(isLit({2.0F, 0.0F, 0.0F}, kUp));
}

TEST_F(ShadowMapTest, IsThereForShadowsOnEverythingAlone) {
  add({0.0F, 0.0F, 0.0F}, Vec3(1.0F));
  EXPECT_TRUE(draw());
  for (const Shadows shadows : {Shadows::kNothing, Shadows::kGround}) {
    view_.scenery.shadows = shadows;
    EXPECT_FALSE(draw());
  }
}

TEST_F(ShadowMapTest, ASheetThrowsItsShadowFromBothSidesIfItIsSeenFromBoth) {
  add({0.0F, -0.5F, 0.0F}, {8.0F, 1.0F, 8.0F});
  // The square faces up, and away from the light when it is turned over.
  Item& sheet = add({0.0F, 2.0F, 0.0F}, Vec3(1.0F), kTwoSidedSquare);
  for (const float turn : {-glm::half_pi<float>(), glm::half_pi<float>()}) {
    sheet.pose.rotation = glm::angleAxis(turn, Vec3(1.0F, 0.0F, 0.0F));
    ASSERT_TRUE(draw());
    EXPECT_FALSE(isLit({0.0F, 0.0F, 0.0F}, kUp));
  }
}

TEST_F(ShadowMapTest, WhatStandsStillStaysBetweenTexelsWhereItIs) {
  add({0.0F, -0.5F, 0.0F}, {8.0F, 1.0F, 8.0F});
  add({0.0F, 2.0F, 0.0F}, Vec3(1.0F));
  // The map goes along with the only thing that throws a shadow, by whole texels.
  view_.items[0].castsShadow = false;
  const auto texelOf = [&](const Vec3& place) {
    return glm::vec2(map_.fromWorld() * glm::vec4(place, 1.0F)) * static_cast<float>(ShadowMap::kSize);
  };
  ASSERT_TRUE(draw());
  const glm::vec2 first = texelOf({1.0F, 0.0F, 1.0F});
  for (int step = 1; step < 20; ++step) {
    view_.items[1].pose.position.x = 0.0137F * static_cast<float>(step);
    ASSERT_TRUE(draw());
    const glm::vec2 moved = texelOf({1.0F, 0.0F, 1.0F}) - first;
    EXPECT_NEAR(moved.x, std::round(moved.x), 0.02F);
    EXPECT_NEAR(moved.y, std::round(moved.y), 0.02F);
  }
  EXPECT_NE(texelOf({1.0F, 0.0F, 1.0F}), first);
}

TEST_F(ShadowMapTest, IsEmptyAtItsEdgesSoThatThereIsLightAround) {
  // It reaches far beyond what is seen.
  view_.camera.far = 40.0F;
  add({0.0F, 5.0F, 0.0F}, {500.0F, 1.0F, 500.0F});
  add({0.0F, 0.0F, 0.0F}, Vec3(1.0F));
  ASSERT_TRUE(draw());
  std::size_t inside = 0;
  for (int i = 0; i < ShadowMap::kSize; ++i) {
    const auto at = [&](int x, int y) {
      return map_.texels()[static_cast<std::size_t>(y) * ShadowMap::kSize + static_cast<std::size_t>(x)];
    };
    for (const int edge : {0, ShadowMap::kSize - 1}) {
      ASSERT_EQ(at(i, edge), 0xffffffU);
      ASSERT_EQ(at(edge, i), 0xffffffU);
    }
    inside += at(i, ShadowMap::kSize / 2) != 0xffffffU ? 1 : 0;
  }
  EXPECT_EQ(inside, static_cast<std::size_t>(ShadowMap::kSize) - 2U);
}

}  // namespace
}  // namespace scatter::test
