#include "bullet/physics/bullet_physics.h"

#include <BulletHybrid/btHybridDynamicsWorld.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "bullet/physics/contact_summary.h"
#include "bullet/physics/joints.h"
#include "bullet/physics/ray.h"
#include "bullet/physics/state_hash.h"
#include "bullet/physics/validation.h"
#include "bullet/shapes/conversions.h"

namespace scatter {

BulletPhysics::BulletPhysics(const PhysicsDef& def)
    : kind_(def.world),
      profiling_(def.profiling),
      engine_(def),
      switching_(def.switching, engine_, bodies_),
      diagnostics_(engine_, bodies_) {
  assert(isFinite(def.gravity) && def.solverIterations > 0);
}

BulletPhysics::~BulletPhysics() {
  for (const auto& [id, vehicle] : vehicles_) engine_.world().removeAction(&vehicle->action());
  for (const auto& [id, joint] : joints_) engine_.world().removeConstraint(joint.constraint.get());
  for (const auto& body : bodies_.all()) {
    if (body) engine_.world().removeRigidBody(&body->rigid());
  }
}

std::string BulletPhysics::engine() const {
  const int version = btGetVersion();
  return "bullet " + std::to_string(version / 100) + "." + std::to_string(version % 100);
}

Result<BodyId> BulletPhysics::createBody(const BodyDef& def) {
  if (auto valid = validateBody(def); !valid) return tl::unexpected(valid.error());
  auto shape = shapes_.build(def.shape);
  if (!shape) return fail("body \"" + def.name + "\": " + shape.error().message);

  BulletBody& body = bodies_.make(def, std::move(*shape), switching_.levelStart());
  engine_.world().addRigidBody(&body.rigid(), static_cast<int>(def.group),
                               static_cast<int>(def.collidesWith));
  body.setGravity(engine_.world().getGravity());
  return body.id();
}

void BulletPhysics::destroyBody(BodyId body) {
  BulletBody& leaving = bodies_.at(body);
  for (auto it = vehicles_.begin(); it != vehicles_.end();) {
    const VehicleId id = (it++)->first;
    if (&vehicles_.at(id)->chassis() == &leaving) destroyVehicle(id);
  }
  for (auto it = joints_.begin(); it != joints_.end();) {
    const auto& [id, joint] = *it++;
    if (joint.a == body || joint.b == body) destroyJoint(id);
  }
  engine_.wakeNeighbours(leaving.rigid());
  engine_.world().removeRigidBody(&leaving.rigid());
  bodies_.destroy(body);
}

BodyState BulletPhysics::state(BodyId body) const {
  return bodies_.at(body).state();
}

StateBits BulletPhysics::stateBits(BodyId body) const {
  return stateBitsOf(bodies_.at(body));
}

void BulletPhysics::setPose(BodyId body, const Transform& pose) {
  assert(isFinite(pose));
  BulletBody& moved = bodies_.at(body);
  if (moved.isFrozen()) engine_.wakeNeighbours(moved.rigid());
  moved.setPose(pose);
  // So that rays find it where it is now.
  engine_.world().updateSingleAabb(&moved.rigid());
}

void BulletPhysics::setVelocity(BodyId body, const Vec3& linear, const Vec3& angular) {
  assert(isFinite(linear) && isFinite(angular));
  BulletBody& moved = bodies_.at(body);
  if (!moved.isDynamic() || moved.isFrozen()) return;
  moved.rigid().setLinearVelocity(toBullet(linear));
  moved.rigid().setAngularVelocity(toBullet(angular));
  moved.wake();
}

void BulletPhysics::activate(BodyId body) {
  bodies_.at(body).wake();
}

void BulletPhysics::applyForce(BodyId body, const Vec3& force, const Vec3& point, bool wake) {
  BulletBody& pushed = bodies_.at(body);
  if (wake) pushed.wake();
  // An asleep body would keep the force for when something wakes it in the middle of the step.
  if (!pushed.rigid().isActive()) return;
  pushed.rigid().applyForce(toBullet(force), toBullet(point) - pushed.rigid().getCenterOfMassPosition());
}

void BulletPhysics::applyCentralForce(BodyId body, const Vec3& force, bool wake) {
  BulletBody& pushed = bodies_.at(body);
  if (wake) pushed.wake();
  if (!pushed.rigid().isActive()) return;
  pushed.rigid().applyCentralForce(toBullet(force));
}

void BulletPhysics::applyTorque(BodyId body, const Vec3& torque) {
  BulletBody& turned = bodies_.at(body);
  turned.wake();
  turned.rigid().applyTorque(toBullet(torque));
}

void BulletPhysics::applyImpulse(BodyId body, const Vec3& impulse, const Vec3& point) {
  BulletBody& pushed = bodies_.at(body);
  pushed.wake();
  pushed.rigid().applyImpulse(toBullet(impulse), toBullet(point) - pushed.rigid().getCenterOfMassPosition());
}

void BulletPhysics::setGravity(const Vec3& gravity) {
  assert(isFinite(gravity));
  engine_.world().setGravity(toBullet(gravity));
  // Bullet's own leaves out the bodies that are asleep.
  for (const auto& body : bodies_.all()) {
    if (!body || !body->isDynamic()) continue;
    body->setGravity(toBullet(gravity));
    body->wake();
  }
}

Result<JointId> BulletPhysics::createJoint(const JointDef& def) {
  BulletBody& a = bodies_.at(def.bodyA);
  BulletBody& b = bodies_.at(def.bodyB);
  const std::string joint = "joint between \"" + a.name() + "\" and \"" + b.name() + "\"";
  if (&a == &b) return fail(joint + ": a body cannot be joined to itself");
  if (!a.isDynamic() && !b.isDynamic()) return fail(joint + ": at least one body must be dynamic");
  if (auto valid = validateJoint(def, joint); !valid) return tl::unexpected(valid.error());

  const JointId id{++lastJoint_};
  auto& made = joints_.emplace(id, Joint{makeConstraint(def, a, b), def.bodyA, def.bodyB}).first->second;
  // Contacts that are not looked after any more would go on pushing.
  if (!def.bodiesCollide) engine_.forgetContacts(a.rigid(), b.rigid());
  engine_.world().addConstraint(made.constraint.get(),
                                /*disableCollisionsBetweenLinkedBodies=*/!def.bodiesCollide);
  a.wake();
  b.wake();
  return id;
}

void BulletPhysics::destroyJoint(JointId joint) {
  const auto found = joints_.find(joint);
  assert(found != joints_.end() && "unknown joint");
  engine_.world().removeConstraint(found->second.constraint.get());
  bodies_.at(found->second.a).wake();
  bodies_.at(found->second.b).wake();
  joints_.erase(found);
}

Result<VehicleId> BulletPhysics::createVehicle(const VehicleDef& def) {
  BulletBody& chassis = bodies_.at(def.chassis);
  const std::string vehicle = "vehicle on \"" + chassis.name() + "\"";
  if (!chassis.isDynamic()) return fail(vehicle + ": the chassis must be dynamic");
  if (auto valid = validateVehicle(def, vehicle); !valid) return tl::unexpected(valid.error());
  const VehicleId id{++lastVehicle_};
  auto& made = vehicles_[id] = std::make_unique<BulletVehicle>(def, chassis, engine_.world());
  engine_.world().addAction(&made->action());
  chassis.wake();
  return id;
}

void BulletPhysics::control(VehicleId vehicle, const VehicleControl& control) {
  const auto found = vehicles_.find(vehicle);
  assert(found != vehicles_.end() && "unknown vehicle");
  found->second->control(control);
}

void BulletPhysics::destroyVehicle(VehicleId vehicle) {
  const auto found = vehicles_.find(vehicle);
  assert(found != vehicles_.end() && "unknown vehicle");
  engine_.world().removeAction(&found->second->action());
  vehicles_.erase(found);
}

std::optional<RayHit> BulletPhysics::castRay(const Vec3& from, const Vec3& to) const {
  if (!isFinite(from) || !isFinite(to) || from == to) return std::nullopt;
  ClosestRayHit hit(toBullet(from), toBullet(to));
  engine_.world().rayTest(toBullet(from), toBullet(to), hit);
  if (!hit.hasHit()) return std::nullopt;
  return RayHit{BulletBody::of(*hit.m_collisionObject).id(), fromBullet(hit.m_hitPointWorld),
                fromBullet(hit.m_hitNormalWorld.normalized()), hit.m_closestHitFraction};
}

void BulletPhysics::step(float seconds) {
  assert(isFinite(seconds) && seconds > 0.0F);
  switching_.beginStep(counters_);
  engine_.dispatcher().resetCounts();
  {
    const NewContactCounter newContacts;
    runStep(seconds);
  }
  countStep(NewContactCounter::count());
}

void BulletPhysics::runStep(float seconds) {
  // No sub-steps: exactly one, of the length asked for.
  if (!profiling_) {
    engine_.world().stepSimulation(seconds, 0);
    return;
  }
  {
    const BulletStageTimer::Running timing(engine_.timer());
    engine_.world().stepSimulation(seconds, 0);
  }
  stageTimes_ = engine_.timer().times();
}

void BulletPhysics::countStep(std::uint32_t newContacts) {
  const PairCounts& pairs = engine_.dispatcher().counts();
  const ContactSummary contacts = summarizeContacts(engine_.dispatcher());
  counters_ = {};
  counters_.objects = bodies_.count();
  counters_.hybrids = bodies_.hybridCount();
  counters_.joints = static_cast<std::uint32_t>(engine_.world().getNumConstraints());
  counters_.overlappingPairs =
      static_cast<std::uint32_t>(engine_.world().getPairCache()->getNumOverlappingPairs());
  counters_.narrowphasePairs = pairs.all;
  counters_.pairsWithHybrid = pairs.withHybrid;
  counters_.pairsWithoutHybrid = pairs.all - pairs.withHybrid;
  counters_.finestPairs = pairs.finest;
  counters_.manifolds = contacts.manifolds;
  counters_.contacts = contacts.contacts;
  counters_.newContacts = newContacts;
  maxPenetration_ = static_cast<double>(contacts.deepest);
  switching_.endStep(counters_);
  if (const auto* hybrid = engine_.switching()) {
    counters_.pairWork = hybrid->getCollisionCounts();
  }
}

bool BulletPhysics::setFrozen(BodyId body, bool frozen) {
  BulletBody& target = bodies_.at(body);
  if (!target.isDynamic()) return false;
  if (target.isFrozen() == frozen) return true;
  if (frozen) {
    target.freeze();
    engine_.forgetStillContacts(target.rigid());
  } else {
    engine_.wakeNeighbours(target.rigid());
    target.thaw();
    // While it was frozen it had no pairs with what it came to lie on.
    engine_.world().refreshBroadphaseProxy(&target.rigid());
  }
  return true;
}

void BulletPhysics::setProfiling(bool on) {
  profiling_ = on;
  if (!on) stageTimes_ = {};
}

std::uint64_t BulletPhysics::stateHash() const {
  StateHash hash;
  for (const auto& body : bodies_.all()) {
    if (body) hash.add(*body);
  }
  return hash.value();
}

double BulletPhysics::kineticEnergy() const {
  double energy = 0.0;
  for (const auto& body : bodies_.all()) {
    if (body) energy += body->kineticEnergy();
  }
  return energy;
}

std::optional<BodyId> BulletPhysics::findInvalidState() const {
  const auto bodies = bodies_.all();
  const auto found = std::find_if(bodies.begin(), bodies.end(),
                                  [](const auto& body) { return body && !body->isFiniteNow(); });
  if (found == bodies.end()) return std::nullopt;
  return (*found)->id();
}

std::unique_ptr<Physics> makeBulletPhysics(const PhysicsDef& def) {
  return std::make_unique<BulletPhysics>(def);
}

}  // namespace scatter
