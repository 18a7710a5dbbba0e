#pragma once

#include <scatter/math.h>
#include <scatter/result.h>
#include <scatter/world/body.h>
#include <scatter/world/collision.h>
#include <scatter/world/diagnostics.h>
#include <scatter/world/joint.h>
#include <scatter/world/level_switching.h>
#include <scatter/world/state_bits.h>
#include <scatter/world/step_report.h>

#include <cstdint>
#include <optional>
#include <string>

namespace scatter {

enum class WorldKind : std::uint8_t {
  kStandard,  ///< The plain engine; hybrids are always at their finest level.
  kHybrid,    ///< The engine with switching.
};

/// Who finds the impulses of contacts.
enum class ContactSolver : std::uint8_t {
  kEngine,  ///< The engine's own solver.
  kWide,    ///< One that solves the contacts of four pairs of bodies at a time.
};

/// What PhysicsDef::contactsPerDirection is where it is asked for without a number: with 4 corners a body
/// rests, with twice as many a round one does.
inline constexpr int kUsualContactsPerDirection = 8;

struct PhysicsDef {
  WorldKind world = WorldKind::kStandard;
  Vec3 gravity{0.0F};
  int solverIterations = 10;
  ContactSolver solver = ContactSolver::kEngine;

  /// How many contacts of two bodies the solver is shown of each direction, where they have many; 0: all.
  int contactsPerDirection = 0;
  bool profiling = true;

  /// Threads that a step may use, the caller's among them, 1 to 64: as many as an engine can make use of.
  /// Results do not depend on it.
  int threads = 1;
  SwitchingDef switching{};
  CollisionDef collision{};
};

struct RayHit {
  BodyId body{};
  Vec3 point{0.0F};
  Vec3 normal{0.0F};
  float fraction = 1.0F;  ///< Along the ray, 0 to 1.
};

/// A physics engine behind one interface: what every engine has, and, under switching() and diagnostics(),
/// what only some have. One thread at a time. Ids that are unknown are programming errors and are asserted.
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

  /// What stateHash() is made of, but for the level; as state() tells it, in an engine that overrides
  /// nothing.
  [[nodiscard]] virtual StateBits stateBits(BodyId body) const;
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

  /// A frozen body stays where it is, whatever happens to it, and others collide with it as with a static
  /// one; setPose() moves it. Thawing wakes it, at rest, and those that touch it. False, and nothing happens,
  /// if the body is not dynamic or the engine cannot.
  virtual bool setFrozen(BodyId /*body*/, bool /*frozen*/) { return false; }

  /// Valid as long as the engine. An engine without levels overrides neither of the two: what they return
  /// switches nothing, and all such engines share it.
  [[nodiscard]] virtual LevelSwitching& switching();
  [[nodiscard]] virtual const LevelSwitching& switching() const;

  /// Valid as long as the engine. That of an engine which does not override it tells nothing.
  [[nodiscard]] virtual const PhysicsDiagnostics& diagnostics() const;

  [[nodiscard]] virtual const StepCounters& counters() const = 0;
  [[nodiscard]] virtual const StageTimes& stageTimes() const = 0;
  virtual void setProfiling(bool on) = 0;

  /// Of the exact bits of every body's pose, velocities and level, in order of creation.
  [[nodiscard]] virtual std::uint64_t stateHash() const = 0;
  [[nodiscard]] virtual double kineticEnergy() const = 0;   ///< Joules.
  [[nodiscard]] virtual double maxPenetration() const = 0;  ///< Deepest contact of the last step, metres.

  /// Names the first body whose state is not finite, if any.
  [[nodiscard]] virtual std::optional<BodyId> findInvalidState() const = 0;
};

}  // namespace scatter
