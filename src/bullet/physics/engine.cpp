#include "bullet/physics/engine.h"

#include <BulletHybrid/btHybridDynamicsWorld.h>

#include <cassert>
#include <string>
#include <vector>

#include "bullet/physics/conversions.h"

namespace scatter {

namespace {

void setUpPairSwitching(btHybridDynamicsWorld& world, const SwitchingDef& def) {
  btHybridPairSwitchingInfo& info = world.getPairSwitchingInfo();
  info.m_credit = def.credit;
  info.m_creditLevel = def.creditLevel;
  info.m_retryInterval = def.retryInterval;
  info.m_safetyConditions = def.safetyConditions;
  std::vector<std::string> policies = def.policies;
  if (def.policy == Policy::kCoarsest) policies.emplace_back("coarsest");
  if (def.policy == Policy::kProximity) policies.emplace_back("proximity");
  for (const std::string& policy : policies) {
    [[maybe_unused]] const char* mistake = world.addPolicy(policy.c_str());
    assert(mistake == nullptr && "policies are checked before a world is made");
  }
  const BudgetDef& budget = def.budget;
  if (!budget.recorded.empty()) {
    world.replayBudget(budget.recorded.data(), static_cast<int>(budget.recorded.size()));
  } else if (budget.units > 0.0) {
    world.setBudgetUnits(budget.units);
  } else if (budget.milliseconds > 0.0) {
    world.setBudgetMilliseconds(budget.milliseconds);
  }
}

btHybridSwitchingInfo switchingInfo(const SwitchingDef& def) {
  btHybridSwitchingInfo info;
  info.m_proximity = def.policy == Policy::kProximity;
  info.m_proximitySteps = def.proximitySteps;
  info.m_retryInterval = def.retryInterval;
  info.m_quietSteps = def.quietSteps;
  info.m_safetyGap = def.safetyGap;
  info.m_safetyConditions = def.safetyConditions;
  return info;
}

btHybridCollisionInfo collisionInfo(const CollisionDef& def) {
  constexpr btHybridMidphase kMidphases[]{BT_HYBRID_WORLD_BOXES, BT_HYBRID_PART_BOXES,
                                          BT_HYBRID_NEIGHBOUR_LIST};
  btHybridCollisionInfo info;
  info.m_pairAlgorithm = def.narrowphase == Narrowphase::kScatter;
  info.m_midphase = kMidphases[static_cast<int>(def.pairAlgorithm.midphase)];
  info.m_motionBound = def.pairAlgorithm.motionBound;
  info.m_cachedAxis = def.pairAlgorithm.cachedAxis;
  info.m_lazyManifolds = def.pairAlgorithm.lazyManifolds;
  info.m_ownGjk = def.pairAlgorithm.ownGjk;
  info.m_warmSimplex = def.pairAlgorithm.warmSimplex;
  return info;
}

}  // namespace

BulletEngine::BulletEngine(const PhysicsDef& def) : dispatcher_(&configuration_), solver_(timer_) {
  broadphase_.getOverlappingPairCache()->setOverlapFilterCallback(&filter_);
  if (def.world == WorldKind::kHybrid) {
    const bool byPair = def.switching.switching == Switching::kPair;
    auto hybrid =
        std::make_unique<btHybridDynamicsWorld>(&dispatcher_, &broadphase_, &solver_, &configuration_,
                                                byPair ? BT_HYBRID_PAIR_SWITCHING : BT_HYBRID_BODY_SWITCHING);
    hybrid->getSwitchingInfo() = switchingInfo(def.switching);
    if (byPair) setUpPairSwitching(*hybrid, def.switching);
    hybrid->setCollisionInfo(collisionInfo(def.collision));
    hybrid->verifyContacts(def.collision.verifyEvery);
    switching_ = hybrid.get();
    world_ = std::move(hybrid);
  } else {
    world_ = std::make_unique<btDiscreteDynamicsWorld>(&dispatcher_, &broadphase_, &solver_, &configuration_);
  }
  world_->setGravity(toBullet(def.gravity));
  world_->getSolverInfo().m_numIterations = def.solverIterations;
}

void BulletEngine::forgetContacts(btCollisionObject& a, btCollisionObject& b) {
  btOverlappingPairCache& pairs = *broadphase_.getOverlappingPairCache();
  btBroadphasePair* pair = pairs.findPair(a.getBroadphaseHandle(), b.getBroadphaseHandle());
  if (pair != nullptr) pairs.cleanOverlappingPair(*pair, &dispatcher_);
}

void BulletEngine::wakeNeighbours(const btCollisionObject& object) {
  for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
    const btPersistentManifold& manifold = *dispatcher_.getManifoldByIndexInternal(i);
    if (manifold.getNumContacts() == 0) continue;
    if (manifold.getBody0() == &object) manifold.getBody1()->activate();
    if (manifold.getBody1() == &object) manifold.getBody0()->activate();
  }
}

}  // namespace scatter
