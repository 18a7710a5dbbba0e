#include <gtest/gtest.h>

#include <algorithm>

#include "AnyProgram.h"

// What a program does with its world, rather than with bodies.

namespace scatter::test {
namespace {

/// Hands on every pair but a few.
void passOn(btBroadphasePair& pair, btCollisionDispatcher& dispatcher, const btDispatcherInfo& info) {
  if ((pair.m_pProxy0->m_uniqueId + pair.m_pProxy1->m_uniqueId) % 7 != 0)
    btCollisionDispatcher::defaultNearCallback(pair, dispatcher, info);
}

}  // namespace

void AnyProgram::ask() {
  if (world.getNumHybrids() == 0) return;
  btHybridRigidBody* body = world.getHybrid(random().index(world.getNumHybrids()));
  switch (random().index(4)) {
    case 0:
      world.retractRequest(body);
      break;
    case 1:
      world.setHeld(body, random().chance(0.5F));
      break;
    case 2:
      requestAll(1 + random().index(3));
      break;
    default:
      world.requestLevel(body, 1 + random().index(3),
                         random().chance(0.5F) ? BT_HYBRID_LOCAL : BT_HYBRID_GLOBAL);
  }
}

void AnyProgram::limit() {
  static constexpr const char* kPolicies[] = {"speed",         "proximity", "coarsest", "load",
                                              "group-density", "focus",     "held"};
  const double machine[] = {0.001, 0.003, 0.0005};
  switch (random().index(6)) {
    case 0:
      world.removeBudget();
      break;
    case 1:
      world.setBudgetMilliseconds(random().between(0.01F, 2), machine, 3);
      break;
    case 2:
      world.addPolicy(kPolicies[random().index(static_cast<int>(std::size(kPolicies)))]);
      break;
    case 3:
      world.removePolicies();
      break;
    case 4:
      world.setFocus(random().inCube(9), random().inCube(1), 1);
      break;
    default:
      world.setBudgetUnits(random().between(5, 600));
  }
}

void AnyProgram::repeat() {
  std::vector<btHybridBudgetUnits> steps(3);
  for (btHybridBudgetUnits& step : steps) step.given = step.revised = step.settled = random().between(0, 500);
  world.replayBudget(steps.data(), 3);
}

void AnyProgram::changeRules() {
  btHybridPairSwitchingInfo& rules = world.getPairSwitchingInfo();
  rules.m_credit = random().chance(0.8F);
  rules.m_creditLevel = random().index(4);
  rules.m_retryInterval = random().index(20);
  rules.m_auditDistance = random().between(-0.01F, 0.05F);
  rules.m_earlyRest = random().chance(0.5F);
  rules.m_wakesForDetail = random().chance(0.5F);
  world.getSwitchingInfo().m_proximity = random().chance(0.5F);
  world.setGravity(random().inCube(2));
}

void AnyProgram::changeWays() {
  btHybridCollisionInfo ways = world.getCollisionInfo();
  ways.m_pairAlgorithm = !isUnverified_ || random().chance(0.9F);
  ways.m_plainBodies = random().chance(0.7F);
  ways.m_steps.midphase = static_cast<PairMidphase>(random().index(3));
  ways.m_steps.motionBound = random().chance(0.8F);
  ways.m_steps.cachedAxis = random().chance(0.8F);
  ways.m_steps.lazyManifolds = random().chance(0.8F);
  ways.m_steps.ownGjk = random().chance(0.8F);
  ways.m_steps.warmSimplex = random().chance(0.8F);
  ways.m_steps.recycling = random().chance(0.5F) ? 0.0F : random().between(0, 0.01F);
  ways.m_steps.passages = random().chance(0.7F);
  world.setCollisionInfo(ways);
}

void AnyProgram::changeMode() {
  if (random().chance(0.7F)) return;
  world.setSwitchingMode(random().chance(0.3F) ? BT_HYBRID_BODY_SWITCHING : BT_HYBRID_PAIR_SWITCHING);
}

void AnyProgram::changeSolver() {
  btConstraintSolver* const solvers[] = {&solver, &wide_};
  if (random().chance(0.5F)) wide_.setContactReduction(btHybridContactReductionInfo());
  if (random().chance(0.2F)) wide_.removeContactReduction();
  wide_.setFrictionClamp(random().chance(0.5F));
  world.setConstraintSolver(solvers[random().index(2)]);
  btContactSolverInfo& rules = world.getSolverInfo();
  rules.m_splitImpulse = random().chance(0.5F) ? 1 : 0;
  rules.m_numIterations = random().index(15);
  rules.m_minimumSolverBatchSize = random().chance(0.5F) ? 1 : 128;
  rules.m_leastSquaresResidualThreshold = random().chance(0.2F) ? 0.01F : 0.0F;
  static constexpr int kModes[] = {SOLVER_USE_2_FRICTION_DIRECTIONS, SOLVER_USE_WARMSTARTING,
                                   SOLVER_RANDMIZE_ORDER, SOLVER_ENABLE_FRICTION_DIRECTION_CACHING,
                                   SOLVER_INTERLEAVE_CONTACT_AND_FRICTION_CONSTRAINTS};
  rules.m_solverMode ^= kModes[random().index(5)];
}

void AnyProgram::look() {
  struct Heard : btCollisionWorld::ContactResultCallback {
    btScalar addSingleResult(btManifoldPoint&, const btCollisionObjectWrapper*, int, int,
                             const btCollisionObjectWrapper*, int, int) override {
      return ++count;
    }
    int count = 0;
  } found;
  const btVector3 from = random().inCube(8);
  const btVector3 to = random().inCube(8);
  btCollisionWorld::ClosestRayResultCallback ray(from, to);
  world.rayTest(from, to, ray);
  if (bodies.size() < 2) return;
  btRigidBody& a = any();
  btRigidBody& b = any();
  if (isInWorld(a)) world.contactTest(&a, found);
  if (&a != &b && isInWorld(a) && isInWorld(b)) world.contactPairTest(&a, &b, found);
  if (random().chance(0.2F)) world.performDiscreteCollisionDetection();
  if (!isUnverified_ && random().chance(0.2F)) world.verifyContacts(random().index(5));
}

// An object that is not a body, and hears of others without pushing them.
void AnyProgram::sense() {
  if (hasSensor_) {
    world.removeCollisionObject(&sensor_);
  } else {
    sensor_.setCollisionShape(anyShape());
    sensor_.setCollisionFlags(btCollisionObject::CF_NO_CONTACT_RESPONSE |
                              btCollisionObject::CF_STATIC_OBJECT);
    sensor_.setWorldTransform(random().pose(2));
    world.addCollisionObject(&sensor_);
  }
  hasSensor_ = !hasSensor_;
}

void AnyProgram::clean(const btRigidBody& body) {
  const bool isHere = !isElsewhere(body);
  btBroadphaseInterface& bounds = isHere ? broadphase : elsewhere_->broadphase;
  bounds.getOverlappingPairCache()->cleanProxyFromPairs(
      const_cast<btBroadphaseProxy*>(body.getBroadphaseHandle()),
      isHere ? &dispatcher : &elsewhere_->dispatcher);
  if (character_ && isHere) character_->cleanPairs(body);
}

void AnyProgram::cleanPairs() {
  if (bodies.empty()) return;
  btRigidBody& body = any();
  if (!isInWorld(body)) return;
  if (random().chance(0.5F)) {
    clean(body);
  } else {
    world.refreshBroadphaseProxy(&body);
  }
}

// The verification does not know of near callbacks, and finds what Bullet's algorithms do differently in
// two worlds.
void AnyProgram::passOnSome() {
  if (!isUnverified_) return;
  world.verifyContacts(0);
  dispatcher.setNearCallback(random().chance(0.2F) ? passOn : btCollisionDispatcher::defaultNearCallback);
}

void AnyProgram::emigrate() {
  if (bodies.empty()) return;
  btRigidBody& body = any();
  untieFrom(body);
  remove(body);
  if (!elsewhere_)
    elsewhere_ = std::make_unique<Elsewhere>(random().chance(0.5F) ? BT_HYBRID_PAIR_SWITCHING
                                                                   : BT_HYBRID_BODY_SWITCHING);
  elsewhere_->world->addRigidBody(&body);
  gone_.push_back(&body);
  // Twice in a world, or in two, nobody is.
  elsewhere_->world->addRigidBody(&body);
  world.addRigidBody(&body);
  world.removeRigidBody(&body);
  ASSERT_NE(world.getRefusal(), nullptr);
}

// Hybrids may outlive their world.
void AnyProgram::endElsewhere() {
  for (std::size_t i = gone_.size(); i-- > 0;) {
    if (btHybridRigidBody::upcast(gone_[i]) == nullptr) remove(*gone_[i]);
  }
  elsewhere_.reset();
  gone_.clear();
}

}  // namespace scatter::test
