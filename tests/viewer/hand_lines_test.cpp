#include "viewer/hand_lines.h"

#include <gtest/gtest.h>
#include <scatter/bullet/bullet_physics.h>
#include <scatter/lab/hands.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <memory>
#include <vector>

namespace scatter::viewer {
namespace {

TEST(Spring, JoinsWhatIsHeldWithWhereItIsPulled) {
  World world(makeBulletPhysics({}));
  BodyDef ball;
  ball.name = "ball";
  ball.shape = Sphere{0.5F};
  const auto added = world.add(ball);
  ASSERT_TRUE(added) << added.error().message;
  Hands hands(world);
  std::vector<Line> lines;
  addSpring(hands, lines);
  EXPECT_TRUE(lines.empty());
  ASSERT_TRUE(hands.drag((*added)->body(), {0.0F, 0.5F, 0.0F}));
  addSpring(hands, lines);
  EXPECT_TRUE(lines.empty()) << "it has no length yet";
  const Vec3 target(3.0F, 4.5F, 0.0F);
  hands.dragTo(target);
  addSpring(hands, lines);
  ASSERT_FALSE(lines.empty());
  EXPECT_LT(glm::distance(lines.back().to, target), 1e-4F);
  const Vec3 way = glm::normalize(target - hands.grip());
  float widest = 0.0F;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(lines[i].from, i > 0 ? lines[i - 1].to : hands.grip());
    const Vec3 out = lines[i].from - hands.grip();
    widest = std::max(widest, glm::length(out - glm::dot(out, way) * way));
  }
  EXPECT_GT(widest, 0.05F) << "a line, not a spring";
  EXPECT_LT(widest, 0.5F);
}

}  // namespace
}  // namespace scatter::viewer
