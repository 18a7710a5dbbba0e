#pragma once

#include <scatter/bullet/bullet_physics.h>

#include <map>
#include <vector>

#include "bullet/physics/body.h"
#include "bullet/physics/engine.h"
#include "bullet/physics/level_listener.h"
#include "bullet/physics/shapes.h"
#include "bullet/physics/vehicle.h"

namespace scatter {

class BulletPhysics final : public Physics {
 public:
  explicit BulletPhysics(const PhysicsDef& def);
  ~BulletPhysics() override;

  [[nodiscard]] std::string engine() const override;
  [[nodiscard]] WorldKind kind() const override { return def_.world; }

  [[nodiscard]] Result<BodyId> createBody(const BodyDef& def) override;
  void destroyBody(BodyId body) override;
  [[nodiscard]] BodyState state(BodyId body) const override;
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

  [[nodiscard]] int level(BodyId body) const override;
  [[nodiscard]] int levelCount(BodyId body) const override;
  [[nodiscard]] int pairLevel(BodyId a, BodyId b) const override;
  [[nodiscard]] double budgetUnits() const override { return budgetUnits_; }
  bool setBudget(const BudgetDef& budget) override;
  [[nodiscard]] Result<void> setPolicies(Policy policy, const std::vector<std::string>& policies) override;
  [[nodiscard]] Result<void> setSwitching(Switching switching) override;
  bool setFrozen(BodyId body, bool frozen) override;
  bool setHeld(BodyId body, bool held) override;
  void setFocus(const std::optional<ViewFocus>& focus) override;
  void observe(const ObservationParts& parts, Observation& out) const override;
  [[nodiscard]] FidelitySample measureFidelity() const override;
  bool requestLevel(BodyId body, int level, Scope scope) override;
  void retractRequest(BodyId body) override;
  void retractAllRequests() override;
  [[nodiscard]] std::span<const LevelEvent> levelEvents() const override { return listener_.events(); }

  [[nodiscard]] const StepCounters& counters() const override { return counters_; }
  [[nodiscard]] const StageTimes& stageTimes() const override { return stageTimes_; }
  void setProfiling(bool on) override;
  [[nodiscard]] ContactReport contactReport() const override;
  [[nodiscard]] CollisionMemory collisionMemory() const override;

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

  [[nodiscard]] BulletBody& at(BodyId body);
  [[nodiscard]] const BulletBody& at(BodyId body) const;
  [[nodiscard]] bool switchesByPair() const;
  void askAllBodies();
  void applyFocus();
  void runStep(float seconds);
  void countStep(std::uint32_t newContacts);

  PhysicsDef def_;
  BulletShapeBuilder shapes_;
  LevelListener listener_;
  BulletEngine engine_;

  /// By id, which is one more than the index; null once destroyed.
  std::vector<std::unique_ptr<BulletBody>> bodies_;
  std::uint32_t bodyCount_ = 0;
  std::uint32_t hybridCount_ = 0;

  std::map<JointId, Joint> joints_;
  std::map<VehicleId, std::unique_ptr<BulletVehicle>> vehicles_;
  std::uint32_t lastJoint_ = 0;
  std::uint32_t lastVehicle_ = 0;

  std::optional<ViewFocus> focus_;
  double budgetUnits_ = 0.0;
  StepCounters counters_;
  StageTimes stageTimes_{};
  double maxPenetration_ = 0.0;
};

}  // namespace scatter
