#include "worlds.h"

#include <BulletHybrid/btHybridDynamicsWorld.h>
#include <BulletHybrid/btHybridInstallation.h>
#include <btBulletDynamicsCommon.h>

#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <algorithm>
#include <ctime>
#include <map>
#include <utility>

namespace scatter::bench {

namespace {

double processorMs() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

/// A world that knows how long its detection of collisions takes.
template <class World>
class Timed : public World {
 public:
  using World::World;
  void performDiscreteCollisionDetection() override {
    const double begin = processorMs();
    World::performDiscreteCollisionDetection();
    detection += processorMs() - begin;
  }
  double detection = 0.0;
};

/// A body, by its number in the world, and the child of its compound.
using PartKey = std::pair<int, int>;

struct PartContact {
  int points = 0;
  float least = 1e9F;
};

using PartContacts = std::map<PartKey, PartContact>;

template <class World, class Solver>
class Stage {
 public:
  template <class... More>
  explicit Stage(const Trial& trial, WorldKind kind, More... more)
      : trial_(trial),
        random_(trial.seed),
        ground_(trial.ground, trial.relief, random_),
        dispatcher_(&configuration_),
        world_(&dispatcher_, &broadphase_, &solver_, &configuration_, more...) {
    if (kind == WorldKind::kInstalled || kind == WorldKind::kMultiBodyInstalled) {
      installation_ = std::make_unique<btHybridInstallation>(&dispatcher_);
    }
    world_.setGravity(btVector3(0, btScalar(-9.81), 0));
    // Worlds of multi-bodies set it, others do not.
    if (trial.oneFriction) world_.getSolverInfo().m_solverMode &= ~SOLVER_USE_2_FRICTION_DIRECTIONS;
    addGround();
    for (int i = 0; i < 4; ++i) models_.push_back(std::make_unique<Model>(trial.body, random_));
    for (int i = 0; i < trial.bodies; ++i) addBody(i, kind == WorldKind::kHybrid && !isBare(trial.body));
  }

  ~Stage() {
    for (auto& body : bodies_) world_.removeRigidBody(body.get());
  }

  Cost run() {
    Cost cost;
    std::vector<double> steps;
    for (int i = 0; i < trial_.steps; ++i) {
      const double begin = processorMs();
      world_.stepSimulation(btScalar(1) / 60, 0);
      steps.push_back(processorMs() - begin);
      cost.total += steps.back();
      for (const auto& body : bodies_) cost.bodySteps += body->isActive() && !body->isStaticObject() ? 1 : 0;
      for (int k = 0; k < dispatcher_.getNumManifolds(); ++k) {
        cost.contacts += dispatcher_.getManifoldByIndexInternal(k)->getNumContacts();
      }
    }
    std::sort(steps.begin(), steps.end());
    cost.p99 = steps[steps.size() * 99 / 100];
    cost.detection = world_.detection;
    cost.contacts /= trial_.steps;
    if (installation_) {
      const auto counts = installation_->takeCollisionCounts();
      cost.asked = counts.detectorRuns + counts.halfSpaceRuns;
    }
    look(cost);
    return cost;
  }

  [[nodiscard]] std::vector<btTransform> poses() const {
    std::vector<btTransform> result;
    for (const auto& body : bodies_) result.push_back(body->getWorldTransform());
    return result;
  }

  /// Of every part that is in contact with the ground: body and child.
  PartContacts detect(const std::vector<btTransform>& poses) {
    for (std::size_t i = 0; i < poses.size(); ++i) bodies_[i]->setWorldTransform(poses[i]);
    world_.performDiscreteCollisionDetection();
    PartContacts contacts;
    for (int k = 0; k < dispatcher_.getNumManifolds(); ++k) {
      const btPersistentManifold* manifold = dispatcher_.getManifoldByIndexInternal(k);
      if (manifold->getNumContacts() > 0) add(manifold, contacts);
    }
    return contacts;
  }

  /// How far the lowest point of a part is over flat ground.
  [[nodiscard]] float height(const PartKey& key) const {
    const btRigidBody& body = *bodies_[static_cast<std::size_t>(key.first)];
    const btCollisionShape* shape = body.getCollisionShape();
    btTransform pose = body.getWorldTransform();
    if (shape->isCompound()) {
      const auto* compound = static_cast<const btCompoundShape*>(shape);
      shape = compound->getChildShape(key.second);
      pose = pose * compound->getChildTransform(key.second);
    }
    const auto* part = static_cast<const btConvexShape*>(shape);
    return pose(part->localGetSupportingVertex(btVector3(0, -1, 0) * pose.getBasis())).y();
  }

 private:
  void add(const btPersistentManifold* manifold, PartContacts& contacts) const {
    const btCollisionObject* ground = bodies_[0].get();
    const int side = manifold->getBody1() == ground ? 0 : 1;
    if (manifold->getBody0() != ground && manifold->getBody1() != ground) return;
    const btCollisionObject* body = side == 0 ? manifold->getBody0() : manifold->getBody1();
    const btManifoldPoint& first = manifold->getContactPoint(0);
    PartContact& contact =
        contacts[{body->getWorldArrayIndex(), side == 0 ? first.m_index0 : first.m_index1}];
    for (int i = 0; i < manifold->getNumContacts(); ++i) {
      ++contact.points;
      contact.least = std::min(contact.least, manifold->getContactPoint(i).getDistance());
    }
  }

  void addGround() {
    auto body = std::make_unique<btRigidBody>(btScalar(0), nullptr, ground_.shape());
    btTransform pose(btQuaternion::getIdentity(), ground_.position());
    body->setWorldTransform(pose);
    world_.addRigidBody(body.get());
    bodies_.push_back(std::move(body));
  }

  // Layers of a grid, so high that none touches another one or the ground.
  void addBody(int number, bool isHybrid) {
    Model& model = *models_[static_cast<std::size_t>(number) % models_.size()];
    const int side = std::max(1, static_cast<int>(std::sqrt(static_cast<float>(trial_.bodies) / 2)));
    const float spacing = 2.4F * model.radius();
    const int layer = number / (side * side);
    const int x = number % side;
    const int z = number / side % side;
    const btVector3 place(spacing * (static_cast<float>(x) - static_cast<float>(side) / 2),
                          ground_.highest() + model.radius() + 0.5F + spacing * static_cast<float>(layer),
                          spacing * (static_cast<float>(z) - static_cast<float>(side) / 2));
    const float mass = 10.0F;
    btVector3 inertia;
    model.finest()->calculateLocalInertia(mass, inertia);
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, model.finest(), inertia);
    const bool isFlat = trial_.body == BodyKind::kWheel && number % 2 == 0;
    info.m_startWorldTransform.setOrigin(place + random_.inCube(0.1F));
    info.m_startWorldTransform.setRotation(isFlat ? btQuaternion::getIdentity() : random_.rotation());
    bodies_.push_back(isHybrid ? std::make_unique<btHybridRigidBody>(info, &model.levels())
                               : std::make_unique<btRigidBody>(info));
    if (trial_.body == BodyKind::kPlate)
      bodies_.back()->setLinearVelocity(btVector3(0, -random_.in(5.0F, 40.0F), 0));
    world_.addRigidBody(bodies_.back().get());
  }

  void look(Cost& cost) {
    for (int k = 0; k < dispatcher_.getNumManifolds(); ++k) {
      const btPersistentManifold* manifold = dispatcher_.getManifoldByIndexInternal(k);
      for (int i = 0; i < manifold->getNumContacts(); ++i) {
        cost.deepest = std::max(cost.deepest, -manifold->getContactPoint(i).getDistance());
      }
    }
    for (std::size_t i = 1; i < bodies_.size(); ++i) {
      const btVector3 middle = bodies_[i]->getWorldTransform().getOrigin();
      const btVector3 above(middle.x(), 100, middle.z());
      const btVector3 below(middle.x(), -100, middle.z());
      btCollisionWorld::ClosestRayResultCallback hit(above, below);
      btTransform from(btQuaternion::getIdentity(), above);
      btTransform to(btQuaternion::getIdentity(), below);
      btCollisionWorld::rayTestSingle(from, to, bodies_[0].get(), ground_.shape(),
                                      bodies_[0]->getWorldTransform(), hit);
      const bool isOver = hit.hasHit() && hit.m_hitPointWorld.y() < middle.y();
      const bool isBeside =
          std::abs(middle.x()) > Ground::kWidth / 2 || std::abs(middle.z()) > Ground::kWidth / 2;
      cost.sunk += !isOver && !isBeside ? 1 : 0;
    }
  }

  Trial trial_;
  Random random_;
  Ground ground_;
  std::vector<std::unique_ptr<Model>> models_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  Solver solver_;
  std::unique_ptr<btHybridInstallation> installation_;
  Timed<World> world_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

}  // namespace

Cost run(const Trial& trial, WorldKind kind) {
  if (kind == WorldKind::kHybrid) {
    return Stage<btHybridDynamicsWorld, btSequentialImpulseConstraintSolver>(trial, kind,
                                                                             BT_HYBRID_PAIR_SWITCHING)
        .run();
  }
  if (kind == WorldKind::kMultiBody || kind == WorldKind::kMultiBodyInstalled) {
    return Stage<btMultiBodyDynamicsWorld, btMultiBodyConstraintSolver>(trial, kind).run();
  }
  return Stage<btDiscreteDynamicsWorld, btSequentialImpulseConstraintSolver>(trial, kind).run();
}

Contacts compareContacts(const Trial& trial) {
  using PlainStage = Stage<btDiscreteDynamicsWorld, btSequentialImpulseConstraintSolver>;
  PlainStage moved(trial, WorldKind::kInstalled);
  const Cost cost = moved.run();
  const std::vector<btTransform> poses = moved.poses();
  PlainStage bullet(trial, WorldKind::kPlain);
  PlainStage installed(trial, WorldKind::kInstalled);
  const PartContacts theirs = bullet.detect(poses);
  const PartContacts ours = installed.detect(poses);
  const bool isFlat = trial.ground != GroundKind::kMesh && trial.ground != GroundKind::kHeightField;
  Contacts result;
  result.sunk = cost.sunk;
  std::vector<double> differences;
  for (const auto& [key, own] : ours) {
    ++result.parts;
    if (isFlat) {
      result.trueDepth =
          std::max(result.trueDepth, 1e3 * std::abs(static_cast<double>(own.least - installed.height(key))));
    }
    const auto other = theirs.find(key);
    if (other == theirs.end()) {
      ++result.extra;
      continue;
    }
    result.sameCount += own.points == other->second.points ? 1 : 0;
    differences.push_back(1e3 * static_cast<double>(own.least - other->second.least));
  }
  for (const auto& [key, other] : theirs) {
    if (ours.contains(key)) continue;
    ++result.parts;
    ++result.missed;
    result.missedDeep += other.least < -0.001F ? 1 : 0;
  }
  for (double& difference : differences) {
    result.shallower = std::max(result.shallower, difference);
    difference = std::abs(difference);
  }
  std::sort(differences.begin(), differences.end());
  if (!differences.empty()) result.depthP99 = differences[differences.size() * 99 / 100];
  return result;
}

}  // namespace scatter::bench
