#include <BulletHybrid/btHybridContactSolver.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <thread>

#include "PairTestWorld.h"
#include "RandomGrounds.h"
#include "RandomPrograms.h"

// A program that does between two steps whatever a program may, in any order: nothing breaks, nothing is left
// behind, and any number of threads gives the same bits.

namespace scatter::test {
namespace {

constexpr int kUseSteps = 150;
constexpr std::size_t kMostBodies = 40;

// Where contacts are recycled, others may begin a quarter of the contact threshold late.
constexpr btScalar kLate = 0.006F;

/// What callbacks of a thread's world have heard of in a step, in its order.
thread_local std::uint64_t heard = 0;

bool hear(const btManifoldPoint& point) {
  heard = 31 * heard + std::bit_cast<std::uint32_t>(point.getDistance());
  return true;
}
bool hearAdded(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
               const btCollisionObjectWrapper*, int, int) {
  return hear(point);
}
bool hearProcessed(btManifoldPoint& point, void*, void*) {
  return hear(point);
}
void hearManifold(btPersistentManifold* const& manifold) {
  heard = 31 * heard + manifold->getNumContacts();
}

/// Hands on every pair but a few.
void passOn(btBroadphasePair& pair, btCollisionDispatcher& dispatcher, const btDispatcherInfo& info) {
  if ((pair.m_pProxy0->m_uniqueId + pair.m_pProxy1->m_uniqueId) % 7 != 0)
    btCollisionDispatcher::defaultNearCallback(pair, dispatcher, info);
}

/// Which of Bullet's callbacks a program has set.
class Callbacks {
 public:
  Callbacks() = default;
  Callbacks(const Callbacks&) = delete;
  Callbacks& operator=(const Callbacks&) = delete;
  ~Callbacks() { set(0); }

  static void set(int which) {
    gContactAddedCallback = which == 1 ? hearAdded : nullptr;
    gContactProcessedCallback = which == 2 ? hearProcessed : nullptr;
    gContactStartedCallback = which == 3 ? hearManifold : nullptr;
    gContactEndedCallback = which == 3 ? hearManifold : nullptr;
  }
};

/// Asks for more when it hears of something.
class Talker : public btHybridListener {
 public:
  explicit Talker(btHybridDynamicsWorld& world) : world_(world) {}

  void pairEvent(const btHybridPairEvent& event) override {
    heard = 31 * heard + event.m_toLevel;
    if (heard % 5 == 0 && world_.getNumHybrids() > 0)
      world_.requestLevel(world_.getHybrid(0), 1 + event.m_toLevel % 3);
  }
  void switched(btHybridRigidBody* body, int /*from*/, int to, const btHybridRequest& /*request*/) override {
    heard = 31 * heard + to;
    if (heard % 3 == 0) world_.requestLevel(body, 1 + to % 3);
  }

 private:
  btHybridDynamicsWorld& world_;
};

/// Another world, to which bodies go.
struct Elsewhere {
  explicit Elsewhere(btHybridSwitchingMode mode)
      : world(std::make_unique<btHybridDynamicsWorld>(&dispatcher, &broadphase, &solver, &configuration,
                                                      mode)) {}

  btDefaultCollisionConfiguration configuration{BulletTestWorld<btHybridDynamicsWorld>::smallPools()};
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  std::unique_ptr<btHybridDynamicsWorld> world;
};

class AnyProgram : public PairTestWorld {
 public:
  explicit AnyProgram(std::uint64_t seed, bool mayVerify = true)
      : PairTestWorld(seed % 5 == 0 ? BT_HYBRID_BODY_SWITCHING : BT_HYBRID_PAIR_SWITCHING, seed),
        shapes_(seed),
        grounds_(shapes_),
        hasCcd_(seed % 3 == 0),
        isUnverified_(!mayVerify || seed % 4 == 0) {
    for (int i = 0; i < 16; ++i) addAny();
    world.getSwitchingInfo().m_proximity = random().chance(0.5F);
    world.setListener(&talker_);
  }

  ~AnyProgram() {
    world.setListener(nullptr);
    world.verifyContacts(0);
    world.setConstraintSolver(&solver);
    endElsewhere();
    while (!bodies.empty()) destroy(bodies.size() - 1);
    if (hasSensor_) world.removeCollisionObject(&sensor_);
    EXPECT_EQ(countOrphans(), 0);
    EXPECT_EQ(broadphase.getOverlappingPairCache()->getNumOverlappingPairs(), 0);
    EXPECT_EQ(world.getCollisionMemory().m_pairs, 0);
    EXPECT_EQ(world.getNumHybrids(), 0);
  }

  void doAnything() {
    for (int i = random().index(4); i > 0; --i) doOne();
  }

  // Bodies are drawn together, so that they meet.
  void stepSomehow() {
    for (const auto& body : bodies)
      body->applyCentralForce(-8 * body->getWorldTransform().getOrigin() / (body->getInvMass() + 0.1F));
    const int kind = random().index(8);
    if (kind == 0) {
      world.stepSimulation(1.0F / 30, 3, 1.0F / 60);
    } else if (kind == 1) {
      world.stepSimulation(0.001F, 2);
    } else if (kind == 2) {
      world.stepSimulation(0.0F, 0);
    } else {
      step();
    }
    if (elsewhere_) elsewhere_->world->stepSimulation(1.0F / 60, 0);
  }

  [[nodiscard]] std::vector<std::uint32_t> all() const {
    std::vector<std::uint32_t> result = bits();
    result.push_back(static_cast<std::uint32_t>(dispatcher.getNumManifolds()));
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i)
      result.push_back(static_cast<std::uint32_t>(manifoldAt(i).getNumContacts()));
    const btHybridCollisionCounts counts = world.getCollisionCounts();
    for (const int count : {counts.pairs, counts.childPairs, counts.gjkRuns, counts.detectorRuns})
      result.push_back(static_cast<std::uint32_t>(count));
    return result;
  }

  /// But for manifolds that Bullet makes of bodies that are about to pass through others
  /// (setCcdMotionThreshold), which it keeps for itself.
  [[nodiscard]] int countOrphans() { return hasCcd_ ? 0 : PairTestWorld::countOrphans(); }

  [[nodiscard]] bool isFinite() const {
    return std::all_of(bodies.begin(), bodies.end(), [](const auto& body) {
      const btVector3& at = body->getWorldTransform().getOrigin();
      return std::isfinite(at.length()) && std::isfinite(body->getLinearVelocity().length());
    });
  }

 private:
  [[nodiscard]] Random& random() { return shapes_.random; }
  [[nodiscard]] btRigidBody& any() {
    return *bodies[static_cast<std::size_t>(random().index(static_cast<int>(bodies.size())))];
  }
  [[nodiscard]] bool isElsewhere(const btRigidBody& body) const {
    return std::find(gone_.begin(), gone_.end(), &body) != gone_.end();
  }
  [[nodiscard]] bool isInWorld(const btRigidBody& body) const {
    return body.getWorldArrayIndex() >= 0 && !isElsewhere(body);
  }

  void doOne() {
    using Deed = void (AnyProgram::*)();
    static constexpr Deed kDeeds[] = {
        &AnyProgram::addAny,       &AnyProgram::removeAny,    &AnyProgram::addBack,
        &AnyProgram::destroyAny,   &AnyProgram::put,          &AnyProgram::push,
        &AnyProgram::putToSleep,   &AnyProgram::changeKind,   &AnyProgram::changeShape,
        &AnyProgram::changeParts,  &AnyProgram::ask,          &AnyProgram::limit,
        &AnyProgram::changeRules,  &AnyProgram::changeWays,   &AnyProgram::tie,
        &AnyProgram::untie,        &AnyProgram::look,         &AnyProgram::cleanPairs,
        &AnyProgram::changeSolver, &AnyProgram::changeMode,   &AnyProgram::sense,
        &AnyProgram::changeTouch,  &AnyProgram::changeBounds, &AnyProgram::repeat,
        &AnyProgram::passOnSome,   &AnyProgram::changeBody,   &AnyProgram::emigrate,
        &AnyProgram::endElsewhere};
    (this->*kDeeds[random().index(static_cast<int>(std::size(kDeeds)))])();
  }

  void addAny() {
    if (bodies.size() >= kMostBodies) return;
    const btTransform pose(random().rotation(), random().inCube(3));
    const int kind = random().index(10);
    if (kind < 4) {
      addBody(kind == 0   ? cross
              : kind == 1 ? block
                          : ship,
              pose, random().between(0.1F, 10), random().index(4));
      if (random().chance(0.5F)) bodies.back()->forceActivationState(ACTIVE_TAG);
      return;
    }
    if (kind == 4) {
      const GroundType type = kGrounds[random().index(static_cast<int>(std::size(kGrounds)))];
      add(0, grounds_.make(type, random().between(0.3F, 1.5F)), random().inCube(2) - btVector3(0, 3, 0));
      return;
    }
    btCollisionShape* form = anyShape();
    bodies.push_back(std::make_unique<btRigidBody>(info(random().between(0.1F, 10), form, pose.getOrigin())));
    world.addRigidBody(bodies.back().get());
  }

  btCollisionShape* anyShape() {
    const float size = random().between(0.3F, 2.0F);
    switch (random().index(4)) {
      case 0:
        return shapes_.convex(size);
      case 1:
        return shapes_.compound(1 + random().index(8), size, 0.1F);
      case 2:
        return shapes_.make<btBoxShape>(btVector3(0.4F, 0.3F, 0.5F) * size);
      default:
        return shapes_.hull(size, 4 + random().index(20));
    }
  }

  void untieFrom(const btRigidBody& body) {
    for (std::size_t i = joints.size(); i-- > 0;) {
      if (&joints[i]->getRigidBodyA() != &body && &joints[i]->getRigidBodyB() != &body) continue;
      world.removeConstraint(joints[i].get());
      joints.erase(joints.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }

  void removeAny() {
    if (bodies.empty()) return;
    btRigidBody& body = any();
    untieFrom(body);
    remove(body);
  }

  void remove(btRigidBody& body) {
    if (isElsewhere(body)) {
      elsewhere_->world->removeRigidBody(&body);
      gone_.erase(std::find(gone_.begin(), gone_.end(), &body));
    } else if (isInWorld(body)) {
      world.removeRigidBody(&body);
    }
  }

  void emigrate() {
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
  void endElsewhere() {
    for (std::size_t i = gone_.size(); i-- > 0;) {
      if (btHybridRigidBody::upcast(gone_[i]) == nullptr) remove(*gone_[i]);
    }
    elsewhere_.reset();
    gone_.clear();
  }

  void addBack() {
    for (const auto& body : bodies) {
      if (isInWorld(*body) || isElsewhere(*body)) continue;
      if (random().chance(0.5F)) {
        world.addRigidBody(body.get());
      } else {
        world.addRigidBody(body.get(), 1 + random().index(3), random().index(4) == 0 ? 0 : -1);
      }
      return;
    }
  }

  void destroy(std::size_t index) {
    untieFrom(*bodies[index]);
    remove(*bodies[index]);
    bodies.erase(bodies.begin() + static_cast<std::ptrdiff_t>(index));
  }

  void destroyAny() {
    if (bodies.size() > 8) destroy(static_cast<std::size_t>(random().index(static_cast<int>(bodies.size()))));
  }

  void put() {
    if (bodies.empty()) return;
    btRigidBody& body = any();
    const btVector3 place = random().inCube(random().chance(0.1F) ? 1e4F : 3.0F);
    body.setWorldTransform(btTransform(random().rotation(), place));
    if (random().chance(0.5F)) body.setInterpolationWorldTransform(body.getWorldTransform());
    if (random().chance(0.3F) && isInWorld(body)) world.updateSingleAabb(&body);
    body.activate();
  }

  void push() {
    if (bodies.empty()) return;
    btRigidBody& body = any();
    if (body.isStaticObject()) return;
    body.setLinearVelocity(random().inCube(random().chance(0.1F) ? 300.0F : 5.0F));
    body.setAngularVelocity(random().inCube(random().chance(0.1F) ? 40.0F : 3.0F));
    body.activate();
  }

  void putToSleep() {
    if (bodies.empty()) return;
    static constexpr int kStates[] = {ACTIVE_TAG, ISLAND_SLEEPING, WANTS_DEACTIVATION, DISABLE_DEACTIVATION,
                                      DISABLE_SIMULATION};
    any().forceActivationState(kStates[random().index(5)]);
  }

  // Bodies with mass become kinematic and back, or let others through.
  void changeKind() {
    if (bodies.empty()) return;
    btRigidBody& body = any();
    if (body.getInvMass() == 0) return;
    const int flag = random().chance(0.5F) ? btCollisionObject::CF_KINEMATIC_OBJECT
                                           : btCollisionObject::CF_NO_CONTACT_RESPONSE;
    body.setCollisionFlags(body.getCollisionFlags() ^ flag);
    body.forceActivationState(ACTIVE_TAG);
  }

  void changeShape() {
    if (bodies.empty()) return;
    btRigidBody& body = any();
    if (btHybridRigidBody::upcast(&body) != nullptr) return;
    if (random().chance(0.5F) || body.isStaticObject()) {
      body.getCollisionShape()->setLocalScaling(btVector3(1, 1, 1) * random().between(0.5F, 1.5F));
    } else {
      body.setCollisionShape(anyShape());
      if (isInWorld(body) || isElsewhere(body)) clean(body);
    }
  }

  void changeParts() {
    if (bodies.empty()) return;
    btRigidBody& body = any();
    if (btHybridRigidBody::upcast(&body) != nullptr || !body.getCollisionShape()->isCompound()) return;
    auto* parts = static_cast<btCompoundShape*>(body.getCollisionShape());
    if (parts->getNumChildShapes() > 1 && random().chance(0.5F)) {
      parts->removeChildShapeByIndex(random().index(parts->getNumChildShapes()));
    } else {
      btCollisionShape* part = shapes_.convex(0.5F);
      if (random().chance(0.2F)) part = shapes_.compound(2, 0.5F);
      parts->addChildShape(random().pose(0.3F), part);
    }
  }

  void clean(const btRigidBody& body) {
    const bool isHere = !isElsewhere(body);
    btBroadphaseInterface& bounds = isHere ? broadphase : elsewhere_->broadphase;
    bounds.getOverlappingPairCache()->cleanProxyFromPairs(
        const_cast<btBroadphaseProxy*>(body.getBroadphaseHandle()),
        isHere ? &dispatcher : &elsewhere_->dispatcher);
  }

  void cleanPairs() {
    if (bodies.empty()) return;
    btRigidBody& body = any();
    if (!isInWorld(body)) return;
    if (random().chance(0.5F)) {
      clean(body);
    } else {
      world.refreshBroadphaseProxy(&body);
    }
  }

  void ask() {
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

  void limit() {
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

  void changeRules() {
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

  void changeWays() {
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

  void tie() {
    if (bodies.size() < 2) return;
    btRigidBody& a = any();
    btRigidBody& b = any();
    if (&a == &b || !isInWorld(a) || !isInWorld(b)) return;
    joints.push_back(anyJoint(a, b));
    if (random().chance(0.2F)) joints.back()->setBreakingImpulseThreshold(random().between(0, 5));
    if (random().chance(0.1F)) joints.back()->setEnabled(false);
    world.addConstraint(joints.back().get(), random().chance(0.5F));
  }

  std::unique_ptr<btTypedConstraint> anyJoint(btRigidBody& a, btRigidBody& b) {
    const btTransform inA = random().pose(0.5F);
    const btTransform inB = random().pose(0.5F);
    switch (random().index(5)) {
      case 0:
        return std::make_unique<btFixedConstraint>(a, b, inA, inB);
      case 1:
        return std::make_unique<btSliderConstraint>(a, b, inA, inB, true);
      case 2: {
        auto hinge = std::make_unique<btHingeConstraint>(a, b, inA, inB);
        hinge->enableAngularMotor(true, random().between(-3, 3), 1);
        return hinge;
      }
      case 3:
        return std::make_unique<btGeneric6DofSpring2Constraint>(a, b, inA, inB);
      default:
        return std::make_unique<btPoint2PointConstraint>(a, b, inA.getOrigin(), inB.getOrigin());
    }
  }

  void untie() {
    if (joints.empty()) return;
    world.removeConstraint(joints.back().get());
    joints.pop_back();
  }

  void look() {
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

  void changeSolver() {
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

  void changeBody() {
    if (bodies.empty()) return;
    btRigidBody& body = any();
    body.setLinearFactor(random().chance(0.8F) ? btVector3(1, 1, 1) : btVector3(1, 0, 1));
    body.setAngularFactor(random().chance(0.8F) ? btVector3(1, 1, 1) : btVector3(0, 1, 0));
    body.setDamping(random().between(0, 1), random().between(0, 1));
    body.setSleepingThresholds(random().between(0, 3), random().between(0, 3));
    body.setGravity(random().inCube(3));
    body.setDeactivationTime(random().between(0, 3));
  }

  void changeMode() {
    if (random().chance(0.7F)) return;
    world.setSwitchingMode(random().chance(0.3F) ? BT_HYBRID_BODY_SWITCHING : BT_HYBRID_PAIR_SWITCHING);
  }

  // An object that is not a body, and hears of others without pushing them.
  void sense() {
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

  void changeBounds() {
    if (bodies.empty()) return;
    btRigidBody& body = any();
    if (btHybridRigidBody::upcast(&body) == nullptr && body.getCollisionShape()->isConvex())
      body.getCollisionShape()->setMargin(random().between(0, 0.05F));
  }

  void repeat() {
    std::vector<btHybridBudgetUnits> steps(3);
    for (btHybridBudgetUnits& step : steps)
      step.given = step.revised = step.settled = random().between(0, 500);
    world.replayBudget(steps.data(), 3);
  }

  // The verification does not know of near callbacks, and finds what Bullet's algorithms do differently in
  // two worlds.
  void passOnSome() {
    if (!isUnverified_) return;
    world.verifyContacts(0);
    dispatcher.setNearCallback(random().chance(0.2F) ? passOn : btCollisionDispatcher::defaultNearCallback);
  }

  void changeTouch() {
    if (bodies.empty()) return;
    btRigidBody& body = any();
    body.setFriction(random().between(0, 2));
    body.setRestitution(random().between(0, 1));
    body.setRollingFriction(random().chance(0.2F) ? 0.1F : 0.0F);
    body.setCollisionFlags(body.getCollisionFlags() ^ btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
    if (random().chance(0.2F)) body.setContactStiffnessAndDamping(1000, 10);
    if (random().chance(0.2F)) body.setAnisotropicFriction(btVector3(1, 0.1F, 1));
    if (hasCcd_ && random().chance(0.2F)) body.setCcdMotionThreshold(0.01F);
    body.setCcdSweptSphereRadius(0.1F);
    if (body.getInvMass() > 0 && random().chance(0.2F))
      body.setMassProps(random().between(0.1F, 5), random().inCube(0.5F).absolute() + btVector3(1, 1, 1));
  }

  RandomShapes shapes_;
  RandomGrounds grounds_;
  btHybridContactSolver wide_;
  btCollisionObject sensor_;
  std::unique_ptr<Elsewhere> elsewhere_;
  std::vector<btRigidBody*> gone_;  ///< To it.
  bool hasSensor_ = false;
  bool hasCcd_;
  bool isUnverified_;
  Talker talker_{world};
};

/// Contacts that Bullet has and the world has not, or the other way round, in its last verified step.
std::string describe(const btAlignedObjectArray<btHybridMissedContact>& contacts) {
  std::string text;
  for (int i = 0; i < btMin(contacts.size(), 3); ++i) {
    const btHybridMissedContact& one = contacts[i];
    for (const auto& [object, child] :
         {std::pair(one.m_bodyA, one.m_childA), std::pair(one.m_bodyB, one.m_childB)}) {
      text += std::string(object->getCollisionShape()->getName()) + " " +
              std::to_string(object->getWorldArrayIndex()) + " child " + std::to_string(child) + ", ";
    }
    text += std::to_string(one.m_distance) + " m\n";
  }
  return text;
}

/// Of these. Bullet's GJK does not find all that are a gap apart, or those of round shapes in both of two
/// worlds.
btScalar nearest(const btAlignedObjectArray<btHybridMissedContact>& contacts) {
  btScalar least = 1;
  for (int i = 0; i < contacts.size(); ++i) least = btMin(least, contacts[i].m_distance);
  return least;
}

/// What the programs have come to.
struct Seen {
  long expected = 0;
  long missed = 0;
  long extra = 0;
  long manifolds = 0;
  long credited = 0;
  long switches = 0;

  void add(AnyProgram& program) {
    const btHybridPairStepInfo info = program.world.getPairStepInfo();
    manifolds += program.dispatcher.getNumManifolds();
    credited += info.creditedPairs;
    switches += info.switchesCoarser + info.switchesFiner;
  }
  void add(const btHybridContactReport& report) {
    expected += report.m_expected;
    missed += report.m_missed;
    extra += report.m_extra;
  }
};

TEST(RandomUse, BreaksNothingAndGivesTheSameBitsOnThreads) {
  Seen seen;
  const std::vector<std::uint64_t> all = programs(100);
  for (const std::uint64_t seed : all) {
    SCOPED_TRACE("program " + std::to_string(seed));
    AnyProgram one(seed);
    AnyProgram other(seed);
    Random random(seed);
    const Callbacks callbacks;
    for (int step = 0; step < kUseSteps; ++step) {
      if (step % 20 == 0) other.world.setNumThreads(1 + random.index(4));
      if (step % 20 == 10) Callbacks::set(random.index(7));
      heard = 0;
      one.doAnything();
      one.stepSomehow();
      const std::uint64_t heardByOne = std::exchange(heard, 0);
      other.doAnything();
      other.stepSomehow();
      ASSERT_EQ(heard, heardByOne) << "step " << step;
      ASSERT_TRUE(one.isFinite()) << "step " << step;
      ASSERT_EQ(one.countOrphans(), 0) << "step " << step;
      ASSERT_EQ(one.all(), other.all()) << "step " << step;
      seen.add(one);
      const btHybridContactReport& report = one.world.getContactReport();
      ASSERT_GE(nearest(report.m_lastMissed), -kLate)
          << "step " << step << ": " << describe(report.m_lastMissed);
      ASSERT_GE(nearest(report.m_lastExtra), -kLate)
          << "step " << step << ": " << describe(report.m_lastExtra);
    }
    seen.add(one.world.getContactReport());
  }
  EXPECT_LE(seen.missed + seen.extra, seen.expected / 1000);
  const auto steps = static_cast<long>(all.size()) * kUseSteps;
  EXPECT_GT(seen.manifolds, 5 * steps);
  EXPECT_GT(seen.credited, steps / 10);
  EXPECT_GT(seen.switches, steps / 50);
}

// Verification silences Bullet's callbacks, which all worlds share.
std::vector<std::uint32_t> runOne(std::uint64_t seed) {
  heard = 0;
  AnyProgram program(seed, false);
  program.world.setNumThreads(1 + static_cast<int>(seed % 2));
  for (int step = 0; step < 60; ++step) {
    program.doAnything();
    program.stepSomehow();
  }
  return program.all();
}

TEST(RandomUse, WorldsOfSeveralThreadsAreAsAlone) {
  const std::vector<std::uint64_t> all = programs(24);
  std::vector<std::vector<std::uint32_t>> alone;
  for (const std::uint64_t seed : all) alone.push_back(runOne(seed));
  std::vector<std::vector<std::uint32_t>> beside(all.size());
  std::vector<std::thread> threads;
  for (std::size_t first = 0; first < 3; ++first) {
    threads.emplace_back([&all, &beside, first] {
      for (std::size_t i = first; i < all.size(); i += 3) beside[i] = runOne(all[i]);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(alone[i], beside[i]) << "program " << all[i];
}

}  // namespace
}  // namespace scatter::test
