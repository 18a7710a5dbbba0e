#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <scatter/world/world.h>

#include <map>
#include <span>
#include <utility>
#include <vector>

namespace scatter {

namespace {

/// Tells the events that it is given.
class FakeSwitching final : public LevelSwitching {
 public:
  std::vector<LevelEvent> events;

  std::span<const LevelEvent> levelEvents() const override { return events; }
};

/// Remembers what it is told; nothing moves.
class FakePhysics final : public Physics {
 public:
  std::map<BodyId, BodyState> bodies;
  std::map<BodyId, Vec3> forces;
  FakeSwitching levels;
  std::vector<float> steps;
  std::string refusal;

  std::string engine() const override { return "fake"; }
  WorldKind kind() const override { return WorldKind::kHybrid; }
  Result<BodyId> createBody(const BodyDef& def) override {
    if (!refusal.empty()) return fail(refusal);
    const BodyId id{++lastId_};
    bodies[id].pose = def.pose;
    bodies[id].centerOfMass = def.pose.position;
    return id;
  }
  void destroyBody(BodyId body) override { bodies.erase(body); }
  BodyState state(BodyId body) const override { return bodies.at(body); }
  void setPose(BodyId body, const Transform& pose) override { bodies.at(body).pose = pose; }
  void setVelocity(BodyId, const Vec3&, const Vec3&) override {}
  void activate(BodyId) override {}
  void applyForce(BodyId, const Vec3&, const Vec3&, bool) override {}
  void applyCentralForce(BodyId body, const Vec3& force, bool wake) override {
    EXPECT_FALSE(wake);
    forces[body] += force;
  }
  void applyTorque(BodyId, const Vec3&) override {}
  void applyImpulse(BodyId, const Vec3&, const Vec3&) override {}
  void setGravity(const Vec3&) override {}
  Result<JointId> createJoint(const JointDef&) override { return JointId{7}; }
  void destroyJoint(JointId) override {}
  Result<VehicleId> createVehicle(const VehicleDef&) override { return VehicleId{8}; }
  void control(VehicleId, const VehicleControl&) override {}
  void destroyVehicle(VehicleId) override {}
  std::optional<RayHit> castRay(const Vec3&, const Vec3&) const override { return std::nullopt; }
  void step(float seconds) override { steps.push_back(seconds); }
  LevelSwitching& switching() override { return levels; }
  const LevelSwitching& switching() const override { return levels; }
  const StepCounters& counters() const override { return counters_; }
  const StageTimes& stageTimes() const override { return times_; }
  void setProfiling(bool) override {}
  std::uint64_t stateHash() const override { return 0; }
  double kineticEnergy() const override { return 0.0; }
  double maxPenetration() const override { return 0.0; }
  std::optional<BodyId> findInvalidState() const override { return std::nullopt; }

 private:
  std::uint32_t lastId_ = 0;
  StepCounters counters_;
  StageTimes times_{};
};

class WorldTest : public testing::Test {
 protected:
  WorldObject& add(const char* name, Shape shape = Box{}) {
    BodyDef def;
    def.name = name;
    def.mass = 3.0F;
    def.shape = std::move(shape);
    const auto object = world.add(def);
    EXPECT_TRUE(object);
    return **object;
  }

  // Owned by the world.
  FakePhysics& physics = *new FakePhysics;
  World world{std::unique_ptr<Physics>(&physics)};
};

std::shared_ptr<const LevelSet> twoLevels() {
  LevelSetDef def;
  def.name = "ball";
  def.levels = {{{{Sphere{1.0F}, {}}}}, {{{Sphere{0.5F}, {}}}}};
  auto levels = LevelSet::create(def);
  EXPECT_TRUE(levels) << levels.error().message;
  return *levels;
}

/// The same acceleration everywhere.
class Wind final : public Field {
 public:
  Vec3 acceleration(const Vec3&) const override { return {1.0F, 2.0F, 0.0F}; }
};

TEST_F(WorldTest, FindsObjectsByNameAndBody) {
  WorldObject& a = add("a");
  WorldObject& b = add("b");
  EXPECT_EQ(world.find("a"), &a);
  EXPECT_EQ(world.find(b.body()), &b);
  EXPECT_EQ(world.find("c"), nullptr);
  EXPECT_EQ(world.find(BodyId{99}), nullptr);
  EXPECT_EQ(a.def().mass, 3.0F);
}

TEST_F(WorldTest, KeepsTheOrderOfObjectsWhenOneIsRemoved) {
  add("a");
  WorldObject& b = add("b");
  add("c");
  const BodyId gone = b.body();
  world.remove(b);
  ASSERT_EQ(world.objects().size(), 2U);
  EXPECT_EQ(world.objects()[0]->name(), "a");
  EXPECT_EQ(world.objects()[1]->name(), "c");
  EXPECT_EQ(world.find("b"), nullptr);
  EXPECT_EQ(world.find(gone), nullptr);
  EXPECT_EQ(physics.bodies.count(gone), 0U);
}

TEST_F(WorldTest, RefusedBodyLeavesNothingBehind) {
  physics.refusal = "no";
  const auto object = world.add(BodyDef{});
  ASSERT_FALSE(object);
  EXPECT_EQ(object.error().message, "no");
  EXPECT_TRUE(world.objects().empty());
}

TEST_F(WorldTest, LevelSetMakesAHybrid) {
  EXPECT_NE(dynamic_cast<HybridObject*>(&add("hybrid", twoLevels())), nullptr);
  EXPECT_EQ(dynamic_cast<HybridObject*>(&add("box")), nullptr);
}

TEST_F(WorldTest, CountsFramesAndTime) {
  for (int i = 0; i < 6; ++i) world.step(0.25F);
  EXPECT_EQ(world.frame(), 6U);
  EXPECT_EQ(world.time(), 1.5);
  EXPECT_EQ(physics.steps, std::vector<float>(6, 0.25F));
}

TEST_F(WorldTest, FieldsPushByMassAndAddUp) {
  const BodyId body = add("a").body();
  world.addField(std::make_unique<Wind>());
  world.addField(std::make_unique<Wind>());
  world.step(0.1F);
  EXPECT_EQ(physics.forces.at(body), Vec3(6.0F, 12.0F, 0.0F));
  world.clearFields();
  physics.forces.clear();
  world.step(0.1F);
  EXPECT_TRUE(physics.forces.empty());
}

TEST_F(WorldTest, FieldsLeaveSomeBodiesAlone) {
  world.addField(std::make_unique<Wind>());
  add("excluded").inFields = false;
  physics.bodies.at(add("asleep").body()).asleep = true;
  BodyDef fixed;
  fixed.motion = Motion::kStatic;
  ASSERT_TRUE(world.add(fixed));
  fixed.motion = Motion::kKinematic;
  ASSERT_TRUE(world.add(fixed));
  world.step(0.1F);
  EXPECT_TRUE(physics.forces.empty());
}

TEST_F(WorldTest, HybridsHearOfTheirRequests) {
  auto& a = dynamic_cast<HybridObject&>(add("a", twoLevels()));
  auto& b = dynamic_cast<HybridObject&>(add("b", twoLevels()));
  WorldObject& box = add("box");
  std::vector<LevelEventKind> heard;
  a.onLevelEvent = [&heard](const LevelEvent& event) { heard.push_back(event.kind); };
  physics.levels.events = {{LevelEventKind::kRequested, Scope::kLocal, a.body(), 2, 1},
                           {LevelEventKind::kBlocked, Scope::kLocal, b.body(), 2, 1},
                           {LevelEventKind::kBlocked, Scope::kLocal, box.body(), 1, 1},
                           {LevelEventKind::kBlocked, Scope::kLocal, BodyId{99}, 2, 1},
                           {LevelEventKind::kSwitched, Scope::kLocal, a.body(), 2, 1}};
  world.step(0.1F);
  EXPECT_THAT(heard, testing::ElementsAre(LevelEventKind::kRequested, LevelEventKind::kSwitched));
}

TEST_F(WorldTest, HybridMayRemoveItselfWhenItHears) {
  auto& a = dynamic_cast<HybridObject&>(add("a", twoLevels()));
  int heard = 0;
  a.onLevelEvent = [&](const LevelEvent&) {
    ++heard;
    world.remove(a);
  };
  physics.levels.events = {{LevelEventKind::kRequested, Scope::kLocal, a.body(), 2, 1},
                           {LevelEventKind::kSwitched, Scope::kLocal, a.body(), 2, 1}};
  world.step(0.1F);
  EXPECT_EQ(heard, 1);
  EXPECT_TRUE(world.objects().empty());
}

TEST_F(WorldTest, AnEngineThatCannotSwitchSaysSo) {
  EXPECT_FALSE(physics.setFrozen(BodyId{1}, true));
  LevelSwitching& switching = physics.Physics::switching();
  EXPECT_EQ(&switching, &std::as_const(physics).Physics::switching());
  EXPECT_EQ(switching.level(BodyId{1}), 1);
  EXPECT_EQ(switching.levelCount(BodyId{1}), 1);
  EXPECT_FALSE(switching.requestLevel(BodyId{1}, 1, Scope::kLocal));
  switching.retractRequest(BodyId{1});
  switching.retractAllRequests();
  EXPECT_EQ(switching.pairLevel(BodyId{1}, BodyId{2}), 0);
  EXPECT_EQ(switching.budgetUnits(), BudgetUnits());
  EXPECT_FALSE(switching.setBudget({.units = 5.0}));
  EXPECT_FALSE(switching.setPolicies(Policy::kNone, {}));
  EXPECT_FALSE(switching.setSwitching(Switching::kBody));
  EXPECT_FALSE(switching.setHeld(BodyId{1}, true));
  switching.setFocus(ViewFocus{});
  EXPECT_TRUE(switching.levelEvents().empty());
}

TEST_F(WorldTest, AnEngineThatTellsNothingLeavesItEmpty) {
  const PhysicsDiagnostics& diagnostics = physics.diagnostics();
  Observation seen;
  seen.bodies.resize(3);
  diagnostics.observe({}, seen);
  EXPECT_TRUE(seen.bodies.empty());
  EXPECT_EQ(diagnostics.measureFidelity().touchingPairs, 0U);
  EXPECT_EQ(diagnostics.contactReport().steps, 0U);
  EXPECT_EQ(diagnostics.collisionMemory().pairs, 0U);
}

}  // namespace
}  // namespace scatter
