#pragma once

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <BulletHybrid/btHybridContactReduction.h>
#include <scatter/world/physics.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bullet/physics/dispatcher.h"
#include "bullet/physics/pair_filter.h"
#include "bullet/physics/stage_timer.h"
#include "bullet/physics/timed_solver.h"

class btHybridDynamicsWorld;

namespace scatter {

/// A Bullet world and the parts it is put together from. Empty it before it goes.
class BulletEngine {
 public:
  explicit BulletEngine(const PhysicsDef& def);

  [[nodiscard]] btDiscreteDynamicsWorld& world() { return *world_; }
  [[nodiscard]] const btDiscreteDynamicsWorld& world() const { return *world_; }
  [[nodiscard]] BulletDispatcher& dispatcher() { return dispatcher_; }
  [[nodiscard]] BulletStageTimer& timer() { return timer_; }

  /// Null in a standard world.
  [[nodiscard]] btHybridDynamicsWorld* switching() { return switching_; }
  [[nodiscard]] const btHybridDynamicsWorld* switching() const { return switching_; }

  /// Of pair switching, which must be on. False, and nothing changes, if the world refuses it, for what
  /// stderr is told.
  bool setBudget(const BudgetDef& budget);

  /// The same; nothing: no focus.
  void setFocus(const std::optional<ViewFocus>& focus);

  /// In a hybrid world. Fails, and changes nothing, on names that are not known, and on any with body
  /// switching.
  [[nodiscard]] Result<void> setPolicies(Policy policy, const std::vector<std::string>& names);

  /// In a hybrid world, to what `def` says. Fails, and changes nothing, if it is not safe.
  [[nodiscard]] Result<void> setSwitching(const SwitchingDef& def);

  /// Drops what is known about how an object touches those that do not move: what nothing moves collides with
  /// none of them.
  void forgetStillContacts(btCollisionObject& object);

  /// Drops what is known about how the two objects touch.
  void forgetContacts(btCollisionObject& a, btCollisionObject& b);

  /// Wakes all bodies that touch `object`.
  void wakeNeighbours(const btCollisionObject& object);

 private:
  [[nodiscard]] btConstraintSolver* solverOf(const PhysicsDef& def);

  BulletStageTimer timer_;
  btDefaultCollisionConfiguration configuration_;
  BulletDispatcher dispatcher_;
  BulletPairFilter filter_;
  btDbvtBroadphase broadphase_;
  std::unique_ptr<btSequentialImpulseConstraintSolver> solver_;
  btHybridContactReduction reduction_;
  std::unique_ptr<btDiscreteDynamicsWorld> world_;
  btHybridDynamicsWorld* switching_ = nullptr;
};

}  // namespace scatter
