#pragma once

#include <BulletDynamics/Vehicle/btRaycastVehicle.h>
#include <scatter/world/joint.h>

#include <vector>

#include "bullet/physics/body.h"

namespace scatter {

/// Bullet's raycast vehicle and what it needs. The chassis and the world must outlive it.
class BulletVehicle {
 public:
  /// `def` is valid.
  BulletVehicle(const VehicleDef& def, BulletBody& chassis, const btDynamicsWorld& world);

  [[nodiscard]] BulletBody& chassis() { return chassis_; }
  [[nodiscard]] btActionInterface& action() { return vehicle_; }

  void control(const VehicleControl& control);

 private:
  /// Rays that pass through the chassis itself and through sensors.
  class Raycaster final : public btVehicleRaycaster {
   public:
    Raycaster(const btDynamicsWorld& world, const btCollisionObject& chassis)
        : world_(world), chassis_(chassis) {}
    void* castRay(const btVector3& from, const btVector3& to, btVehicleRaycasterResult& result) override;

   private:
    const btDynamicsWorld& world_;
    const btCollisionObject& chassis_;
  };

  /// Stands still while its chassis is frozen: Bullet's divides by what a body without mass has not.
  class Raycast final : public btRaycastVehicle {
   public:
    using btRaycastVehicle::btRaycastVehicle;
    void updateAction(btCollisionWorld* world, btScalar step) override {
      if (!getRigidBody()->isStaticObject()) btRaycastVehicle::updateAction(world, step);
    }
  };

  void addWheel(const WheelDef& def, const btRaycastVehicle::btVehicleTuning& tuning);

  BulletBody& chassis_;
  std::vector<WheelDef> wheels_;
  Raycaster raycaster_;
  Raycast vehicle_;
};

}  // namespace scatter
