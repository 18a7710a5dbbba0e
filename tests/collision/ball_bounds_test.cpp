#include "collision/ball_bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "collision/geometry.h"
#include "collision/simd.h"

namespace scatter {
namespace {

using testing::anyInt;
using testing::Random;
using testing::randomFrame;

struct Ball {
  Vec3 center;
  float radius;
};

/// Balls as BallsView wants them.
class OwnedBalls {
 public:
  explicit OwnedBalls(const std::vector<Ball>& balls) {
    const int padded = simd::padded(static_cast<int>(balls.size()));
    for (int i = 0; i < padded; ++i) {
      const Ball& ball = balls[std::min(static_cast<std::size_t>(i), balls.size() - 1)];
      for (int axis = 0; axis < 3; ++axis) values_[axis].push_back(ball.center[axis]);
      values_[3].push_back(ball.radius);
    }
  }

  [[nodiscard]] BallsView view() const {
    return {values_[0].data(), values_[1].data(), values_[2].data(), values_[3].data(),
            static_cast<int>(values_[0].size())};
  }

 private:
  std::vector<float> values_[4];
};

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
    boundBalls(OwnedBalls(balls).view(), frame, low, high);
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
