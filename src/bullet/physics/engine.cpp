#include "bullet/physics/engine.h"

#include <BulletHybrid/btHybridDynamicsWorld.h>

#include <cassert>
#include <cstdio>
#include <string>
#include <vector>

#include "bullet/shapes/conversions.h"

namespace scatter {

namespace {

bool switchesByPair(const SwitchingDef& def) {
  return def.switching == Switching::kPair;
}

/// In the words of pair switching.
std::vector<std::string> policyNames(Policy policy, std::vector<std::string> named) {
  if (policy == Policy::kCoarsest) named.emplace_back("coarsest");
  if (policy == Policy::kProximity) named.emplace_back("proximity");
  return named;
}

/// What is checked before a world is told is refused only by mistake, which must not pass unnoticed.
bool isDone(const char* mistake) {
  if (mistake == nullptr) return true;
  std::fprintf(stderr, "scatter: %s\n", mistake);
  assert(false && "refused by the Bullet world");
  return false;
}

void addPolicies(btHybridDynamicsWorld& world, const std::vector<std::string>& policies) {
  for (const std::string& policy : policies) isDone(world.addPolicy(policy.c_str()));
}

bool isLimited(const BudgetDef& budget) {
  return !budget.recorded.empty() || budget.units != 0.0 || budget.milliseconds != 0.0;
}

bool applyBudget(btHybridDynamicsWorld& world, const BudgetDef& budget) {
  if (!budget.recorded.empty()) {
    return isDone(world.replayBudget(budget.recorded.data(), static_cast<int>(budget.recorded.size())));
  }
  if (budget.units != 0.0) return isDone(world.setBudgetUnits(budget.units));
  if (budget.milliseconds != 0.0 && !budget.machine.empty()) {
    return isDone(world.setBudgetMilliseconds(budget.milliseconds, budget.machine.data(),
                                              static_cast<int>(budget.machine.size())));
  }
  if (budget.milliseconds != 0.0) return isDone(world.setBudgetMilliseconds(budget.milliseconds));
  return isDone(world.removeBudget());
}

void setUpPairSwitching(btHybridDynamicsWorld& world, const SwitchingDef& def) {
  btHybridPairSwitchingInfo& info = world.getPairSwitchingInfo();
  info.m_credit = def.credit;
  info.m_creditLevel = def.creditLevel;
  info.m_retryInterval = def.retryInterval;
  info.m_safetyConditions = def.safetyConditions;
  addPolicies(world, policyNames(def.policy, def.policies));
  if (isLimited(def.budget)) applyBudget(world, def.budget);
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
  btHybridCollisionInfo info;
  info.m_pairAlgorithm = def.narrowphase == Narrowphase::kScatter;
  info.m_steps = def.pairAlgorithm;
  return info;
}

btHybridContactReductionInfo reductionInfo(const PhysicsDef& def) {
  btHybridContactReductionInfo info;
  info.m_mostAlike = def.contactsPerDirection;
  return info;
}

std::unique_ptr<btSequentialImpulseConstraintSolver> makeSolver(const PhysicsDef& def,
                                                                BulletStageTimer& timer) {
  if (def.solver != ContactSolver::kWide) return std::make_unique<BulletTimedSolver>(timer);
  auto solver = std::make_unique<BulletTimedContactSolver>(timer);
  if (def.contactsPerDirection > 0) solver->setContactReduction(reductionInfo(def));
  return solver;
}

}  // namespace

BulletEngine::BulletEngine(const PhysicsDef& def)
    : dispatcher_(&configuration_), solver_(makeSolver(def, timer_)), reduction_(solver_.get()) {
  btConstraintSolver* const solver = solverOf(def);
  broadphase_.getOverlappingPairCache()->setOverlapFilterCallback(&filter_);
  if (def.world == WorldKind::kHybrid) {
    const bool byPair = switchesByPair(def.switching);
    auto hybrid =
        std::make_unique<btHybridDynamicsWorld>(&dispatcher_, &broadphase_, solver, &configuration_,
                                                byPair ? BT_HYBRID_PAIR_SWITCHING : BT_HYBRID_BODY_SWITCHING);
    hybrid->getSwitchingInfo() = switchingInfo(def.switching);
    if (byPair) setUpPairSwitching(*hybrid, def.switching);
    isDone(hybrid->setCollisionInfo(collisionInfo(def.collision)));
    hybrid->verifyContacts(def.collision.verifyEvery);
    isDone(hybrid->setNumThreads(def.threads));
    hybrid->setPromises(BT_HYBRID_CONTACT_ADDED_ON_ANY_THREAD);
    switching_ = hybrid.get();
    world_ = std::move(hybrid);
  } else {
    world_ = std::make_unique<btDiscreteDynamicsWorld>(&dispatcher_, &broadphase_, solver, &configuration_);
  }
  world_->setGravity(toBullet(def.gravity));
  world_->getSolverInfo().m_numIterations = def.solverIterations;
}

btConstraintSolver* BulletEngine::solverOf(const PhysicsDef& def) {
  if (def.contactsPerDirection == 0 || def.solver == ContactSolver::kWide) return solver_.get();
  reduction_.getContactReductionInfo() = reductionInfo(def);
  return &reduction_;
}

bool BulletEngine::setBudget(const BudgetDef& budget) {
  return applyBudget(*switching_, budget);
}

void BulletEngine::setFocus(const std::optional<ViewFocus>& focus) {
  isDone(focus ? switching_->setFocus(toBullet(focus->eye), toBullet(focus->target), focus->fieldOfView)
               : switching_->removeFocus());
}

Result<void> BulletEngine::setPolicies(Policy policy, const std::vector<std::string>& names) {
  if (switching_->getSwitchingMode() == BT_HYBRID_BODY_SWITCHING) {
    if (!names.empty()) return fail("policy \"" + names[0] + "\" needs pair switching; bodies switch here");
    switching_->getSwitchingInfo().m_proximity = policy == Policy::kProximity;
    return {};
  }
  const std::vector<std::string> policies = policyNames(policy, names);
  for (const std::string& name : policies) {
    if (const char* mistake = switching_->checkPolicy(name.c_str())) return fail(mistake);
  }
  if (const char* mistake = switching_->removePolicies()) return fail(mistake);
  addPolicies(*switching_, policies);
  return {};
}

Result<void> BulletEngine::setSwitching(const SwitchingDef& def) {
  const bool byPair = switchesByPair(def);
  const int deep = switching_->setSwitchingMode(byPair ? BT_HYBRID_PAIR_SWITCHING : BT_HYBRID_BODY_SWITCHING);
  if (deep < 0) return fail("switching cannot change inside a step; change it between two");
  if (deep > 0) {
    return fail(
        "switching by bodies would push apart " + std::to_string(deep) +
        " pair(s) on penetration credit, whose finest shapes overlap by more than 2 cm; wait until they are "
        "apart, or start the scene again");
  }
  switching_->getSwitchingInfo() = switchingInfo(def);
  if (byPair) setUpPairSwitching(*switching_, def);
  return {};
}

void BulletEngine::forgetStillContacts(btCollisionObject& object) {
  btOverlappingPairCache& pairs = *broadphase_.getOverlappingPairCache();
  for (int i = 0; i < pairs.getNumOverlappingPairs(); ++i) {
    btBroadphasePair& pair = pairs.getOverlappingPairArrayPtr()[i];
    const auto* first = static_cast<const btCollisionObject*>(pair.m_pProxy0->m_clientObject);
    const auto* second = static_cast<const btCollisionObject*>(pair.m_pProxy1->m_clientObject);
    if (first != &object && second != &object) continue;
    if ((first == &object ? second : first)->isStaticOrKinematicObject()) {
      pairs.cleanOverlappingPair(pair, &dispatcher_);
    }
  }
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
