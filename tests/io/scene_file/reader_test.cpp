#include <scatter/io/scene_file.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <string>

namespace scatter {
namespace {

using testing::ElementsAre;

SceneFile parse(const std::string& toml) {
  auto scene = parseSceneFile(toml, "scenes/test.toml");
  EXPECT_TRUE(scene) << scene.error().message;
  return std::move(scene.value());
}

const char* const kBall = "[[object]]\nname = \"ball\"\nsphere = 0.5\n";

TEST(SceneFile, HasTheDefaultsOfTheManual) {
  const SceneFile scene = parse(kBall);
  EXPECT_EQ(scene.summary, "");
  EXPECT_EQ(scene.frames, 600);
  EXPECT_EQ(scene.seed, 1U);
  EXPECT_EQ(scene.gravity, Vec3(0.0F));
  EXPECT_FALSE(scene.solverIterations);
  ASSERT_EQ(scene.objects.size(), 1U);
  const SceneFileObject& ball = scene.objects.front();
  EXPECT_EQ(ball.motion, SceneFileMotion::kDynamic);
  EXPECT_FALSE(ball.mass || ball.density || ball.material.friction || ball.material.restitution);
  EXPECT_TRUE(ball.mayRest && ball.inFields && !ball.sensor);
  EXPECT_EQ(ball.collidesWith, ~0U);
  EXPECT_EQ(std::get<std::vector<Vec3>>(ball.placement), std::vector{Vec3(0.0F)});
  EXPECT_EQ(ball.orientation.rotation, kNoRotation);
  EXPECT_EQ(ball.velocity.vector, Vec3(0.0F));
}

TEST(SceneFile, ReadsTheWorld) {
  const SceneFile scene = parse(std::string(R"([scene]
summary = "a ball"
frames = 90
seed = 12
gravity = [0, -9.81, 0.5]
solver_iterations = 25
)") + kBall);
  EXPECT_EQ(scene.summary, "a ball");
  EXPECT_EQ(scene.frames, 90);
  EXPECT_EQ(scene.seed, 12U);
  EXPECT_EQ(scene.gravity, Vec3(0.0F, -9.81F, 0.5F));
  EXPECT_EQ(scene.solverIterations, 25);
  EXPECT_EQ(scene.path, "scenes/test.toml");
}

TEST(SceneFile, ReadsEveryShape) {
  const SceneFile scene = parse(R"(
object = [
  { name = "a", model = "hunter", levels = 2 },
  { name = "b", box = [3, 0.5, 0.9] },
  { name = "c", sphere = [0.8, 1.6] },
  { name = "d", capsule = { radius = 0.25, length = 2 } },
  { name = "e", cylinder = { radius = 0.5, length = 1 } },
  { name = "f", hull = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]] },
  { name = "g", plane = [0, 2, 0] },
  { name = "h", mesh = "bowls/deep.obj" },
]
)");
  ASSERT_EQ(scene.objects.size(), 8U);
  EXPECT_EQ(std::get<SceneFileModel>(scene.objects[0].shape).name, "hunter");
  EXPECT_EQ(std::get<SceneFileModel>(scene.objects[0].shape).levels, 2U);
  EXPECT_EQ(std::get<Box>(scene.objects[1].shape).halfExtents, Vec3(1.5F, 0.25F, 0.45F));
  EXPECT_EQ(std::get<SceneFileBall>(scene.objects[2].shape).minRadius, 0.8F);
  EXPECT_EQ(std::get<SceneFileBall>(scene.objects[2].shape).maxRadius, 1.6F);
  EXPECT_EQ(std::get<Capsule>(scene.objects[3].shape).radius, 0.25F);
  EXPECT_EQ(std::get<Capsule>(scene.objects[3].shape).halfHeight, 1.0F);
  EXPECT_EQ(std::get<Cylinder>(scene.objects[4].shape).halfHeight, 0.5F);
  EXPECT_EQ(std::get<ConvexHull>(scene.objects[5].shape).vertices.size(), 4U);
  EXPECT_EQ(std::get<SceneFilePlane>(scene.objects[6].shape).normal, Vec3(0.0F, 1.0F, 0.0F));
  EXPECT_EQ(scene.objects[6].motion, SceneFileMotion::kStatic);
  EXPECT_EQ(std::get<SceneFileMesh>(scene.objects[7].shape).file, "bowls/deep.obj");
  EXPECT_EQ(scene.objects[7].motion, SceneFileMotion::kStatic);
}

TEST(SceneFile, ReadsTerrains) {
  const SceneFile scene = parse(R"(
object = [
  { name = "a", terrain = { size = [80, 40], cells = [100, 50], relief = 5 } },
  { name = "b", at = [100, 0, 0], terrain = { size = [8, 4.5], cells = [1, 5], relief = 0, roughness = 0.25, seed = 9, kind = "height_field" } },
]
)");
  const auto& plain = std::get<SceneFileTerrain>(scene.objects[0].shape);
  EXPECT_THAT(plain.size, ElementsAre(80.0F, 40.0F));
  EXPECT_THAT(plain.cells, ElementsAre(100U, 50U));
  EXPECT_EQ(plain.relief, 5.0F);
  EXPECT_EQ(plain.roughness, 0.5F);
  EXPECT_EQ(plain.seed, 1U);
  EXPECT_FALSE(plain.isHeightField);
  EXPECT_EQ(scene.objects[0].motion, SceneFileMotion::kStatic);
  const auto& full = std::get<SceneFileTerrain>(scene.objects[1].shape);
  EXPECT_THAT(full.size, ElementsAre(8.0F, 4.5F));
  EXPECT_EQ(full.roughness, 0.25F);
  EXPECT_EQ(full.seed, 9U);
  EXPECT_TRUE(full.isHeightField);
}

TEST(SceneFile, AGridHasItsRowsAlongXInLayersAlongY) {
  const SceneFile scene = parse(R"([[object]]
name = "crate"
box = [1, 1, 1]
grid = { count = [2, 2, 1], spacing = [2, 3, 1], center = [10, 0, 5] }
)");
  // Half a spacing to each side of the middle.
  EXPECT_THAT(std::get<std::vector<Vec3>>(scene.objects[0].placement),
              ElementsAre(Vec3(9, -1.5F, 5), Vec3(11, -1.5F, 5), Vec3(9, 1.5F, 5), Vec3(11, 1.5F, 5)));
  EXPECT_THAT(scene.bodies, ElementsAre("crate-1", "crate-2", "crate-3", "crate-4"));
}

TEST(SceneFile, PlacesStacksAndRegions) {
  const SceneFile scene = parse(R"(
region = [{ name = "sky", kind = "shell", inner = 2, outer = 5, clearance = 0.5 },
          { name = "room", kind = "box", size = [1, 2, 3], center = [4, 5, 6] },
          { name = "cloud", kind = "ball", radius = 7 }]
object = [{ name = "a", box = [1, 1, 1], stack = { count = 3, base = [1, 0, 0], gap = 0.1 } },
          { name = "b", sphere = 1, in = "cloud", count = 2 },
          { name = "c", sphere = 1, in = "room" }]
)");
  EXPECT_EQ(scene.regions[0].inner, 2.0F);
  EXPECT_EQ(scene.regions[0].clearance, 0.5F);
  EXPECT_EQ(scene.regions[1].kind, SceneFileRegion::Kind::kBox);
  EXPECT_EQ(scene.regions[1].size, Vec3(1, 2, 3));
  EXPECT_EQ(scene.regions[2].outer, 7.0F);
  EXPECT_EQ(scene.objects[0].count, 3U);
  EXPECT_EQ(std::get<SceneFileStack>(scene.objects[0].placement).gap, 0.1F);
  EXPECT_EQ(std::get<SceneFileRandomPlaces>(scene.objects[1].placement).region, 2U);
  EXPECT_THAT(scene.bodies, ElementsAre("a-1", "a-2", "a-3", "b-1", "b-2", "c"));
  EXPECT_EQ(scene.objects[2].firstBody, 5U);
}

TEST(SceneFile, ReadsOrientationsAndVelocities) {
  using Turn = SceneFileOrientation::Kind;
  using Speed = SceneFileVelocity::Kind;
  const SceneFile scene = parse(R"(
object = [{ name = "a", sphere = 1, orientation = "random", velocity = [1, 2, 3], spin = { random = 2 } },
          { name = "b", sphere = 1, orientation = "upright", velocity = { random = 4 } },
          { name = "c", sphere = 1, orientation = { axis = [0, 0, 9], angle = 90 }, velocity = { toward = [1, 1, 1], speed = 5 } },
          { name = "d", sphere = 1, orientation = { quaternion = [0, 0, 2, 0] }, velocity = { away = [1, 1, 1], rate = 0.5 }, spin = [0, 1, 0] }]
)");
  EXPECT_EQ(scene.objects[0].orientation.kind, Turn::kRandom);
  EXPECT_EQ(scene.objects[1].orientation.kind, Turn::kUpright);
  // A quarter turn about z takes x to y.
  const Vec3 turned = scene.objects[2].orientation.rotation * Vec3(1, 0, 0);
  EXPECT_LT(glm::length(turned - Vec3(0, 1, 0)), 1e-6F);
  EXPECT_EQ(scene.objects[3].orientation.rotation, Quat(0, 0, 1, 0));
  EXPECT_EQ(scene.objects[0].velocity.vector, Vec3(1, 2, 3));
  EXPECT_EQ(scene.objects[1].velocity.kind, Speed::kRandom);
  EXPECT_EQ(scene.objects[1].velocity.amount, 4.0F);
  EXPECT_EQ(scene.objects[2].velocity.kind, Speed::kToward);
  EXPECT_EQ(scene.objects[3].velocity.kind, Speed::kAway);
  EXPECT_EQ(scene.objects[3].velocity.amount, 0.5F);
  EXPECT_EQ(scene.objects[0].spin.kind, Speed::kRandom);
  EXPECT_EQ(scene.objects[3].spin.vector, Vec3(0, 1, 0));
}

TEST(SceneFile, KeysOfAnObjectTakePrecedenceOverItsMaterial) {
  const SceneFile scene = parse(R"(
material = [{ name = "ice", friction = 0.05, restitution = 0.5, linear_damping = 0.25 }]
object = [{ name = "a", sphere = 1, material = "ice", restitution = 0.75 }]
)");
  const SceneFileMaterial& material = scene.objects[0].material;
  EXPECT_EQ(material.friction, 0.05F);
  EXPECT_EQ(material.restitution, 0.75F);
  EXPECT_EQ(material.linearDamping, 0.25F);
  EXPECT_FALSE(material.angularDamping);
}

TEST(SceneFile, GroupsSayWhatCollides) {
  const SceneFile scene = parse(R"(
object = [{ name = "a", sphere = 1, group = "red", ignores = ["blue"] },
          { name = "b", sphere = 1, group = "blue", collides_with = ["red", "blue"] },
          { name = "c", sphere = 1 }]
)");
  const auto& [a, b, c] = std::tie(scene.objects[0], scene.objects[1], scene.objects[2]);
  EXPECT_EQ(a.group & b.group, 0U);
  EXPECT_EQ(a.collidesWith, ~b.group);
  EXPECT_EQ(b.collidesWith, a.group | b.group);
  EXPECT_EQ(b.collidesWith & c.group, 0U);
  EXPECT_EQ(c.collidesWith, ~0U);
}

TEST(SceneFile, ReadsJoints) {
  const SceneFile scene = parse(R"(
object = [{ name = "link", sphere = 1, list = [[0, 0, 0], [3, 0, 0]] }, { name = "floor", plane = [0, 1, 0] }]
[[joint]]
kind = "hinge"
a = "link-1"
b = "link-2"
at = [1.5, 0, 0]
axis = [0, 1, 0]
lower = -90
upper = 180
[[joint]]
kind = "six_dof"
a = "link-2"
linear_upper = [0, 2, 0]
angular_lower = [0, 0, 90]
collide = true
)");
  ASSERT_EQ(scene.joints.size(), 2U);
  const SceneFileJoint& hinge = scene.joints[0];
  EXPECT_EQ(hinge.bodyA, 0U);
  EXPECT_EQ(hinge.bodyB, 1U);
  EXPECT_FLOAT_EQ(hinge.lower, -0.5F * glm::pi<float>());
  EXPECT_FLOAT_EQ(hinge.upper, glm::pi<float>());
  // A hinge turns about the z axis of its frame.
  EXPECT_LT(glm::length(hinge.frame.rotation * Vec3(0, 0, 1) - Vec3(0, 1, 0)), 1e-6F);
  const SceneFileJoint& free = scene.joints[1];
  EXPECT_FALSE(free.bodyB);
  EXPECT_TRUE(free.bodiesCollide);
  EXPECT_EQ(free.linearUpper, Vec3(0, 2, 0));
  EXPECT_FLOAT_EQ(free.angularLower.z, 0.5F * glm::pi<float>());
}

TEST(SceneFile, AHingeOrSliderMayPointAnyWay) {
  for (const char* axis : {"[0, 0, 1]", "[0, 0, -1]", "[1, 2, -3]", "[-1, 0, 0]", "[-1, 1e-4, 0]"}) {
    for (const char* kind : {"hinge", "slider"}) {
      const SceneFile scene = parse(std::string(kBall) + "[[joint]]\na = \"ball\"\nkind = \"" + kind +
                                    "\"\naxis = " + axis + "\n");
      const Quat& turn = scene.joints[0].frame.rotation;
      EXPECT_NEAR(glm::length(turn), 1.0F, 1e-6F);
      const Vec3 along = turn * (kind[0] == 'h' ? Vec3(0, 0, 1) : Vec3(1, 0, 0));
      const SceneFile same =
          parse(std::string(kBall) + "[[event]]\ndo = \"knock\"\nframe = 0\ntarget = \"ball\"\n" +
                "impulse = 1\ndirection = " + axis + "\n");
      const Vec3 wanted = std::get<SceneFileKnock>(same.events[0].deed).direction;
      EXPECT_LT(glm::length(along - wanted), 2e-4F) << kind << " " << axis;
    }
  }
}

TEST(SceneFile, ReadsEventsInOrderOfFrames) {
  const SceneFile scene = parse(R"(
field = [{ name = "pull", acceleration = 4, radius = 10, on = false },
         { name = "wind", kind = "uniform", direction = [2, 0, 0], acceleration = 3 }]
object = [{ name = "crate", model = "crate", list = [[0, 0, 0], [3, 0, 0]], group = "things" },
          { name = "ball", sphere = 1, group = "things" }]
event = [{ do = "throw", seconds = 1.5, target = "things", toward = "ball", speed = 7 },
         { do = "break", frame = 30, target = ["crate-2", "crate"], burst = 2, shrink = 0.5 },
         { do = "field", frame = 90, field = "pull", on = true },
         { do = "remove", frame = 20, target = "crate-2" },
         { do = "throw", frame = 90, target = "ball", velocity = [1, 0, 0], spin = [0, 3, 0] }]
)");
  ASSERT_EQ(scene.events.size(), 5U);
  EXPECT_TRUE(std::holds_alternative<SceneFileRemove>(scene.events[0].deed));
  EXPECT_THAT(scene.events[0].bodies, ElementsAre(1U));
  const auto& broken = std::get<SceneFileBreak>(scene.events[1].deed);
  EXPECT_THAT(scene.events[1].bodies, ElementsAre(0U, 1U)) << "each once";
  EXPECT_EQ(broken.burst, 2.0F);
  EXPECT_EQ(broken.shrink, 0.5F);
  EXPECT_EQ(scene.events[2].frame, 90U) << "1.5 s";
  EXPECT_THAT(scene.events[2].bodies, ElementsAre(0U, 1U, 2U));
  EXPECT_EQ(std::get<std::size_t>(std::get<SceneFileThrow>(scene.events[2].deed).target), 2U);
  EXPECT_TRUE(std::get<SceneFileSwitch>(scene.events[3].deed).on);
  EXPECT_EQ(std::get<SceneFileThrow>(scene.events[4].deed).spin, Vec3(0, 3, 0));
  EXPECT_FALSE(scene.fields[0].on);
  EXPECT_EQ(scene.fields[1].direction, Vec3(1, 0, 0));
}

}  // namespace
}  // namespace scatter
