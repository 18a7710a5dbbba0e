#include "bullet/physics/vehicle.h"

#include <BulletDynamics/Dynamics/btDynamicsWorld.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "bullet/physics/ray.h"
#include "bullet/shapes/conversions.h"

namespace scatter {

namespace {

btRaycastVehicle::btVehicleTuning tuningOf(const VehicleDef& def, float chassisMass) {
  // Shares of critical damping while springs are pressed and while they relax.
  constexpr float kCompression = 0.3F;
  constexpr float kRelaxation = 0.5F;
  // No spring pushes the chassis harder than this; Bullet's default of 6000 N is that of a small car.
  constexpr float kMostAcceleration = 100.0F;
  const float critical = 2.0F * std::sqrt(def.suspensionStiffness);
  btRaycastVehicle::btVehicleTuning tuning;
  tuning.m_suspensionStiffness = def.suspensionStiffness;
  tuning.m_suspensionCompression = kCompression * critical;
  tuning.m_suspensionDamping = kRelaxation * critical;
  tuning.m_frictionSlip = def.frictionSlip;
  tuning.m_maxSuspensionForce = kMostAcceleration * chassisMass;
  return tuning;
}

int longestAxis(const Vec3& v) {
  return toBullet(v).closestAxis();
}

}  // namespace

BulletVehicle::BulletVehicle(const VehicleDef& def, BulletBody& chassis, const btDynamicsWorld& world)
    : chassis_(chassis),
      wheels_(def.wheels),
      raycaster_(world, chassis.rigid()),
      vehicle_(tuningOf(def, chassis.mass()), &chassis.rigid(), &raycaster_) {
  // Bullet names the axes of the chassis by index; the frame of the centre of mass may be turned.
  const Quat turn = glm::conjugate(chassis.center().rotation);
  const int up = longestAxis(turn * wheels_[0].direction);
  const int right = longestAxis(turn * wheels_[0].axle);
  if (up != right) vehicle_.setCoordinateSystem(right, up, 3 - up - right);
  const btRaycastVehicle::btVehicleTuning tuning = tuningOf(def, chassis.mass());
  for (const WheelDef& wheel : wheels_) addWheel(wheel, tuning);
}

void BulletVehicle::addWheel(const WheelDef& def, const btRaycastVehicle::btVehicleTuning& tuning) {
  const Transform toCenter = chassis_.center().inverse();
  constexpr float kCentimetres = 100.0F;
  btRaycastVehicle::btVehicleTuning own = tuning;
  own.m_maxSuspensionTravelCm = kCentimetres * def.suspensionRest;
  vehicle_.addWheel(
      toBullet(toCenter(def.connection)), toBullet(toCenter.rotation * glm::normalize(def.direction)),
      toBullet(toCenter.rotation * glm::normalize(def.axle)), def.suspensionRest, def.radius, own,
      /*isFrontWheel=*/def.steered);
}

void BulletVehicle::control(const VehicleControl& control) {
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    const int wheel = static_cast<int>(i);
    vehicle_.applyEngineForce(wheels_[i].driven ? control.engineForce : 0.0F, wheel);
    vehicle_.setBrake(control.brake, wheel);
    vehicle_.setSteeringValue(wheels_[i].steered ? control.steering : 0.0F, wheel);
  }
  chassis_.wake();
}

void* BulletVehicle::Raycaster::castRay(const btVector3& from, const btVector3& to,
                                        btVehicleRaycasterResult& result) {
  ClosestRayHit hit(from, to, &chassis_);
  world_.rayTest(from, to, hit);
  if (!hit.hasHit()) return nullptr;
  result.m_hitPointInWorld = hit.m_hitPointWorld;
  result.m_hitNormalInWorld = hit.m_hitNormalWorld.normalized();
  result.m_distFraction = hit.m_closestHitFraction;
  // Bullet only asks whether there is ground.
  return const_cast<btCollisionObject*>(hit.m_collisionObject);
}

}  // namespace scatter
