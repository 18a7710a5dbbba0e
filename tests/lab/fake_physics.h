#pragma once

#include <scatter/lab/run.h>
#include <scatter/world/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace scatter::test {

/// What a FakePhysics does out of the ordinary.
struct FakeBehaviour {
  std::uint64_t hashFlipStep = 0;  ///< From this step on the state hash is another one; 0: never.
  std::uint64_t invalidStep = 0;   ///< In this step the first body's position is lost; 0: never.
  std::uint64_t missedStep = 0;    ///< In this step, if verified, three contacts are missed; 0: never.
  double penetration = 0.25;       ///< In every step.
  std::optional<PairWork> work{};  ///< Of every step, in the place of the usual.
  std::uint64_t jumpStep =
      0;  ///< In this step the first body is moved 0.5 m up, whatever its velocity; 0: never.
  /// Of the steps in order, the last one ever after: what they cost, and what of it could not be given up. A
  /// step below 100 units has given up some detail, and a contact.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> costs{};
  bool countsTouching =
      false;  ///< Counts touching pairs in every step: 10, of which one is coarse in step 7,
  std::uint64_t coarseUntil = 0;  ///< and five in all up to this one.
};

/// Reports a budget that follows from the step count alone, and the events that FakePhysics makes up.
class FakeSwitching final : public LevelSwitching {
 public:
  std::uint64_t steps = 0;
  std::vector<LevelEvent> events;

  BudgetUnits budgetUnits() const override {
    const auto units = static_cast<double>(steps);
    return {units / 7.0, units / 8.0, units / 9.0};
  }
  std::span<const LevelEvent> levelEvents() const override { return events; }
};

/// Reports numbers that follow from what FakePhysics counts.
class FakeDiagnostics final : public PhysicsDiagnostics {
 public:
  std::uint32_t step = 0;
  std::uint64_t childPairs = 0;
  ContactReport contacts;

  /// In step n: n pairs that touch finely, three that touch one level coarser, 1, 2 and 3 m apart, and n % 4
  /// visible overlaps.
  FidelitySample measureFidelity() const override {
    return {.touchingPairs = step + 3,
            .touchingByLevel = {step, 3},
            .visibleOverlapPairs = step % 4,
            .contactGaps = {1.0F, 2.0F, 3.0F}};
  }
  ContactReport contactReport() const override { return contacts; }
  CollisionMemory collisionMemory() const override {
    const std::uint64_t pairs = childPairs / 5;
    return {.pairs = pairs,
            .childPairs = childPairs,
            .pairBytes = 900 * pairs,
            .childPairBytes = 56 * childPairs,
            .bodyBytes = 7,
            .partBytes = 8};
  }
};

/// Moves bodies in straight lines and reports numbers that follow from the step count alone.
class FakePhysics final : public Physics {
 public:
  explicit FakePhysics(const PhysicsDef& def, FakeBehaviour behaviour = {})
      : def_(def), behaviour_(behaviour) {}

  std::string engine() const override { return "fake 1.0"; }
  WorldKind kind() const override { return def_.world; }

  Result<BodyId> createBody(const BodyDef& def) override {
    if (!(def.mass > 0.0F)) {
      return fail("body '" + def.name + "' has no mass; give it one");
    }
    states_.push_back(
        {.pose = def.pose, .linearVelocity = def.linearVelocity, .angularVelocity = def.angularVelocity});
    return static_cast<BodyId>(states_.size() - 1);
  }
  void destroyBody(BodyId /*body*/) override {}
  BodyState state(BodyId body) const override {
    BodyState state = states_[static_cast<std::size_t>(body)];
    state.centerOfMass = state.pose.position;
    return state;
  }
  void setPose(BodyId body, const Transform& pose) override {
    states_[static_cast<std::size_t>(body)].pose = pose;
  }
  void setVelocity(BodyId body, const Vec3& linear, const Vec3& /*angular*/) override {
    states_[static_cast<std::size_t>(body)].linearVelocity = linear;
  }
  void activate(BodyId /*body*/) override {}
  void applyForce(BodyId /*body*/, const Vec3& /*force*/, const Vec3& /*point*/, bool /*wake*/) override {}
  void applyCentralForce(BodyId /*body*/, const Vec3& /*force*/, bool /*wake*/) override {}
  void applyTorque(BodyId /*body*/, const Vec3& /*torque*/) override {}
  void applyImpulse(BodyId /*body*/, const Vec3& /*impulse*/, const Vec3& /*point*/) override {}
  void setGravity(const Vec3& gravity) override { def_.gravity = gravity; }
  Result<JointId> createJoint(const JointDef& /*def*/) override { return fail("no joints here"); }
  void destroyJoint(JointId /*joint*/) override {}
  Result<VehicleId> createVehicle(const VehicleDef& /*def*/) override { return fail("no vehicles here"); }
  void control(VehicleId /*vehicle*/, const VehicleControl& /*control*/) override {}
  void destroyVehicle(VehicleId /*vehicle*/) override {}
  std::optional<RayHit> castRay(const Vec3& /*from*/, const Vec3& /*to*/) const override {
    return std::nullopt;
  }

  void step(float seconds) override {
    ++steps_;
    for (BodyState& state : states_) {
      state.pose.position += state.linearVelocity * seconds;
    }
    if (steps_ == behaviour_.jumpStep) {
      states_.front().pose.position.y += 0.5F;
    }
    if (steps_ == behaviour_.invalidStep) {
      states_.front().pose.position.x = std::numeric_limits<float>::quiet_NaN();
    }
    count();
  }

  LevelSwitching& switching() override { return switching_; }
  const LevelSwitching& switching() const override { return switching_; }
  const PhysicsDiagnostics& diagnostics() const override { return diagnostics_; }
  const StepCounters& counters() const override { return counters_; }
  const StageTimes& stageTimes() const override { return stageTimes_; }
  void setProfiling(bool on) override { def_.profiling = on; }

  std::uint64_t stateHash() const override {
    const bool flipped = behaviour_.hashFlipStep != 0 && steps_ >= behaviour_.hashFlipStep;
    return steps_ * 0x9E3779B97F4A7C15ULL + (flipped ? 1 : 0);
  }
  double kineticEnergy() const override { return static_cast<double>(steps_) / 3.0; }
  double maxPenetration() const override { return behaviour_.penetration; }
  std::optional<BodyId> findInvalidState() const override {
    for (std::size_t i = 0; i < states_.size(); ++i) {
      if (!std::isfinite(states_[i].pose.position.x)) {
        return static_cast<BodyId>(i);
      }
    }
    return std::nullopt;
  }

 private:
  void count() {
    const auto step = static_cast<std::uint32_t>(steps_);
    const bool hybrid = def_.world == WorldKind::kHybrid;
    counters_ = {};
    counters_.objects = static_cast<std::uint32_t>(states_.size());
    counters_.manifolds = hybrid ? step : 4 * step;
    counters_.narrowphasePairs = 2 * step;
    counters_.contacts = 3 * step;
    if (hybrid && def_.collision.narrowphase == Narrowphase::kScatter) {
      // The most in the middle of ten steps.
      counters_.pairWork.childPairs = static_cast<int>(5 * (step <= 5 ? step : 10 - std::min(step, 10U)));
      counters_.pairWork.gjkRuns = static_cast<int>(2 * step);
    }
    if (hybrid && def_.collision.verifyEvery > 0 &&
        steps_ % static_cast<std::uint64_t>(def_.collision.verifyEvery) == 0) {
      verify();
    }
    if (behaviour_.work) counters_.pairWork = *behaviour_.work;
    if (behaviour_.countsTouching) {
      counters_.touchingPairs = 10;
      counters_.touchingFinestPairs = step <= behaviour_.coarseUntil ? 5 : step == 7 ? 9 : 10;
    }
    countCosts();
    switching_.steps = steps_;
    switching_.events.clear();
    if (hybrid && step == 2) {
      counters_.switchesCoarser = 1;
      switching_.events = {{.kind = LevelEventKind::kRequested, .policy = "speed"},
                           {.kind = LevelEventKind::kSwitched,
                            .scope = Scope::kGlobal,
                            .body = BodyId{1},
                            .from = 3,
                            .to = 2,
                            .other = BodyId{4},
                            .onCredit = true,
                            .policy = "governor"}};
    }
    diagnostics_.step = step;
    diagnostics_.childPairs = static_cast<std::uint64_t>(counters_.pairWork.childPairs);
    for (std::size_t stage = 0; stage < kStageCount; ++stage) {
      stageTimes_[stage] = def_.profiling ? static_cast<double>(stage + 1) : 0.0;
    }
  }

  void countCosts() {
    counters_.finestPairs = counters_.narrowphasePairs;
    if (behaviour_.costs.empty()) return;
    const auto at = std::min<std::uint64_t>(steps_, behaviour_.costs.size()) - 1;
    std::tie(counters_.costUnits, counters_.floorUnits) = behaviour_.costs[static_cast<std::size_t>(at)];
    const bool isLimited = counters_.costUnits < 100;
    counters_.finestPairs -= isLimited ? 1 : 0;
    counters_.hiddenContacts = isLimited ? 1 : 0;
  }

  void verify() {
    ContactReport& contacts = diagnostics_.contacts;
    ++contacts.steps;
    contacts.childPairs += 100;
    contacts.expected += 10;
    contacts.extra += 1;
    contacts.doubtful += 2;
    contacts.lastMissed.clear();
    if (steps_ == behaviour_.missedStep) {
      contacts.missed += 3;
      contacts.lastMissed.assign(
          3, {.bodyA = "left", .bodyB = "right", .childA = 4, .childB = -1, .distance = -0.5F});
    }
  }

  PhysicsDef def_;
  FakeBehaviour behaviour_;
  std::uint64_t steps_ = 0;
  std::vector<BodyState> states_;
  StepCounters counters_;
  StageTimes stageTimes_{};
  FakeSwitching switching_;
  FakeDiagnostics diagnostics_;
};

/// Two bodies; counts its updates if told where.
class FakeScene final : public Scene {
 public:
  explicit FakeScene(int* updates = nullptr) : updates_(updates) {}

  Result<void> build(World& world, const SceneOptions& options) override {
    for (const char* name : {"left", "right"}) {
      BodyDef def;
      def.name = name;
      def.linearVelocity = Vec3(static_cast<float>(options.seed), 0.0F, 0.0F);
      if (auto added = world.add(std::move(def)); !added) {
        return tl::unexpected(added.error());
      }
    }
    return {};
  }

  void update(World& /*world*/) override {
    if (updates_ != nullptr) {
      ++*updates_;
    }
  }

 private:
  int* updates_;
};

/// A run of the fake scene in a world of this kind.
inline RunOptions fakeRun(WorldKind kind, int frames, FakeBehaviour behaviour = {}) {
  RunOptions options;
  options.scene = "fake";
  options.summary = "Two boxes pass each other.";
  options.makeScene = [] { return std::make_unique<FakeScene>(); };
  options.engine = [behaviour](const PhysicsDef& def) -> Result<std::unique_ptr<Physics>> {
    return std::make_unique<FakePhysics>(def, behaviour);
  };
  options.physics.world = kind;
  options.frames = frames;
  return options;
}

}  // namespace scatter::test
