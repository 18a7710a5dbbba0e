#pragma once

#include <BulletHybrid/btHybridDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <vector>

namespace scatter::test {

/// A hybrid world and a body that it does not own.
class LooseWorld {
 public:
  explicit LooseWorld(btHybridSwitchingMode mode = BT_HYBRID_PAIR_SWITCHING)
      : world_(std::make_unique<btHybridDynamicsWorld>(&dispatcher_, &broadphase_, &solver_, &configuration_,
                                                       mode)) {
    world_->setGravity(btVector3(0, 0, 0));
    world_->getSwitchingInfo().m_proximity = false;
  }

  btHybridDynamicsWorld& operator*() { return *world_; }
  btHybridDynamicsWorld* operator->() { return world_.get(); }
  btHybridDynamicsWorld* get() { return world_.get(); }
  void end() { world_.reset(); }
  btCollisionDispatcher& dispatcher() { return dispatcher_; }
  void step() { world_->stepSimulation(1.0F / 60, 0); }

 private:
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  std::unique_ptr<btHybridDynamicsWorld> world_;
};

/// Levels for bodies of any world: two crossing bars in the cube around them.
class MisuseTest : public testing::Test {
 protected:
  MisuseTest() {
    bars_.addChildShape(btTransform::getIdentity(), &barX_);
    bars_.addChildShape(btTransform::getIdentity(), &barZ_);
    levels_.addLevel(&cube_);
    levels_.addLevel(&bars_);
  }

  static btRigidBody::btRigidBodyConstructionInfo info(btCollisionShape* shape, float x = 0) {
    btRigidBody::btRigidBodyConstructionInfo result(1, nullptr, shape, btVector3(1, 1, 1));
    result.m_startWorldTransform.setOrigin(btVector3(x, 0, 0));
    return result;
  }

  std::unique_ptr<btHybridRigidBody> body(float x = 0) {
    auto made = std::make_unique<btHybridRigidBody>(info(nullptr, x), &levels_);
    made->setActivationState(DISABLE_DEACTIVATION);
    return made;
  }

  btBoxShape cube_{btVector3(1, 1, 1)};
  btBoxShape barX_{btVector3(1, 0.2F, 0.2F)};
  btBoxShape barZ_{btVector3(0.2F, 0.2F, 1)};
  btCompoundShape bars_;
  btHybridLevelSet levels_;
};

using PairCall = std::function<const char*(btHybridDynamicsWorld&)>;

/// Every call of pair switching that can be refused, with arguments that are sound.
inline std::vector<PairCall> soundPairCalls() {
  return {
      [](btHybridDynamicsWorld& w) { return w.setBudgetMilliseconds(4); },
      [](btHybridDynamicsWorld& w) {
        const double machine[] = {0.001, 0.002};
        return w.setBudgetMilliseconds(4, machine, 2);
      },
      [](btHybridDynamicsWorld& w) { return w.setBudgetUnits(4); },
      [](btHybridDynamicsWorld& w) {
        const btHybridBudgetUnits steps[] = {{3, 3, 3}, {}, {5, 4, 5}};
        return w.replayBudget(steps, 3);
      },
      [](btHybridDynamicsWorld& w) { return w.removeBudget(); },
      [](btHybridDynamicsWorld& w) { return w.addPolicy("speed"); },
      [](btHybridDynamicsWorld& w) { return w.checkPolicy("speed"); },
      [](btHybridDynamicsWorld& w) { return w.removePolicies(); },
      [](btHybridDynamicsWorld& w) {
        return w.setFocus({0, 0, 0}, {1, 0, 0}, 1);
      },
      [](btHybridDynamicsWorld& w) { return w.removeFocus(); },
  };
}

}  // namespace scatter::test
