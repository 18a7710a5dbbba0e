#pragma once

#include <scatter/bullet/bullet_physics.h>

#include <map>
#include <memory>

#include "bullet/physics/bodies.h"
#include "bullet/physics/bullet_diagnostics.h"
#include "bullet/physics/bullet_switching.h"
#include "bullet/physics/engine.h"
#include "bullet/physics/shapes.h"
#include "bullet/physics/vehicle.h"

namespace scatter {

class BulletPhysics final : public Physics {
 public:
  explicit BulletPhysics(const PhysicsDef& def);
  ~BulletPhysics() override;

  [[nodiscard]] std::string engine() const override;
  [[nodiscard]] WorldKind kind() const override { return kind_; }

  [[nodiscard]] Result<BodyId> createBody(const BodyDef& def) override;
  void destroyBody(BodyId body) override;
  [[nodiscard]] BodyState state(BodyId body) const override;
  [[nodiscard]] StateBits stateBits(BodyId body) const override;
  void setPose(BodyId body, const Transform& pose) override;
  void setVelocity(BodyId body, const Vec3& linear, const Vec3& angular) override;
  void activate(BodyId body) override;
  void applyForce(BodyId body, const Vec3& force, const Vec3& point, bool wake) override;
  void applyCentralForce(BodyId body, const Vec3& force, bool wake) override;
  void applyTorque(BodyId body, const Vec3& torque) override;
  void applyImpulse(BodyId body, const Vec3& impulse, const Vec3& point) override;
  void setGravity(const Vec3& gravity) override;

  [[nodiscard]] Result<JointId> createJoint(const JointDef& def) override;
  void destroyJoint(JointId joint) override;
  [[nodiscard]] Result<VehicleId> createVehicle(const VehicleDef& def) override;
  void control(VehicleId vehicle, const VehicleControl& control) override;
  void destroyVehicle(VehicleId vehicle) override;

  [[nodiscard]] std::optional<RayHit> castRay(const Vec3& from, const Vec3& to) const override;

  void step(float seconds) override;

  bool setFrozen(BodyId body, bool frozen) override;

  [[nodiscard]] BulletSwitching& switching() override { return switching_; }
  [[nodiscard]] const BulletSwitching& switching() const override { return switching_; }
  [[nodiscard]] const BulletDiagnostics& diagnostics() const override { return diagnostics_; }

  [[nodiscard]] const StepCounters& counters() const override { return counters_; }
  [[nodiscard]] const StageTimes& stageTimes() const override { return stageTimes_; }
  void setProfiling(bool on) override;

  [[nodiscard]] std::uint64_t stateHash() const override;
  [[nodiscard]] double kineticEnergy() const override;
  [[nodiscard]] double maxPenetration() const override { return maxPenetration_; }
  [[nodiscard]] std::optional<BodyId> findInvalidState() const override;

 private:
  struct Joint {
    std::unique_ptr<btTypedConstraint> constraint;
    BodyId a{};
    BodyId b{};
  };

  void runStep(float seconds);
  void countStep(std::uint32_t newContacts);

  WorldKind kind_;
  bool profiling_;
  BulletShapeBuilder shapes_;
  BulletEngine engine_;
  BulletBodies bodies_;
  BulletSwitching switching_;
  BulletDiagnostics diagnostics_;

  std::map<JointId, Joint> joints_;
  std::map<VehicleId, std::unique_ptr<BulletVehicle>> vehicles_;
  std::uint32_t lastJoint_ = 0;
  std::uint32_t lastVehicle_ = 0;

  StepCounters counters_;
  StageTimes stageTimes_{};
  double maxPenetration_ = 0.0;
};

}  // namespace scatter
