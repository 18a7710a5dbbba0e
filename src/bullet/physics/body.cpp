#include "bullet/physics/body.h"

#include <BulletHybrid/btHybridRigidBody.h>

#include "bullet/shapes/conversions.h"

namespace scatter {

namespace {

btRigidBody::btRigidBodyConstructionInfo constructionInfo(const BodyDef& def, const BulletShape& shape) {
  const bool dynamic = def.motion == Motion::kDynamic;
  const float mass = dynamic ? def.mass : 0.0F;
  const btVector3 inertia = dynamic ? toBullet(shape.inertia() * mass) : btVector3(0, 0, 0);
  btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shape.finest(), inertia);
  info.m_startWorldTransform = toBullet(def.pose * shape.center());
  info.m_linearDamping = def.material.linearDamping;
  info.m_angularDamping = def.material.angularDamping;
  info.m_friction = def.material.friction;
  info.m_rollingFriction = def.material.rollingFriction;
  info.m_spinningFriction = def.material.spinningFriction;
  info.m_restitution = def.material.restitution;
  return info;
}

int collisionFlags(const BodyDef& def) {
  // Contact-added callbacks are only made for objects with this flag; it changes nothing else.
  int flags = btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK;
  if (def.motion == Motion::kStatic) flags |= btCollisionObject::CF_STATIC_OBJECT;
  if (def.motion == Motion::kKinematic) flags |= btCollisionObject::CF_KINEMATIC_OBJECT;
  if (def.sensor) flags |= btCollisionObject::CF_NO_CONTACT_RESPONSE;
  return flags;
}

}  // namespace

BulletBody::BulletBody(BodyId id, const BodyDef& def, std::shared_ptr<const BulletShape> shape,
                       LevelStart start)
    : id_(id),
      name_(def.name),
      motion_(def.motion),
      isHybrid_(std::holds_alternative<std::shared_ptr<const LevelSet>>(def.shape)),
      mayRest_(def.mayRest),
      mass_(static_cast<double>(def.mass)),
      gravityFactor_(def.gravityFactor),
      shape_(std::move(shape)) {
  const btRigidBody::btRigidBodyConstructionInfo info = constructionInfo(def, *shape_);
  if (isHybrid_ && start.switches) {
    auto hybrid = std::make_unique<btHybridRigidBody>(info, &shape_->levels(), start.level);
    switching_ = hybrid.get();
    rigid_ = std::move(hybrid);
  } else {
    rigid_ = std::make_unique<btRigidBody>(info);
  }
  rigid_->setUserIndex(switching_ != nullptr ? kSwitching : isHybrid_ ? kHybrid : 0);
  rigid_->setCollisionFlags(collisionFlags(def));
  rigid_->setUserPointer(this);
  if (isDynamic()) {
    rigid_->setLinearVelocity(toBullet(def.linearVelocity));
    rigid_->setAngularVelocity(toBullet(def.angularVelocity));
  }
  if (!def.mayRest && motion_ != Motion::kStatic) rigid_->setActivationState(DISABLE_DEACTIVATION);
}

BulletBody::~BulletBody() = default;

int BulletBody::level() const {
  return switching_ != nullptr ? switching_->getLevel() : levelCount();
}

BodyState BulletBody::state() const {
  BodyState state;
  const Transform center = fromBullet(rigid_->getWorldTransform());
  state.centerOfMass = center.position;
  state.pose = center * shape_->center().inverse();
  state.linearVelocity = fromBullet(rigid_->getLinearVelocity());
  state.angularVelocity = fromBullet(rigid_->getAngularVelocity());
  state.asleep = isAsleep();
  return state;
}

void BulletBody::setPose(const Transform& pose) {
  const btTransform center = toBullet(pose * shape_->center());
  if (motion_ == Motion::kKinematic) {
    // Bullet takes its velocity from the difference to where the last step left it.
    rigid_->setWorldTransform(center);
  } else {
    rigid_->setCenterOfMassTransform(center);
  }
  wake();
}

void BulletBody::wake() {
  if (motion_ != Motion::kStatic && !isFrozen_) rigid_->activate(/*forceActivation=*/true);
}

bool BulletBody::isAsleep() const {
  return motion_ != Motion::kStatic && !isFrozen_ && !rigid_->isActive();
}

void BulletBody::freeze() {
  isFrozen_ = true;
  // Without mass Bullet takes it for a static body, which never is awake.
  rigid_->setMassProps(0, btVector3(0, 0, 0));
  rigid_->updateInertiaTensor();
  rest();
  rigid_->forceActivationState(ISLAND_SLEEPING);
}

void BulletBody::thaw() {
  isFrozen_ = false;
  rigid_->setMassProps(mass(), toBullet(shape_->inertia() * mass()));
  rigid_->updateInertiaTensor();
  rest();
  rigid_->forceActivationState(mayRest_ ? ACTIVE_TAG : DISABLE_DEACTIVATION);
  rigid_->setDeactivationTime(0);
}

void BulletBody::rest() {
  const btVector3 none(0, 0, 0);
  rigid_->clearForces();
  rigid_->setLinearVelocity(none);
  rigid_->setAngularVelocity(none);
  rigid_->setInterpolationLinearVelocity(none);
  rigid_->setInterpolationAngularVelocity(none);
  rigid_->setInterpolationWorldTransform(rigid_->getWorldTransform());
}

btTransform BulletBody::fromCenter(const Transform& inWorld) const {
  return rigid_->getWorldTransform().inverse() * toBullet(inWorld);
}

double BulletBody::kineticEnergy() const {
  if (!isDynamic()) return 0.0;
  const btVector3& velocity = rigid_->getLinearVelocity();
  const btVector3 spin = rigid_->getAngularVelocity() * rigid_->getWorldTransform().getBasis();
  double energy = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto speed = static_cast<double>(velocity[axis]);
    const auto turn = static_cast<double>(spin[axis]);
    const double inertia = mass_ * static_cast<double>(shape_->inertia()[axis]);
    energy += 0.5 * (mass_ * speed * speed + inertia * turn * turn);
  }
  return energy;
}

bool BulletBody::isFiniteNow() const {
  const btTransform& pose = rigid_->getWorldTransform();
  return isFinite(pose.getOrigin()) && isFinite(pose.getBasis().getRow(0)) &&
         isFinite(pose.getBasis().getRow(1)) && isFinite(pose.getBasis().getRow(2)) &&
         isFinite(rigid_->getLinearVelocity()) && isFinite(rigid_->getAngularVelocity());
}

}  // namespace scatter
