#include "collision/ball_bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "collision/geometry.h"

namespace scatter {
namespace {

using testing::anyInt;
using testing::OwnedPolytope;
using testing::Random;
using testing::randomFrame;

struct Ball {
  Vec3 center;
  float radius;
};

void bound(const std::vector<Ball>& balls, const Frame& frame, Vec3& low, Vec3& high) {
  std::vector<Vec3> centers;
  std::vector<float> radii;
  for (const Ball& ball : balls) {
    centers.push_back(ball.center);
    radii.push_back(ball.radius);
  }
  radii.resize(static_cast<std::size_t>(simd::padded(static_cast<int>(balls.size()))), balls.back().radius);
  boundBalls(OwnedPolytope(centers).view(), radii.data(), frame, low, high);
}

std::vector<Ball> randomBalls(Random& random) {
  std::vector<Ball> balls;
  for (int i = anyInt(random, 1, 40); i > 0; --i) {
    const float radius = i % 3 == 0 ? 0.0F : random.uniform(0.0F, 0.5F);
    balls.push_back({random.inBox(Vec3(3.0F)), radius});
  }
  return balls;
}

// Every ball inside, and one at each of the six sides.
TEST(BallBounds, FitHoweverTheBodyIsTurned) {
  Random random(1);
  for (int trial = 0; trial < 500; ++trial) {
    const std::vector<Ball> balls = randomBalls(random);
    const Frame frame = randomFrame(random, 20.0F);
    Vec3 low;
    Vec3 high;
    bound(balls, frame, low, high);
    for (int axis = 0; axis < 3; ++axis) {
      float least = 1e9F;
      float most = -1e9F;
      for (const Ball& ball : balls) {
        least = std::min(least, frame(ball.center)[axis] - ball.radius);
        most = std::max(most, frame(ball.center)[axis] + ball.radius);
      }
      EXPECT_NEAR(low[axis], least, 1e-5F);
      EXPECT_NEAR(high[axis], most, 1e-5F);
    }
  }
}

}  // namespace
}  // namespace scatter
