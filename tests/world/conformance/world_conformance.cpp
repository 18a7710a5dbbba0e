#include <scatter/world/world.h>
#include <glm/geometric.hpp>
#include <random>

#include "world/conformance/physics_conformance.h"

namespace scatter::test {

namespace {

PhysicsDef definition(WorldKind world, const Vec3& gravity = Vec3(0.0F)) {
  PhysicsDef def;
  def.world = world;
  def.gravity = gravity;
  return def;
}

/// From -1 to 1; the same everywhere.
float uniform(std::mt19937_64& random) {
  return static_cast<float>(random() >> 40U) / static_cast<float>(1U << 23U) - 1.0F;
}

/// Bodies of all kinds, drawn together and falling on the ground.
void fill(World& world) {
  Compound cross;
  cross.parts.push_back({Box{{0.6F, 0.1F, 0.1F}}, {}});
  cross.parts.push_back({Capsule{0.1F, 0.4F}, {}});
  ConvexHull hull;
  hull.vertices = {{-0.4F, 0, 0}, {0.4F, 0, 0}, {0, 0.5F, 0}, {0, 0, 0.5F}, {0, -0.2F, -0.3F}};
  const std::vector<Shape> shapes{
      Box{Vec3(0.3F)}, Sphere{0.3F}, Capsule{0.2F, 0.3F}, Cylinder{0.3F, 0.2F}, hull, cross, cubeLevels()};
  std::mt19937_64 random(7);
  for (int i = 0; i < 42; ++i) {
    BodyDef def = bodyAt({}, shapes[static_cast<std::size_t>(i) % shapes.size()]);
    def.pose.position = {3.0F * uniform(random), 4.0F + 3.0F * uniform(random), 3.0F * uniform(random)};
    def.pose.rotation = turn(3.0F * uniform(random), {uniform(random), uniform(random), 1.5F});
    def.angularVelocity = {uniform(random), uniform(random), uniform(random)};
    def.mayRest = true;
    ASSERT_TRUE(world.add(def));
  }
  BodyDef ground = bodyAt({}, Plane{});
  ground.motion = Motion::kStatic;
  ASSERT_TRUE(world.add(ground));
  world.addField(std::make_unique<PointField>(Vec3(0.0F, 2.0F, 0.0F), 4.0F, 20.0F));
}

/// Leaves gaps on the heap that are filled in a random order, so that what is allocated one after the other
/// does not lie one after the other.
class ShuffledHeap {
 public:
  ShuffledHeap() {
    constexpr std::size_t kBlocks = 4000;
    std::mt19937_64 random(3);
    std::vector<std::unique_ptr<char[]>> gaps;
    for (std::size_t i = 0; i < kBlocks; ++i) {
      const std::size_t size = 48 + 16 * (i % 8);
      gaps.push_back(std::make_unique<char[]>(size));
      walls_.push_back(std::make_unique<char[]>(size));
    }
    for (std::size_t i = kBlocks - 1; i > 0; --i) std::swap(gaps[i], gaps[random() % (i + 1)]);
    for (auto& gap : gaps) gap.reset();
  }

 private:
  std::vector<std::unique_ptr<char[]>> walls_;
};

std::vector<std::uint64_t> hashesOf(World& world, int steps) {
  std::vector<std::uint64_t> hashes;
  for (int i = 0; i < steps; ++i) {
    world.step(kStep);
    hashes.push_back(world.physics().stateHash());
  }
  return hashes;
}

}  // namespace

TEST_P(PhysicsConformance, FieldPullsInsideItsRadiusOnly) {
  World world(GetParam().make(definition(GetParam().world)));
  world.addField(std::make_unique<PointField>(Vec3(0.0F), 6.0F, 10.0F));
  const auto inside = world.add(bodyAt({5.0F, 0.0F, 0.0F}));
  const auto outside = world.add(bodyAt({0.0F, 11.0F, 0.0F}));
  BodyDef heavy = bodyAt({0.0F, 0.0F, 5.0F});
  heavy.mass = 200.0F;
  const auto heavyInside = world.add(heavy);
  ASSERT_TRUE(inside && outside && heavyInside);
  for (int i = 0; i < 30; ++i) world.step(kStep);
  expectNear((*inside)->state().linearVelocity, {-3.0F, 0.0F, 0.0F}, 1e-3F);
  expectNear((*heavyInside)->state().linearVelocity, {0.0F, 0.0F, -3.0F}, 1e-3F);
  expectNear((*outside)->state().linearVelocity, Vec3(0.0F), 1e-6F);
}

TEST_P(PhysicsConformance, FastBodyEscapesTheField) {
  World world(GetParam().make(definition(GetParam().world)));
  world.addField(std::make_unique<PointField>(Vec3(0.0F), 5.0F, 10.0F));
  // It needs v^2 / 2 > 5 * 10 to leave from the centre: 10 m/s.
  BodyDef fast = bodyAt({0.1F, 0.0F, 0.0F});
  fast.linearVelocity = {11.0F, 0.0F, 0.0F};
  BodyDef slow = bodyAt({0.0F, 0.1F, 0.0F});
  slow.linearVelocity = {0.0F, 9.0F, 0.0F};
  const auto escapes = world.add(fast);
  const auto stays = world.add(slow);
  ASSERT_TRUE(escapes && stays);
  for (int i = 0; i < 600; ++i) {
    world.step(kStep);
    EXPECT_LT(glm::length((*stays)->state().pose.position), 10.0F);
  }
  EXPECT_GT((*escapes)->state().pose.position.x, 20.0F);
}

TEST_P(PhysicsConformance, FieldPullsAtTheCenterOfMass) {
  World world(GetParam().make(definition(GetParam().world)));
  world.addField(std::make_unique<PointField>(Vec3(0.0F), 6.0F, 10.0F));
  // The model's origin is inside the radius, its centre of mass is not.
  Compound offset;
  offset.parts.push_back({Sphere{0.5F}, {{3.0F, 0.0F, 0.0F}, kNoRotation}});
  const auto body = world.add(bodyAt({8.0F, 0.0F, 0.0F}, offset));
  ASSERT_TRUE(body);
  world.step(kStep);
  EXPECT_EQ((*body)->state().linearVelocity, Vec3(0.0F));
}

TEST_P(PhysicsConformance, SameSceneSameHashes) {
  constexpr int kSteps = 300;
  std::vector<std::uint64_t> first;
  {
    World world(GetParam().make(definition(GetParam().world, kEarth)));
    fill(world);
    first = hashesOf(world, kSteps);
  }
  const ShuffledHeap heap;
  World world(GetParam().make(definition(GetParam().world, kEarth)));
  fill(world);
  EXPECT_EQ(hashesOf(world, kSteps), first);
}

TEST_P(PhysicsConformance, HashTellsStatesApart) {
  const auto hashOf = [](const BodyDef& def) {
    auto physics = GetParam().make(definition(GetParam().world));
    EXPECT_TRUE(physics->createBody(bodyAt({9.0F, 0.0F, 0.0F})));
    EXPECT_TRUE(physics->createBody(def));
    return physics->stateHash();
  };
  const BodyDef def = bodyAt({1.0F, 2.0F, 3.0F});
  const std::uint64_t hash = hashOf(def);
  EXPECT_EQ(hashOf(def), hash);
  BodyDef moved = def;
  moved.pose.position.x = std::nextafter(1.0F, 2.0F);
  EXPECT_NE(hashOf(moved), hash);
  BodyDef faster = def;
  faster.linearVelocity.y = 1e-30F;
  EXPECT_NE(hashOf(faster), hash);
  BodyDef spinning = def;
  spinning.angularVelocity.z = -0.0F;
  EXPECT_NE(hashOf(spinning), hash);
}

TEST_P(PhysicsConformance, LevelsSwitchOnlyInAHybridWorld) {
  World world(GetParam().make(definition(GetParam().world)));
  const auto added = world.add(bodyAt(Vec3(0.0F), cubeLevels()));
  const auto plain = world.add(bodyAt({20.0F, 0.0F, 0.0F}));
  ASSERT_TRUE(added && plain);
  auto* hybrid = dynamic_cast<HybridObject*>(*added);
  ASSERT_NE(hybrid, nullptr);
  EXPECT_EQ(dynamic_cast<HybridObject*>(*plain), nullptr);
  EXPECT_EQ(hybrid->levelCount(), 2);
  EXPECT_EQ(hybrid->level(), 2);
  EXPECT_EQ(world.physics().switching().levelCount((*plain)->body()), 1);
  EXPECT_EQ(world.physics().switching().level((*plain)->body()), 1);
  EXPECT_FALSE(world.physics().switching().requestLevel((*plain)->body(), 1, Scope::kLocal));
  EXPECT_FALSE(hybrid->requestLevel(3));
  EXPECT_FALSE(hybrid->requestLevel(0));

  const bool switches = GetParam().world == WorldKind::kHybrid;
  std::vector<LevelEvent> told;
  hybrid->onLevelEvent = [&told](const LevelEvent& event) { told.push_back(event); };
  EXPECT_EQ(hybrid->requestLevel(1, Scope::kGroup), switches);
  world.step(kStep);
  EXPECT_EQ(hybrid->level(), switches ? 1 : 2);
  EXPECT_EQ(world.physics().counters().switchesCoarser, switches ? 1U : 0U);
  if (!switches) {
    EXPECT_TRUE(told.empty());
    return;
  }
  ASSERT_EQ(told.size(), 3U);
  EXPECT_EQ(told[0].kind, LevelEventKind::kRequested);
  EXPECT_EQ(told[1].kind, LevelEventKind::kAcknowledged);
  EXPECT_EQ(told[2].kind, LevelEventKind::kSwitched);
  for (const LevelEvent& event : told) {
    EXPECT_EQ(event.body, hybrid->body());
    EXPECT_EQ(event.scope, Scope::kGroup);
    EXPECT_EQ(event.from, 2);
    EXPECT_EQ(event.to, 1);
  }
  world.step(kStep);
  EXPECT_EQ(told.size(), 3U);
}

}  // namespace scatter::test
