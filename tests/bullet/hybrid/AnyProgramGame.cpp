#include <BulletCollision/Gimpact/btGImpactCollisionAlgorithm.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "AnyProgram.h"

// What games do with a world besides bodies and their switching: ghosts, characters, vehicles, filters, work
// within a step, drawing and saving.

namespace scatter::test {
namespace {

/// Counts what it is asked to draw.
class CountingDrawer : public btIDebugDraw {
 public:
  void drawLine(const btVector3&, const btVector3&, const btVector3&) override { ++lines; }
  void drawContactPoint(const btVector3&, const btVector3&, btScalar, int, const btVector3&) override {
    ++lines;
  }
  void reportErrorWarning(const char*) override {}
  void draw3dText(const btVector3&, const char*) override {}
  void setDebugMode(int mode) override { mode_ = mode; }
  int getDebugMode() const override { return mode_; }

  long lines = 0;

 private:
  int mode_ = DBG_DrawWireframe | DBG_DrawAabb | DBG_DrawContactPoints | DBG_DrawConstraints;
};

/// Lets a few pairs never come up.
class FewPairs : public btOverlapFilterCallback {
 public:
  bool needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const override {
    if ((a->m_collisionFilterGroup & b->m_collisionFilterMask) == 0) return false;
    if ((b->m_collisionFilterGroup & a->m_collisionFilterMask) == 0) return false;
    return (a->m_uniqueId + b->m_uniqueId) % 6 != 0;
  }
};

}  // namespace

void AnyProgram::ignoreOne() {
  if (bodies.size() < 2) return;
  btRigidBody& a = any();
  btRigidBody& b = any();
  if (&a == &b) return;
  const auto known = std::find(ignored_.begin(), ignored_.end(), std::pair(&a, &b));
  a.setIgnoreCollisionCheck(&b, known == ignored_.end());
  if (known == ignored_.end()) {
    ignored_.emplace_back(&a, &b);
  } else {
    ignored_.erase(known);
  }
}

void AnyProgram::forget(const btRigidBody& body) {
  for (std::size_t i = ignored_.size(); i-- > 0;) {
    const auto [a, b] = ignored_[i];
    if (a != &body && b != &body) continue;
    a->setIgnoreCollisionCheck(b, false);
    ignored_.erase(ignored_.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

// Pairs that there are stay when the filter changes, here and in the verification's world, which has others.
void AnyProgram::filterPairs() {
  static FewPairs few;
  if (!isUnverified_) return;
  broadphase.getOverlappingPairCache()->setOverlapFilterCallback(random().chance(0.3F) ? &few : nullptr);
}

// A pair that there is stays until the broadphase is told; the verification goes by what it was told.
void AnyProgram::changeGroups() {
  if (bodies.empty()) return;
  btRigidBody& body = any();
  if (!isInWorld(body)) return;
  body.getBroadphaseHandle()->m_collisionFilterGroup = 1 << random().index(3);
  body.getBroadphaseHandle()->m_collisionFilterMask = random().chance(0.7F) ? -1 : random().index(8);
  if (!isUnverified_ || random().chance(0.7F)) world.refreshBroadphaseProxy(&body);
}

void AnyProgram::moveByState() {
  if (bodies.empty()) return;
  btRigidBody& body = any();
  states_.push_back(std::make_unique<btDefaultMotionState>(body.getWorldTransform()));
  body.setMotionState(states_.back().get());
}

void AnyProgram::walk() {
  letWalk(character_, world, random());
}

// All vehicles of a process share Bullet's body for what stands still.
void AnyProgram::drive() {
  if (!isAlone_ || bodies.empty()) return;
  if (vehicle_) {
    vehicle_->setSteeringValue(random().between(-0.5F, 0.5F), 0);
    vehicle_->applyEngineForce(random().between(-20, 20), 1);
    if (random().chance(0.4F)) endDriving();
    return;
  }
  btRigidBody& chassis = any();
  if (!isInWorld(chassis) || chassis.getInvMass() == 0) return;
  raycaster_ = std::make_unique<btDefaultVehicleRaycaster>(&world);
  const btRaycastVehicle::btVehicleTuning tuning;
  vehicle_ = std::make_unique<btRaycastVehicle>(tuning, &chassis, raycaster_.get());
  for (const float x : {-0.5F, 0.5F}) {
    for (const float z : {-0.6F, 0.6F})
      vehicle_->addWheel(btVector3(x, -0.2F, z), btVector3(0, -1, 0), btVector3(-1, 0, 0), 0.4F, 0.3F, tuning,
                         z > 0);
  }
  world.addAction(vehicle_.get());
}

void AnyProgram::endDriving() {
  if (!vehicle_) return;
  world.removeAction(vehicle_.get());
  vehicle_.reset();
  raycaster_.reset();
}

// Games take bodies out, and ask for levels, when Bullet tells them of a step.
void AnyProgram::workInSteps() {
  const int when = random().index(3);
  world.setInternalTickCallback(nullptr, this, false);
  world.setInternalTickCallback(nullptr, this, true);
  if (when == 0) return;
  const auto tick = [](btDynamicsWorld* of, btScalar) {
    auto& program = *static_cast<AnyProgram*>(of->getWorldUserInfo());
    using Deed = void (AnyProgram::*)();
    static constexpr std::array<Deed, 9> kDeeds{
        &AnyProgram::push,       &AnyProgram::ask,        &AnyProgram::limit,
        &AnyProgram::removeAny,  &AnyProgram::addBack,    &AnyProgram::put,
        &AnyProgram::destroyAny, &AnyProgram::putToSleep, &AnyProgram::untie};
    if (program.random().chance(0.3F))
      (program.*kDeeds[static_cast<std::size_t>(program.random().index(9))])();
  };
  world.setInternalTickCallback(tick, this, when == 1);
}

void AnyProgram::draw() {
  static thread_local CountingDrawer drawer;
  world.setDebugDrawer(&drawer);
  const long before = drawer.lines;
  world.debugDrawWorld();
  if (random().chance(0.8F)) world.setDebugDrawer(nullptr);
  heard = 31 * heard + static_cast<std::uint64_t>(drawer.lines - before);
}

void AnyProgram::save() {
  btDefaultSerializer serializer;
  world.serialize(&serializer);
  EXPECT_GT(serializer.getCurrentBufferSize(), 0);
}

void AnyProgram::sweep() {
  const btBoxShape box(btVector3(0.2F, 0.3F, 0.4F));
  const btTransform from(random().rotation(), random().inCube(6));
  const btTransform to(random().rotation(), random().inCube(6));
  btCollisionWorld::ClosestConvexResultCallback found(from.getOrigin(), to.getOrigin());
  world.convexSweepTest(&box, from, to, found);
  heard = 31 * heard + (found.hasHit() ? 1 : 0);
}

void AnyProgram::changeDispatch() {
  btDispatcherInfo& info = world.getDispatchInfo();
  info.m_useContinuous = random().chance(0.7F);
  info.m_allowedCcdPenetration = random().between(0, 0.1F);
  info.m_deterministicOverlappingPairs = random().chance(0.3F);
  // What is put elsewhere while it does not move has its old bounds then, in worlds that saw it move.
  if (isUnverified_) world.setForceUpdateAllAabbs(random().chance(0.5F));
  world.setApplySpeculativeContactRestitution(random().chance(0.3F));
  world.setLatencyMotionStateInterpolation(random().chance(0.5F));
  world.setSynchronizeAllMotionStates(random().chance(0.3F));
  if (isUnverified_) broadphase.m_deferedcollide = random().chance(0.3F);
  solver.reset();
}

// Meshes that move have an algorithm of Bullet's own, which the verification's world does not have.
void AnyProgram::addMesh() {
  if (!isUnverified_ || bodies.size() >= kMostBodies) return;
  btGImpactCollisionAlgorithm::registerAlgorithm(&dispatcher);
  auto mesh = std::make_unique<btTriangleMesh>();
  const btVector3 corners[4]{{0, 0.5F, 0}, {0.5F, -0.3F, 0}, {-0.4F, -0.3F, 0.4F}, {-0.4F, -0.3F, -0.4F}};
  for (int i = 0; i < 4; ++i) mesh->addTriangle(corners[i], corners[(i + 1) % 4], corners[(i + 2) % 4]);
  auto* form = shapes_.make<btGImpactMeshShape>(mesh.get());
  form->updateBound();
  meshes.push_back(std::move(mesh));
  add(random().between(0.5F, 3), form, random().inCube(3));
}

}  // namespace scatter::test
