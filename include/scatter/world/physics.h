#pragma once

#include <scatter/math.h>
#include <scatter/result.h>
#include <scatter/world/body.h>
#include <scatter/world/collision.h>
#include <scatter/world/fidelity.h>
#include <scatter/world/joint.h>
#include <scatter/world/level_event.h>
#include <scatter/world/observation.h>
#include <scatter/world/step_report.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace scatter {

enum class WorldKind : std::uint8_t {
  kStandard,  ///< The plain engine; hybrids are always at their finest level.
  kHybrid,    ///< The engine with switching.
};

/// What makes requests in a hybrid world.
enum class Policy : std::uint8_t {
  kProximity,  ///< Coarser when level-1 bounds come near others, finer when free (report, section 4.5).
  kFinest,     ///< Everything at level n, always.
  kCoarsest,   ///< Everything at level 1, always.
  kNone,       ///< Only what the program asks for.
};

/// What has a level.
enum class Switching : std::uint8_t {
  kPair,  ///< Every pair of bodies: one neighbour can be met finely and another one coarsely.
  kBody,  ///< Every body, the same for all its neighbours (report, sections 3.4.3 and 4.5).
};

/// What a step may cost, for pair switching; at most one of the three.
struct BudgetDef {
  double milliseconds = 0.0;  ///< Of processor time; 0: no budget. Depends on the clock.
  double units = 0.0;         ///< Of predicted cost; 0: no budget. The same run after run.

  /// Units a step, as Physics::budgetUnits() gave them in an earlier run, which is repeated exactly; after
  /// the last one it stays. Empty: none.
  std::vector<double> recorded{};
};

struct SwitchingDef {
  Switching switching = Switching::kPair;

  Policy policy = Policy::kNone;

  /// Pair switching: more policies, as makePolicy() of src/lod knows them, such as "speed" or "speed:from=5".
  std::vector<std::string> policies{};

  BudgetDef budget{};

  /// Pair switching: the coarsest level that a pair in contact takes, on penetration credit.
  int creditLevel = 2;
  bool credit =
      true;  ///< Off: pairs in contact go coarser only when apart; with unsafe switching, regardless.

  /// The proximity margin is the distance that the fastest body travels in this many steps, so that a
  /// request comes at least that many steps before the level-1 boxes can touch (report, section 6.3.1). 0:
  /// once they overlap, as in the report's own tests.
  float proximitySteps = 3.0F;

  int retryInterval = 10;   ///< Steps between tries of a request whose safety condition failed.
  int quietSteps = 30;      ///< Steps without a neighbour before a finer level is asked for.
  float safetyGap = 0.01F;  ///< Metres that must separate the shapes for a switch to be safe.

  /// "The load is fine" while fewer narrowphase pairs than this are at work: standing requests are then
  /// retracted and none are made. 0: never.
  std::uint32_t loadFinePairs = 0;

  /// Off only to reproduce what the safety conditions prevent (report, Figures 3.5 and 3.6).
  bool safetyConditions = true;
};

struct PhysicsDef {
  WorldKind world = WorldKind::kStandard;
  Vec3 gravity{0.0F};
  int solverIterations = 10;
  bool profiling = true;
  SwitchingDef switching{};
  CollisionDef collision{};
};

/// Where the viewer looks, for policies that ask.
struct ViewFocus {
  Vec3 eye{0.0F};
  Vec3 target{0.0F};
  float fieldOfView = 1.0F;  ///< Vertical, radians.
};

struct RayHit {
  BodyId body{};
  Vec3 point{0.0F};
  Vec3 normal{0.0F};
  float fraction = 1.0F;  ///< Along the ray, 0 to 1.
};

/// A physics engine behind one interface. One thread at a time. Ids that are unknown are programming
/// errors and are asserted.
class Physics {
 public:
  Physics() = default;
  Physics(const Physics&) = delete;
  Physics& operator=(const Physics&) = delete;
  virtual ~Physics() = default;

  /// Name and version of the engine, such as "bullet 3.24".
  [[nodiscard]] virtual std::string engine() const = 0;
  [[nodiscard]] virtual WorldKind kind() const = 0;

  /// Fails on a mass that is not positive and finite, a pose or velocity that is not finite, a shape
  /// without volume, or a shape that the motion does not allow; the message names the body.
  [[nodiscard]] virtual Result<BodyId> createBody(const BodyDef& def) = 0;
  virtual void destroyBody(BodyId body) = 0;  ///< Its joints and vehicles go with it.

  [[nodiscard]] virtual BodyState state(BodyId body) const = 0;
  /// Wakes the body. A kinematic body pushes with the velocity that takes it there in the next step.
  virtual void setPose(BodyId body, const Transform& pose) = 0;
  /// Wakes the body. Nothing happens if it is not dynamic.
  virtual void setVelocity(BodyId body, const Vec3& linear, const Vec3& angular) = 0;
  virtual void activate(BodyId body) = 0;  ///< Wakes it.

  /// Newtons at a world point, until the end of the next step. Wakes the body unless asleep bodies are
  /// to stay so (`wake` false, for fields).
  virtual void applyForce(BodyId body, const Vec3& force, const Vec3& point, bool wake = true) = 0;
  virtual void applyCentralForce(BodyId body, const Vec3& force, bool wake = true) = 0;
  virtual void applyTorque(BodyId body, const Vec3& torque) = 0;
  virtual void applyImpulse(BodyId body, const Vec3& impulse, const Vec3& point) = 0;  ///< Newton seconds.

  /// Of all bodies, from the next step on. Wakes them.
  virtual void setGravity(const Vec3& gravity) = 0;

  /// Fails on a frame or limit that is not finite, or bodies that cannot be joined; the message names
  /// them.
  [[nodiscard]] virtual Result<JointId> createJoint(const JointDef& def) = 0;
  virtual void destroyJoint(JointId joint) = 0;
  [[nodiscard]] virtual Result<VehicleId> createVehicle(const VehicleDef& def) = 0;
  virtual void control(VehicleId vehicle, const VehicleControl& control) = 0;
  virtual void destroyVehicle(VehicleId vehicle) = 0;

  /// The closest hit. Sensors are not hit, nor are shapes that the ray starts in.
  [[nodiscard]] virtual std::optional<RayHit> castRay(const Vec3& from, const Vec3& to) const = 0;

  /// One step of `seconds`, whatever it costs.
  virtual void step(float seconds) = 0;

  /// The level in use, 1 the coarsest; bodies that are not hybrids have one level.
  [[nodiscard]] virtual int level(BodyId body) const = 0;
  [[nodiscard]] virtual int levelCount(BodyId body) const = 0;

  /// Asks for a level; the request stands until the body has switched or it is retracted. False, and
  /// nothing happens, in a standard world or if there is no such level.
  virtual bool requestLevel(BodyId body, int level, Scope scope) = 0;
  virtual void retractRequest(BodyId body) = 0;
  virtual void retractAllRequests() = 0;

  /// The level in use between two bodies whose broadphase bounds overlap, 1 the coarsest; 0 if they do not,
  /// or if neither has levels.
  [[nodiscard]] virtual int pairLevel(BodyId a, BodyId b) const = 0;

  /// What the last step was allowed to cost, in units; 0 without a budget. Repeats the run exactly when given
  /// as BudgetDef::recorded.
  [[nodiscard]] virtual double budgetUnits() const = 0;

  /// What a step may cost from the next one on; a default BudgetDef ends the budget. Clock-free budgets leave
  /// the run the same every time. Values that are negative or not finite are asserted, and refused with a
  /// line to stderr without asserts. False, and nothing happens, where they are, and where there are no
  /// budgets: they need pair switching.
  virtual bool setBudget(const BudgetDef& /*budget*/) { return false; }

  /// Replaces the policies of SwitchingDef from the next step on; requests that the program has made stand.
  /// Fails, and nothing happens, on a list that SwitchingDef would not take, in a standard world, and on
  /// named policies with body switching, which has none.
  [[nodiscard]] virtual Result<void> setPolicies(Policy /*policy*/,
                                                 const std::vector<std::string>& /*policies*/) {
    return fail("this world has no policies; start it as a hybrid world");
  }

  /// Changes what has a level. Every body is brought to its finest level, woken, and stays where it is;
  /// requests are retracted, policies and budget start anew. Fails, and nothing happens, in a standard world,
  /// and while it would push bodies apart: where pairs on penetration credit overlap finely by more than 2
  /// cm. Starting the scene again with the other switching always works.
  [[nodiscard]] virtual Result<void> setSwitching(Switching /*switching*/) {
    return fail("this world has no levels that switch; start it as a hybrid world");
  }

  /// A frozen body stays where it is, whatever happens to it, and others collide with it as with a static
  /// one; setPose() moves it. Thawing wakes it, at rest, and those that touch it. False, and nothing happens,
  /// if the body is not dynamic or the engine cannot.
  virtual bool setFrozen(BodyId /*body*/, bool /*frozen*/) { return false; }

  /// What the user holds is to be at its finest level, budget or not, as soon as that is safe: all its pairs,
  /// or with body switching the body. False, and nothing happens, in a standard world.
  virtual bool setHeld(BodyId /*body*/, bool /*held*/) { return false; }

  /// Where the viewer looks, for the policy "focus"; empty: nobody does. What is never told changes nothing.
  virtual void setFocus(const std::optional<ViewFocus>& /*focus*/) {}

  /// Fills `out` with what `parts` ask for, and empties the rest. Changes nothing in the world. The state is
  /// that after the last step and the calls since. An engine that cannot tell leaves `out` empty.
  virtual void observe(const ObservationParts& /*parts*/, Observation& out) const { out.clear(); }

  /// How true the contacts are to the finest shapes, now. Slow; call outside of what is timed. Changes
  /// nothing.
  [[nodiscard]] virtual FidelitySample measureFidelity() const = 0;

  /// What happened to requests in the last step and in the calls between it and the step before, oldest
  /// first. Valid until the next step.
  [[nodiscard]] virtual std::span<const LevelEvent> levelEvents() const = 0;

  [[nodiscard]] virtual const StepCounters& counters() const = 0;
  [[nodiscard]] virtual const StageTimes& stageTimes() const = 0;
  virtual void setProfiling(bool on) = 0;

  /// Empty unless PhysicsDef::collision asks for verification.
  [[nodiscard]] virtual ContactReport contactReport() const = 0;
  [[nodiscard]] virtual CollisionMemory collisionMemory()
      const = 0;  ///< All zero without the pair algorithm.

  /// Of the exact bits of every body's pose, velocities and level, in order of creation.
  [[nodiscard]] virtual std::uint64_t stateHash() const = 0;
  [[nodiscard]] virtual double kineticEnergy() const = 0;   ///< Joules.
  [[nodiscard]] virtual double maxPenetration() const = 0;  ///< Deepest contact of the last step, metres.

  /// Names the first body whose state is not finite, if any.
  [[nodiscard]] virtual std::optional<BodyId> findInvalidState() const = 0;
};

}  // namespace scatter
