#include "AnyProgram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "RandomPrograms.h"

namespace scatter::test {
namespace {

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

}  // namespace

void Callbacks::set(int which) {
  gContactAddedCallback = which == 1 ? hearAdded : nullptr;
  gContactProcessedCallback = which == 2 ? hearProcessed : nullptr;
  gContactStartedCallback = which == 3 ? hearManifold : nullptr;
  gContactEndedCallback = which == 3 ? hearManifold : nullptr;
}

AnyProgram::~AnyProgram() {
  world.setListener(nullptr);
  world.verifyContacts(0);
  world.setConstraintSolver(&solver);
  endElsewhere();
  character_.reset();
  endDriving();
  while (!bodies.empty()) destroy(bodies.size() - 1);
  if (hasSensor_) world.removeCollisionObject(&sensor_);
  EXPECT_EQ(countOrphans(), 0);
  EXPECT_EQ(broadphase.getOverlappingPairCache()->getNumOverlappingPairs(), 0);
  EXPECT_EQ(world.getCollisionMemory().m_pairs, 0);
  EXPECT_EQ(world.getNumHybrids(), 0);
}

void AnyProgram::doAnything() {
  for (int i = random().index(4); i > 0; --i) doOne();
}

void AnyProgram::stepSomehow() {
  drawTogether(bodies);
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

std::vector<std::uint32_t> AnyProgram::all() const {
  std::vector<std::uint32_t> result = bits();
  result.push_back(static_cast<std::uint32_t>(dispatcher.getNumManifolds()));
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i)
    result.push_back(static_cast<std::uint32_t>(manifoldAt(i).getNumContacts()));
  const btHybridCollisionCounts counts = world.getCollisionCounts();
  for (const int count : {counts.pairs, counts.childPairs, counts.gjkRuns, counts.detectorRuns})
    result.push_back(static_cast<std::uint32_t>(count));
  return result;
}

int AnyProgram::countOrphans() {
  if (hasCcd_) return 0;
  return PairTestWorld::countOrphans() - (character_ ? character_->countOwnManifolds() : 0);
}

bool AnyProgram::isFinite() const {
  return std::all_of(bodies.begin(), bodies.end(), [](const auto& body) {
    const btVector3& at = body->getWorldTransform().getOrigin();
    return std::isfinite(at.length()) && std::isfinite(body->getLinearVelocity().length());
  });
}

void AnyProgram::doOne() {
  using Deed = void (AnyProgram::*)();
  static constexpr Deed kDeeds[] = {&AnyProgram::addAny,
                                    &AnyProgram::removeAny,
                                    &AnyProgram::addBack,
                                    &AnyProgram::destroyAny,
                                    &AnyProgram::put,
                                    &AnyProgram::push,
                                    &AnyProgram::putToSleep,
                                    &AnyProgram::changeKind,
                                    &AnyProgram::changeShape,
                                    &AnyProgram::changeParts,
                                    &AnyProgram::ask,
                                    &AnyProgram::limit,
                                    &AnyProgram::changeRules,
                                    &AnyProgram::changeWays,
                                    &AnyProgram::tie,
                                    &AnyProgram::untie,
                                    &AnyProgram::look,
                                    &AnyProgram::cleanPairs,
                                    &AnyProgram::changeSolver,
                                    &AnyProgram::changeMode,
                                    &AnyProgram::sense,
                                    &AnyProgram::changeTouch,
                                    &AnyProgram::changeBounds,
                                    &AnyProgram::repeat,
                                    &AnyProgram::ignoreOne,
                                    &AnyProgram::filterPairs,
                                    &AnyProgram::changeGroups,
                                    &AnyProgram::moveByState,
                                    &AnyProgram::walk,
                                    &AnyProgram::drive,
                                    &AnyProgram::workInSteps,
                                    &AnyProgram::draw,
                                    &AnyProgram::save,
                                    &AnyProgram::sweep,
                                    &AnyProgram::changeDispatch,
                                    &AnyProgram::addMesh,
                                    &AnyProgram::passOnSome,
                                    &AnyProgram::changeBody,
                                    &AnyProgram::emigrate,
                                    &AnyProgram::endElsewhere};
  (this->*kDeeds[random().index(static_cast<int>(std::size(kDeeds)))])();
}

void AnyProgram::addAny() {
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

btCollisionShape* AnyProgram::anyShape() {
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

void AnyProgram::untieFrom(const btRigidBody& body) {
  for (std::size_t i = joints.size(); i-- > 0;) {
    if (&joints[i]->getRigidBodyA() != &body && &joints[i]->getRigidBodyB() != &body) continue;
    world.removeConstraint(joints[i].get());
    joints.erase(joints.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

void AnyProgram::removeAny() {
  if (bodies.empty()) return;
  btRigidBody& body = any();
  untieFrom(body);
  remove(body);
}

void AnyProgram::remove(btRigidBody& body) {
  if (vehicle_ && vehicle_->getRigidBody() == &body) endDriving();
  if (isElsewhere(body)) {
    elsewhere_->world->removeRigidBody(&body);
    gone_.erase(std::find(gone_.begin(), gone_.end(), &body));
  } else if (isInWorld(body)) {
    world.removeRigidBody(&body);
  }
}

void AnyProgram::addBack() {
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

void AnyProgram::destroy(std::size_t index) {
  untieFrom(*bodies[index]);
  forget(*bodies[index]);
  remove(*bodies[index]);
  bodies.erase(bodies.begin() + static_cast<std::ptrdiff_t>(index));
}

void AnyProgram::destroyAny() {
  if (bodies.size() > 8) destroy(static_cast<std::size_t>(random().index(static_cast<int>(bodies.size()))));
}

void AnyProgram::put() {
  if (bodies.empty()) return;
  btRigidBody& body = any();
  const btVector3 place = random().inCube(random().chance(0.1F) ? 1e4F : 3.0F);
  body.setWorldTransform(btTransform(random().rotation(), place));
  if (random().chance(0.5F)) body.setInterpolationWorldTransform(body.getWorldTransform());
  if (random().chance(0.3F) && isInWorld(body)) world.updateSingleAabb(&body);
  body.activate();
}

void AnyProgram::push() {
  if (bodies.empty()) return;
  btRigidBody& body = any();
  if (body.isStaticObject()) return;
  body.setLinearVelocity(random().inCube(random().chance(0.1F) ? 300.0F : 5.0F));
  body.setAngularVelocity(random().inCube(random().chance(0.1F) ? 40.0F : 3.0F));
  body.activate();
}

void AnyProgram::putToSleep() {
  if (bodies.empty()) return;
  static constexpr int kStates[] = {ACTIVE_TAG, ISLAND_SLEEPING, WANTS_DEACTIVATION, DISABLE_DEACTIVATION,
                                    DISABLE_SIMULATION};
  any().forceActivationState(kStates[random().index(5)]);
}

// Bodies with mass become kinematic and back, or let others through.
void AnyProgram::changeKind() {
  if (bodies.empty()) return;
  btRigidBody& body = any();
  if (body.getInvMass() == 0) return;
  const int flag = random().chance(0.5F) ? btCollisionObject::CF_KINEMATIC_OBJECT
                                         : btCollisionObject::CF_NO_CONTACT_RESPONSE;
  body.setCollisionFlags(body.getCollisionFlags() ^ flag);
  body.forceActivationState(ACTIVE_TAG);
}

void AnyProgram::changeShape() {
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

void AnyProgram::changeParts() {
  if (bodies.empty()) return;
  btRigidBody& body = any();
  if (btHybridRigidBody::upcast(&body) != nullptr || !body.getCollisionShape()->isCompound()) return;
  auto* parts = static_cast<btCompoundShape*>(body.getCollisionShape());
  if (parts->getNumChildShapes() > 1 && random().chance(0.5F)) {
    parts->removeChildShapeByIndex(random().index(parts->getNumChildShapes()));
  } else if (parts->getNumChildShapes() > 0 && random().chance(0.3F)) {
    parts->updateChildTransform(random().index(parts->getNumChildShapes()), random().pose(0.4F));
  } else {
    btCollisionShape* part = shapes_.convex(0.5F);
    if (random().chance(0.2F)) part = shapes_.compound(2, 0.5F);
    parts->addChildShape(random().pose(0.3F), part);
  }
}

void AnyProgram::changeBody() {
  if (bodies.empty()) return;
  btRigidBody& body = any();
  body.setLinearFactor(random().chance(0.8F) ? btVector3(1, 1, 1) : btVector3(1, 0, 1));
  body.setAngularFactor(random().chance(0.8F) ? btVector3(1, 1, 1) : btVector3(0, 1, 0));
  body.setDamping(random().between(0, 1), random().between(0, 1));
  body.setSleepingThresholds(random().between(0, 3), random().between(0, 3));
  body.setGravity(random().inCube(3));
  body.setDeactivationTime(random().between(0, 3));
}

void AnyProgram::changeBounds() {
  if (bodies.empty()) return;
  btRigidBody& body = any();
  if (btHybridRigidBody::upcast(&body) == nullptr && body.getCollisionShape()->isConvex())
    body.getCollisionShape()->setMargin(random().between(0, 0.05F));
}

void AnyProgram::changeTouch() {
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

void AnyProgram::tie() {
  if (bodies.size() < 2) return;
  btRigidBody& a = any();
  btRigidBody& b = any();
  if (&a == &b || !isInWorld(a) || !isInWorld(b)) return;
  joints.push_back(anyJoint(a, b));
  if (random().chance(0.2F)) joints.back()->setBreakingImpulseThreshold(random().between(0, 5));
  if (random().chance(0.1F)) joints.back()->setEnabled(false);
  world.addConstraint(joints.back().get(), random().chance(0.5F));
}

std::unique_ptr<btTypedConstraint> AnyProgram::anyJoint(btRigidBody& a, btRigidBody& b) {
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

void AnyProgram::untie() {
  if (joints.empty()) return;
  world.removeConstraint(joints.back().get());
  joints.pop_back();
}

}  // namespace scatter::test
