#pragma once

#include <scatter/levels/mass_properties.h>
#include <scatter/world/physics.h>

#include <optional>
#include <vector>

#include "engine.h"

namespace scatter::bench {

/// What an engine needs to make a body of convex parts, dynamic or static.
struct EngineBodyDef {
  const BodyDef& def;
  const std::vector<ConvexPart>& parts;  ///< Outlive the world, at the same address for all that share them.
  const MassProperties& mass;
};

/// As much of a Physics as the scenes of the engine measurement need: dynamic and static bodies of convex
/// parts, grounds that are a plane or triangles, gravity and central forces. The rest asserts.
class EnginePhysics : public Physics {
 public:
  explicit EnginePhysics(const EngineOptions& options) : coarsest_(options.coarsest) {}

  [[nodiscard]] WorldKind kind() const final { return WorldKind::kStandard; }
  [[nodiscard]] Result<BodyId> createBody(const BodyDef& def) final;
  void destroyBody(BodyId body) final;
  void setPose(BodyId body, const Transform& pose) final;
  void setVelocity(BodyId body, const Vec3& linear, const Vec3& angular) final;
  void activate(BodyId body) final;
  void applyForce(BodyId body, const Vec3& force, const Vec3& point, bool wake) final;
  void applyTorque(BodyId body, const Vec3& torque) final;
  void applyImpulse(BodyId body, const Vec3& impulse, const Vec3& point) final;
  void setGravity(const Vec3& gravity) final;
  [[nodiscard]] Result<JointId> createJoint(const JointDef& def) final;
  void destroyJoint(JointId joint) final;
  [[nodiscard]] Result<VehicleId> createVehicle(const VehicleDef& def) final;
  void control(VehicleId vehicle, const VehicleControl& control) final;
  void destroyVehicle(VehicleId vehicle) final;
  [[nodiscard]] std::optional<RayHit> castRay(const Vec3& from, const Vec3& to) const final;

  /// Counted here, outside of what is measured.
  [[nodiscard]] const StepCounters& counters() const final;
  [[nodiscard]] const StageTimes& stageTimes() const final { return stageTimes_; }
  void setProfiling(bool) final {}

  [[nodiscard]] std::uint64_t stateHash() const final;
  [[nodiscard]] double kineticEnergy() const final;
  [[nodiscard]] double maxPenetration() const final { return deepest_; }
  [[nodiscard]] std::optional<BodyId> findInvalidState() const final;

 protected:
  /// What the last step's contacts were, as the engine itself sees them.
  struct Contacts {
    std::uint32_t manifolds = 0;
    std::uint32_t points = 0;
    double deepest = 0.0;  ///< Metres.
  };

  /// Bodies come in the order of their ids, which count from 0.
  [[nodiscard]] virtual Result<void> addBody(const EngineBodyDef& body) = 0;

  /// A static body that is not convex. An engine that does not override it has none.
  [[nodiscard]] virtual Result<void> addGround(const BodyDef& def, const Plane& plane);
  [[nodiscard]] virtual Result<void> addGround(const BodyDef& def, const TriangleMesh& triangles);

  [[nodiscard]] virtual Contacts countContacts() const = 0;

  static std::size_t indexOf(BodyId body) { return static_cast<std::size_t>(body); }

 private:
  struct Record {
    float mass = 0.0F;
    MassProperties properties;
    std::shared_ptr<const LevelSet> levels;        ///< Keeps the parts of a body with levels.
    std::shared_ptr<std::vector<ConvexPart>> own;  ///< The parts of any other body.
  };

  [[nodiscard]] Result<Record> makeRecord(const BodyDef& def) const;
  [[nodiscard]] Result<void> add(const BodyDef& def, const Record& record);
  [[nodiscard]] const std::vector<ConvexPart>& partsOf(const Record& record) const;

  bool coarsest_;
  std::vector<Record> records_;
  std::uint32_t hybrids_ = 0;
  mutable StepCounters counters_;
  mutable double deepest_ = 0.0;
  StageTimes stageTimes_{};
};

/// The hull's vertices in the frame of the part's model.
[[nodiscard]] std::vector<Vec3> placedVertices(const ConvexHull& hull, const Transform& pose);

/// The failure of an engine that has no such part.
[[nodiscard]] tl::unexpected<Error> unknownPart(const EngineBodyDef& body);

}  // namespace scatter::bench
