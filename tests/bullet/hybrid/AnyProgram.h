#pragma once

#include <BulletDynamics/Vehicle/btRaycastVehicle.h>
#include <BulletHybrid/btHybridContactSolver.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "PairTestWorld.h"
#include "RandomGrounds.h"
#include "TestCharacter.h"

namespace scatter::test {

/// What callbacks of a thread's worlds have heard of, in its order.
inline thread_local std::uint64_t heard = 0;

/// Which of Bullet's callbacks a program has set.
class Callbacks {
 public:
  Callbacks() = default;
  Callbacks(const Callbacks&) = delete;
  Callbacks& operator=(const Callbacks&) = delete;
  ~Callbacks() { set(0); }

  static void set(int which);
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

/// A program that does between two steps whatever a program may, in any order, and the same for the same
/// seed.
class AnyProgram : public PairTestWorld {
 public:
  /// `isAlone`: no other thread has a world meanwhile, so that what all worlds share may be changed.
  explicit AnyProgram(std::uint64_t seed, bool isAlone = true)
      : PairTestWorld(seed % 5 == 0 ? BT_HYBRID_BODY_SWITCHING : BT_HYBRID_PAIR_SWITCHING, seed),
        shapes_(seed),
        grounds_(shapes_),
        hasCcd_(seed % 3 == 0),
        isAlone_(isAlone),
        isUnverified_(!isAlone || seed % 4 == 0) {
    for (int i = 0; i < 16; ++i) addAny();
    world.getSwitchingInfo().m_proximity = random().chance(0.5F);
    world.setListener(&talker_);
  }

  ~AnyProgram();
  void doAnything();
  void stepSomehow();

  [[nodiscard]] std::vector<std::uint32_t> all() const;

  /// But for manifolds that Bullet makes of bodies that are about to pass through others
  /// (setCcdMotionThreshold), which it keeps for itself.
  [[nodiscard]] int countOrphans();

  [[nodiscard]] bool isFinite() const;

 private:
  static constexpr std::size_t kMostBodies = 40;

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

  void doOne();
  void addAny();
  btCollisionShape* anyShape();
  void untieFrom(const btRigidBody& body);
  void removeAny();
  void remove(btRigidBody& body);
  void emigrate();
  void endElsewhere();
  void addBack();
  void destroy(std::size_t index);
  void destroyAny();
  void put();
  void push();
  void putToSleep();
  void changeKind();
  void changeShape();
  void changeParts();
  void clean(const btRigidBody& body);
  void cleanPairs();
  void ask();
  void limit();
  void changeRules();
  void changeWays();
  void tie();
  std::unique_ptr<btTypedConstraint> anyJoint(btRigidBody& a, btRigidBody& b);
  void untie();
  void look();
  void changeSolver();
  void changeBody();
  void changeMode();
  void sense();
  void changeBounds();
  void repeat();
  void passOnSome();
  void changeTouch();
  void ignoreOne();
  void forget(const btRigidBody& body);
  void filterPairs();
  void changeGroups();
  void moveByState();
  void walk();
  void drive();
  void endDriving();
  void workInSteps();
  void draw();
  void save();
  void sweep();
  void changeDispatch();
  void addMesh();

  RandomShapes shapes_;
  RandomGrounds grounds_;
  btHybridContactSolver wide_;
  btCollisionObject sensor_;
  std::unique_ptr<Elsewhere> elsewhere_;
  std::vector<btRigidBody*> gone_;                              ///< To it.
  std::vector<std::pair<btRigidBody*, btRigidBody*>> ignored_;  ///< Each lets the other through.
  std::vector<std::unique_ptr<btDefaultMotionState>> states_;
  std::unique_ptr<TestCharacter> character_;
  std::unique_ptr<btDefaultVehicleRaycaster> raycaster_;
  std::unique_ptr<btRaycastVehicle> vehicle_;
  bool hasSensor_ = false;
  bool hasCcd_;
  bool isAlone_;
  bool isUnverified_;
  Talker talker_{world};
};

}  // namespace scatter::test
