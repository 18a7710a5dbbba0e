#include <gtest/gtest.h>
#include <scatter/bullet/bullet_physics.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "bullet/hybrid/RandomPrograms.h"
#include "bullet/physics/swarm.h"

// A program does with a world, between two steps, whatever the interface lets it: nothing breaks, and a world
// on several threads is the same.

namespace scatter::test {
namespace {

/// Random numbers that are the same everywhere.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  float between(float low, float high) {
    return low + (high - low) * static_cast<float>(engine_() >> 40U) / 16777216.0F;
  }
  std::size_t index(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }
  bool chance(float probability) { return between(0.0F, 1.0F) < probability; }
  Vec3 inCube(float half) {
    const float x = between(-half, half);
    const float y = between(-half, half);
    return {x, y, between(-half, half)};
  }
  Transform pose(float half) {
    const Vec3 place = inCube(half);
    return {place, turn(between(-3.0F, 3.0F), {0.6F, 0.0F, 0.8F})};
  }

 private:
  std::mt19937_64 engine_;
};

class AnyWorld {
 public:
  AnyWorld(std::uint64_t seed, int threads) : dice_(seed) {
    PhysicsDef def;
    def.world = seed % 7 == 0 ? WorldKind::kStandard : WorldKind::kHybrid;
    def.solver = seed % 3 == 0 ? ContactSolver::kWide : ContactSolver::kEngine;
    def.contactsPerDirection = seed % 2 == 0 ? kUsualContactsPerDirection : 0;
    def.collision.pairAlgorithm.recycling = seed % 5 < 2 ? kUsualRecycling : 0.0F;
    def.collision.narrowphase = seed % 11 == 0 ? Narrowphase::kEngine : Narrowphase::kScatter;
    def.switching.switching = seed % 4 == 3 ? Switching::kBody : Switching::kPair;
    def.threads = threads;
    def.profiling = seed % 2 == 1;
    physics_ = makeBulletPhysics(def);
    for (int i = 0; i < 12; ++i) createBody();
  }

  void doAnything() {
    using Deed = void (AnyWorld::*)();
    static constexpr Deed kDeeds[] = {
        &AnyWorld::createBody, &AnyWorld::destroyBody, &AnyWorld::createNonsense, &AnyWorld::move,
        &AnyWorld::push,       &AnyWorld::join,        &AnyWorld::separate,       &AnyWorld::drive,
        &AnyWorld::ask,        &AnyWorld::limit,       &AnyWorld::changeMode,     &AnyWorld::hold,
        &AnyWorld::look,       &AnyWorld::change};
    for (std::size_t i = dice_.index(4); i > 0; --i) (this->*kDeeds[dice_.index(std::size(kDeeds))])();
  }

  void step() {
    for (const BodyId body : bodies_)
      physics_->applyCentralForce(body, -6.0F * physics_->state(body).centerOfMass, dice_.chance(0.9F));
    physics_->step(dice_.chance(0.1F) ? 0.5F * kStep : kStep);
  }

  [[nodiscard]] const Physics& physics() const { return *physics_; }

 private:
  [[nodiscard]] BodyId any() { return bodies_[dice_.index(bodies_.size())]; }

  ConvexShape anyConvex() {
    const float size = dice_.between(0.2F, 0.8F);
    switch (dice_.index(5)) {
      case 0:
        return Box{Vec3(size, 0.6F * size, 0.8F * size)};
      case 1:
        return Sphere{size};
      case 2:
        return Capsule{0.5F * size, 0.5F * size};
      case 3:
        return Cylinder{0.5F * size, 0.5F * size};
      default: {
        ConvexHull hull;
        for (int i = 0; i < 12; ++i) hull.vertices.push_back(dice_.inCube(size));
        return hull;
      }
    }
  }

  Shape anyShape() {
    if (dice_.chance(0.4F)) return levels_;
    if (dice_.chance(0.4F)) {
      Compound compound;
      for (std::size_t i = 1 + dice_.index(5); i > 0; --i)
        compound.parts.push_back({anyConvex(), dice_.pose(0.5F)});
      return compound;
    }
    return std::visit([](auto convex) { return Shape(std::move(convex)); }, anyConvex());
  }

  Shape anyGround() {
    switch (dice_.index(3)) {
      case 0:
        return Plane{{0.0F, 1.0F, 0.0F}, -3.0F};
      case 1: {
        auto field = std::make_shared<HeightField>();
        field->columns = field->rows = 9;
        for (int i = 0; i < 81; ++i) field->heights.push_back(dice_.between(-3.0F, -2.0F));
        return std::shared_ptr<const HeightField>(field);
      }
      default: {
        HeightField field;
        field.columns = field.rows = 7;
        for (int i = 0; i < 49; ++i) field.heights.push_back(dice_.between(-3.0F, -2.0F));
        return std::make_shared<const TriangleMesh>(trianglesOf(field));
      }
    }
  }

  BodyDef anyBody() {
    BodyDef def = bodyAt(dice_.inCube(3.0F), anyShape());
    def.name = "body " + std::to_string(number_++);
    def.pose.rotation = dice_.pose(1.0F).rotation;
    def.mass = dice_.between(0.1F, 10.0F);
    def.linearVelocity = dice_.inCube(3.0F);
    def.material.restitution = dice_.chance(0.2F) ? 0.8F : 0.0F;
    def.material.rollingFriction = dice_.chance(0.2F) ? 0.1F : 0.0F;
    def.mayRest = dice_.chance(0.7F);
    def.sensor = dice_.chance(0.1F);
    if (dice_.chance(0.1F)) def.motion = Motion::kKinematic;
    return def;
  }

  void createBody() {
    if (bodies_.size() > 30) return;
    BodyDef def = anyBody();
    if (dice_.chance(0.15F)) {
      def.shape = anyGround();
      def.motion = Motion::kStatic;
    }
    const Result<BodyId> body = physics_->createBody(def);
    ASSERT_TRUE(body) << body.error().message;
    bodies_.push_back(*body);
  }

  void destroyBody() {
    if (bodies_.size() < 6) return;
    const std::size_t index = dice_.index(bodies_.size());
    // What is joined or drives goes with it.
    for (const JointId joint : joints_) physics_->destroyJoint(joint);
    joints_.clear();
    for (const VehicleId vehicle : vehicles_) physics_->destroyVehicle(vehicle);
    vehicles_.clear();
    physics_->destroyBody(bodies_[index]);
    bodies_.erase(bodies_.begin() + static_cast<std::ptrdiff_t>(index));
  }

  void createNonsense() {
    BodyDef def = anyBody();
    switch (dice_.index(4)) {
      case 0:
        def.mass = -1.0F;
        break;
      case 1:
        def.pose.position.x = std::numeric_limits<float>::quiet_NaN();
        break;
      case 2:
        def.shape = ConvexHull{};
        break;
      default:
        def.shape = Plane{};
    }
    def.motion = Motion::kDynamic;
    EXPECT_FALSE(physics_->createBody(def));
  }

  void move() { physics_->setPose(any(), dice_.pose(3.0F)); }

  void push() {
    const BodyId body = any();
    physics_->setVelocity(body, dice_.inCube(dice_.chance(0.1F) ? 200.0F : 5.0F), dice_.inCube(3.0F));
    physics_->applyImpulse(body, dice_.inCube(2.0F), dice_.inCube(2.0F));
    physics_->applyTorque(body, dice_.inCube(2.0F));
    physics_->activate(body);
  }

  void join() {
    JointDef def;
    def.bodyA = any();
    def.bodyB = any();
    def.frame = dice_.pose(2.0F);
    def.bodiesCollide = dice_.chance(0.5F);
    switch (dice_.index(5)) {
      case 0:
        def.kind = HingeJoint{-0.5F, 0.5F};
        break;
      case 1:
        def.kind = SliderJoint{-0.5F, 0.5F};
        break;
      case 2:
        def.kind = FixedJoint{};
        break;
      case 3:
        def.kind = SixDofJoint{};
        break;
      default:
        def.kind = PointJoint{};
    }
    if (const Result<JointId> joint = physics_->createJoint(def)) joints_.push_back(*joint);
  }

  void separate() {
    if (joints_.empty()) return;
    physics_->destroyJoint(joints_.back());
    joints_.pop_back();
  }

  void drive() {
    VehicleDef def;
    def.chassis = any();
    def.wheels.push_back({.connection = {0.5F, 0.0F, 0.5F}, .steered = true, .driven = true});
    def.wheels.push_back({.connection = {-0.5F, 0.0F, -0.5F}, .driven = true});
    if (vehicles_.size() < 2) {
      if (const Result<VehicleId> vehicle = physics_->createVehicle(def)) vehicles_.push_back(*vehicle);
    }
    for (const VehicleId vehicle : vehicles_)
      physics_->control(vehicle, {.engineForce = 5.0F, .steering = dice_.between(-0.5F, 0.5F)});
  }

  void ask() {
    LevelSwitching& levels = physics_->switching();
    const BodyId body = any();
    levels.requestLevel(body, 1 + static_cast<int>(dice_.index(4)),
                        dice_.chance(0.5F) ? Scope::kLocal : Scope::kGlobal);
    if (dice_.chance(0.3F)) levels.retractRequest(body);
    if (dice_.chance(0.1F)) levels.retractAllRequests();
  }

  void limit() {
    LevelSwitching& levels = physics_->switching();
    switch (dice_.index(5)) {
      case 0:
        levels.setBudget({});
        break;
      case 1:
        levels.setBudget({.milliseconds = 0.2, .machine = {0.001, 0.002}});
        break;
      case 2:
        static_cast<void>(levels.setPolicies(Policy::kNone, {"speed", "contact-time"}));
        break;
      case 3:
        static_cast<void>(levels.setPolicies(static_cast<Policy>(dice_.index(4)), {}));
        break;
      default:
        levels.setBudget({.units = static_cast<double>(dice_.between(10.0F, 400.0F))});
    }
  }

  void changeMode() {
    if (dice_.chance(0.8F)) return;
    static_cast<void>(
        physics_->switching().setSwitching(dice_.chance(0.5F) ? Switching::kPair : Switching::kBody));
  }

  void hold() {
    const BodyId body = any();
    physics_->switching().setHeld(body, dice_.chance(0.5F));
    physics_->setFrozen(body, dice_.chance(0.5F));
  }

  void look() {
    static_cast<void>(physics_->castRay(dice_.inCube(6.0F), dice_.inCube(6.0F)));
    Observation seen;
    physics_->diagnostics().observe({.bodies = true, .pairs = true, .contacts = true}, seen);
    static_cast<void>(physics_->diagnostics().measureFidelity());
    std::vector<std::uint8_t> levels;
    physics_->switching().coarsestLevels(levels);
    static_cast<void>(physics_->switching().pairLevel(any(), any()));
    static_cast<void>(physics_->maxPenetration());
  }

  void change() {
    physics_->setGravity(dice_.inCube(3.0F));
    physics_->setProfiling(dice_.chance(0.5F));
    physics_->switching().setFocus(ViewFocus{dice_.inCube(9.0F), dice_.inCube(1.0F), 1.0F});
  }

  Dice dice_;
  std::shared_ptr<const LevelSet> levels_ = crossLevels();
  std::unique_ptr<Physics> physics_;
  std::vector<BodyId> bodies_;
  std::vector<JointId> joints_;
  std::vector<VehicleId> vehicles_;
  int number_ = 0;
};

TEST(RandomWorldUse, BreaksNothingAndIsTheSameOnThreads) {
  for (const std::uint64_t seed : programs(60)) {
    AnyWorld one(seed, 1);
    AnyWorld other(seed, 3);
    for (int step = 0; step < 120; ++step) {
      for (AnyWorld* world : {&one, &other}) {
        world->doAnything();
        world->step();
        ASSERT_FALSE(world->physics().findInvalidState()) << "world " << seed << ", step " << step;
      }
      ASSERT_EQ(one.physics().stateHash(), other.physics().stateHash())
          << "world " << seed << ", step " << step;
    }
  }
}

}  // namespace
}  // namespace scatter::test
