#include "viewer/drawing/projection.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace scatter::test {
namespace {

using namespace viewer;

constexpr glm::ivec2 kWindow{800, 400};

TEST(Projection, TargetIsInTheMiddleOfItsArea) {
  View view;
  view.area = {0.5F, 0.0F, 0.5F, 1.0F};
  view.camera.eye = {3.0F, 4.0F, 5.0F};
  view.camera.target = {1.0F, 1.0F, 1.0F};
  const auto pixel = pixelOf(view, kWindow, view.camera.target);
  ASSERT_TRUE(pixel.has_value());
  EXPECT_NEAR(pixel->x, 600.0F, 1e-2F);
  EXPECT_NEAR(pixel->y, 200.0F, 1e-2F);
}

TEST(Projection, NothingBehindTheCameraHasAPixel) {
  EXPECT_FALSE(pixelOf(View{}, kWindow, {0.0F, 0.0F, 11.0F}).has_value());
}

TEST(Projection, RayGoesThroughThePointThatIsSeenThere) {
  View view;
  view.area = {0.25F, 0.25F, 0.5F, 0.75F};
  view.camera.eye = {3.0F, 4.0F, 5.0F};
  const Vec3 point(0.5F, -0.7F, 0.9F);
  const Ray ray = rayThrough(view, kWindow, pixelOf(view, kWindow, point).value());
  EXPECT_EQ(ray.origin, view.camera.eye);
  EXPECT_NEAR(glm::length(glm::cross(ray.direction, point - ray.origin)), 0.0F, 1e-4F);
  EXPECT_GT(glm::dot(ray.direction, point - ray.origin), 0.0F);
}

TEST(Projection, AreasTileTheWindow) {
  const PixelArea left = pixelsOf({0.0F, 0.0F, 1.0F / 3.0F, 1.0F}, {100, 50});
  const PixelArea middle = pixelsOf({1.0F / 3.0F, 0.0F, 1.0F / 3.0F, 1.0F}, {100, 50});
  const PixelArea right = pixelsOf({2.0F / 3.0F, 0.0F, 1.0F / 3.0F, 1.0F}, {100, 50});
  EXPECT_EQ(left.left + left.width, middle.left);
  EXPECT_EQ(middle.left + middle.width, right.left);
  EXPECT_EQ(right.left + right.width, 100);
  EXPECT_EQ(pixelsOf({0.5F, 0.5F, 0.0F, 0.0F}, {100, 50}).width, 1);
}

TEST(Projection, UppermostViewHasThePixel) {
  Picture picture;
  picture.views.resize(2);
  picture.views[1].area = {0.5F, 0.5F, 0.25F, 0.25F};
  EXPECT_EQ(viewAt(picture, kWindow, {450.0F, 250.0F}), 1U);
  EXPECT_EQ(viewAt(picture, kWindow, {10.0F, 10.0F}), 0U);
  EXPECT_EQ(viewAt(picture, kWindow, {810.0F, 10.0F}), std::nullopt);
}

}  // namespace
}  // namespace scatter::test
