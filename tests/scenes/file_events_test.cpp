// What events of a scene file do.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "scenes/file_world.h"

namespace scatter::test {
namespace {

/// The momentum of all dynamic bodies, kg m/s.
Vec3 momentum(const World& world) {
  Vec3 sum(0.0F);
  for (const auto& object : world.objects()) {
    if (object->def().motion == Motion::kDynamic) sum += object->def().mass * object->state().linearVelocity;
  }
  return sum;
}

TEST(FileEvents, HappenInTheirFrame) {
  FileWorld scene(R"(
object = [{ name = "a", sphere = 1 }, { name = "b", sphere = 1, at = [9, 0, 0] }]
event = [{ do = "throw", frame = 3, target = "a", velocity = [1, 0, 0] },
         { do = "remove", seconds = 0.1, target = "b" }]
)");
  scene.step(3);
  EXPECT_EQ(scene.state("a").linearVelocity, Vec3(0.0F));
  scene.step();
  EXPECT_EQ(scene.state("a").linearVelocity, Vec3(1, 0, 0));
  scene.step(2);
  EXPECT_TRUE(scene.has("b")) << "0.1 s is frame 6";
  scene.step();
  EXPECT_FALSE(scene.has("b"));
}

TEST(FileEvents, AThrowGoesTowardAPointOrABody) {
  FileWorld scene(R"(
object = [{ name = "target", sphere = 1, at = [0, 10, 0], motion = "static" },
          { name = "a", sphere = 1, at = [0, 0, 0], spin = [1, 2, 3] }, { name = "b", sphere = 1, at = [9, 0, 0], spin = [1, 2, 3] }]
event = [{ do = "throw", frame = 0, target = "a", toward = "target", speed = 4 },
         { do = "throw", frame = 0, target = ["b", "target"], toward = [9, 0, 7], speed = 2, spin = [0, 0, 0] }]
)");
  scene.step();
  EXPECT_LT(distance(scene.state("a").linearVelocity, Vec3(0, 4, 0)), 1e-5F);
  EXPECT_LT(distance(scene.state("a").angularVelocity, Vec3(1, 2, 3)), 1e-5F) << "kept";
  EXPECT_LT(distance(scene.state("b").linearVelocity, Vec3(0, 0, 2)), 1e-5F);
  EXPECT_EQ(scene.state("b").angularVelocity, Vec3(0.0F));
  EXPECT_EQ(scene.state("target").pose.position, Vec3(0, 10, 0));
}

TEST(FileEvents, AKnockChangesTheMomentumByItsImpulse) {
  FileWorld scene(R"(
object = [{ name = "a", box = [1, 1, 1], mass = 4, orientation = { axis = [0, 1, 0], angle = 90 } },
          { name = "b", box = [1, 1, 1], mass = 4, at = [9, 0, 0] }]
event = [{ do = "knock", frame = 0, target = "a", direction = [5, 0, 0], impulse = 12, body_frame = true },
         { do = "knock", frame = 0, target = "b", direction = [0, 3, 0], speed = 2 }]
)");
  scene.step();
  // A quarter turn about y takes x to -z; 12 Ns on 4 kg.
  EXPECT_LT(distance(scene.state("a").linearVelocity, Vec3(0, 0, -3)), 1e-5F);
  EXPECT_LT(distance(scene.state("b").linearVelocity, Vec3(0, 2, 0)), 1e-5F);
  EXPECT_LT(glm::length(scene.state("a").angularVelocity), 1e-5F);
}

TEST(FileEvents, ABreakKeepsMassAndMomentum) {
  FileWorld scene(R"(
object = [{ name = "table", model = "table", velocity = [3, 1, 0], spin = [0, 2, 1], orientation = "random" }]
event = [{ do = "break", frame = 1, target = "table", burst = 2, shrink = 0.8 }]
)");
  scene.step();
  const Vec3 before = momentum(scene.world);
  const auto levels = std::get<std::shared_ptr<const LevelSet>>(scene["table"].def().shape);
  scene.step();
  EXPECT_FALSE(scene.has("table"));
  EXPECT_EQ(scene.world.objects().size(), levels->finest().parts.size());
  float mass = 0.0F;
  for (const auto& object : scene.world.objects()) mass += object->def().mass;
  EXPECT_NEAR(mass, 25.0F, 1e-3F);
  EXPECT_LT(distance(momentum(scene.world), before), 0.05F * glm::length(before));
}

TEST(FileEvents, ABreakLeavesTheGibsThatTheObjectNames) {
  FileWorld scene(R"(
object = [{ name = "box", box = [2, 2, 2], mass = 6, gibs = ["mug", "lamp"], in_fields = false }]
event = [{ do = "break", frame = 0, target = "box" }, { do = "throw", frame = 1, target = "box", velocity = [1, 1, 1] }]
)");
  scene.step(2);
  ASSERT_EQ(scene.world.objects().size(), 2U);
  EXPECT_NEAR(scene["box-gib-1"].def().mass + scene["box-gib-2"].def().mass, 6.0F, 1e-5F);
  EXPECT_FALSE(scene["box-gib-1"].inFields) << "as the whole";
}

TEST(FileEvents, TooManyPiecesAreRefused) {
  EXPECT_THAT(FileWorld::errorOf("region = [{ name = \"r\", kind = \"ball\", radius = 500 }]\n"
                                 "object = [{ name = \"s\", model = \"shelf\", in = \"r\", count = 600 }]\n"
                                 "event = [{ do = \"break\", frame = 1, target = \"s\" }]\n"),
              testing::StartsWith("test.toml:3: the bodies break into more than 20000 pieces"));
}

TEST(FileEvents, AFieldThatComesOnWakesWhatSleeps) {
  FileWorld scene(R"(
scene = { gravity = [0, -9.81, 0] }
field = [{ name = "up", kind = "uniform", direction = [0, 1, 0], acceleration = 12, on = false }]
object = [{ name = "floor", plane = [0, 1, 0] }, { name = "box", box = [1, 1, 1], at = [0, 0.5, 0] }]
event = [{ do = "field", frame = 300, field = "up", on = true }, { do = "field", frame = 330, field = "up", on = false }]
)");
  scene.step(300);
  EXPECT_TRUE(scene.state("box").asleep);
  scene.step(30);
  EXPECT_NEAR(scene.state("box").linearVelocity.y, (12.0F - 9.81F) * 0.5F, 0.1F);
  scene.step(6);
  EXPECT_NEAR(scene.state("box").linearVelocity.y, (12.0F - 9.81F) * 0.5F - 9.81F * 0.1F, 0.1F);
}

TEST(FileEvents, WhatIsGoneIsPassedOver) {
  FileWorld scene(R"(
object = [{ name = "a", model = "crate" }, { name = "b", sphere = 1, at = [9, 0, 0] }]
joint = [{ kind = "fixed", a = "a", b = "b" }]
event = [{ do = "remove", frame = 0, target = "a" }, { do = "remove", frame = 1, target = "a" },
         { do = "break", frame = 1, target = "a" }, { do = "throw", frame = 1, target = "b", toward = "a", speed = 1 },
         { do = "knock", frame = 1, target = ["a", "b"], direction = [0, 1, 0], speed = 1 }]
)");
  scene.step(3);
  EXPECT_EQ(scene.world.objects().size(), 1U);
  EXPECT_LT(distance(scene.state("b").linearVelocity, Vec3(0, 1, 0)), 1e-5F);
}

TEST(FileEvents, WhatSomebodyElseRemovesIsPassedOver) {
  FileWorld scene(R"(
object = [{ name = "a", model = "crate" }, { name = "b", sphere = 1, at = [9, 0, 0] }]
event = [{ do = "throw", frame = 1, target = "b", toward = "a", speed = 1 }, { do = "remove", frame = 1, target = "a" },
         { do = "knock", frame = 1, target = ["a", "b"], direction = [0, 1, 0], speed = 1 },
         { do = "break", frame = 1, target = "a" }]
)");
  scene.step();
  scene.remove("a");
  scene.step(2);
  EXPECT_EQ(scene.world.objects().size(), 1U);
  EXPECT_LT(distance(scene.state("b").linearVelocity, Vec3(0, 1, 0)), 1e-5F);
}

}  // namespace
}  // namespace scatter::test
