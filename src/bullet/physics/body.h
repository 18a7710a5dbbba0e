#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <BulletHybrid/btHybridRigidBody.h>
#include <scatter/world/body.h>

#include <memory>
#include <string>

#include "bullet/physics/shapes.h"

namespace scatter {

/// Whether and where a LevelSet's body begins among its levels.
struct LevelStart {
  bool switches = false;  ///< In a hybrid world.
  int level = 0;          ///< 0: the finest.
};

/// One body of BulletPhysics. Bullet's user pointer of the rigid body leads back to it, so it stays where
/// it is.
class BulletBody {
 public:
  /// `def` is valid.
  BulletBody(BodyId id, const BodyDef& def, std::shared_ptr<const BulletShape> shape, LevelStart start);
  BulletBody(const BulletBody&) = delete;
  BulletBody& operator=(const BulletBody&) = delete;
  ~BulletBody();

  /// The body that a Bullet object of this adapter belongs to.
  static const BulletBody& of(const btCollisionObject& object) {
    return *static_cast<const BulletBody*>(object.getUserPointer());
  }

  [[nodiscard]] BodyId id() const { return id_; }
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] Motion motion() const { return motion_; }
  [[nodiscard]] bool isDynamic() const { return motion_ == Motion::kDynamic; }
  [[nodiscard]] btRigidBody& rigid() { return *rigid_; }
  [[nodiscard]] const btRigidBody& rigid() const { return *rigid_; }

  /// Made from a LevelSet, whatever the world.
  [[nodiscard]] bool isHybrid() const { return isHybrid_; }

  /// Null unless its levels can switch.
  [[nodiscard]] btHybridRigidBody* switching() const { return switching_; }

  /// The same of a Bullet object that is a body's, without a look at the body.
  [[nodiscard]] static bool isHybrid(const btCollisionObject& object) {
    return object.getUserIndex() >= kHybrid;
  }
  [[nodiscard]] static const btHybridRigidBody* switchingOf(const btCollisionObject& object) {
    return object.getUserIndex() == kSwitching ? static_cast<const btHybridRigidBody*>(&object) : nullptr;
  }
  [[nodiscard]] int level() const;
  [[nodiscard]] int levelCount() const { return shape_->levelCount(); }

  /// Dynamic bodies: nothing moves it but setPose().
  void freeze();
  void thaw();  ///< Awake and at rest.
  [[nodiscard]] bool isFrozen() const { return isFrozen_; }

  void setHeld(bool held) { isHeld_ = held; }
  [[nodiscard]] bool isHeld() const { return isHeld_; }

  [[nodiscard]] float mass() const { return static_cast<float>(mass_); }

  /// In the state that a body at rest takes, and not frozen or static.
  [[nodiscard]] bool isAsleep() const;

  [[nodiscard]] BodyState state() const;
  void setPose(const Transform& pose);
  void wake();  ///< Unless it is frozen or static.

  /// That of the world; the body takes its share.
  void setGravity(const btVector3& gravity) { rigid_->setGravity(gravityFactor_ * gravity); }

  /// The frame `inWorld` in the frame of the centre of mass.
  [[nodiscard]] btTransform fromCenter(const Transform& inWorld) const;

  /// The frame of the centre of mass in the model's frame.
  [[nodiscard]] const Transform& center() const { return shape_->center(); }

  /// Joules; zero unless dynamic.
  [[nodiscard]] double kineticEnergy() const;
  [[nodiscard]] bool isFiniteNow() const;

 private:
  /// User indices of Bullet's objects.
  static constexpr int kHybrid = 1;
  static constexpr int kSwitching = 2;

  void rest();

  BodyId id_;
  std::string name_;
  Motion motion_;
  bool isHybrid_;
  bool mayRest_;
  bool isFrozen_ = false;
  bool isHeld_ = false;
  double mass_;
  float gravityFactor_;
  std::shared_ptr<const BulletShape> shape_;
  btHybridRigidBody* switching_ = nullptr;
  std::unique_ptr<btRigidBody> rigid_;
};

}  // namespace scatter
