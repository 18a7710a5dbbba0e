#include <BulletHybrid/btHybridInstallation.h>
#include <gtest/gtest.h>

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <BulletSoftBody/btSoftBodyHelpers.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftMultiBodyDynamicsWorld.h>
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "BulletTestWorld.h"
#include "RandomGrounds.h"
#include "RandomPrograms.h"
#include "TestCharacter.h"

// A program with the pair algorithm in a world of multi-bodies and soft bodies does between two steps
// whatever it may.

namespace scatter::test {
namespace {

using SoftMultiBodyWorld = BulletTestWorld<btSoftMultiBodyDynamicsWorld, btMultiBodyConstraintSolver,
                                           btSoftBodyRigidBodyCollisionConfiguration>;

/// Five links in a row, each of many parts.
class Chain {
 public:
  Chain(btMultiBodyDynamicsWorld& world, RandomShapes& shapes) : world_(world) {
    body_ = std::make_unique<btMultiBody>(kLinks, 1.0F, btVector3(1, 1, 1), false, false);
    body_->setBasePos(shapes.random.inCube(2));
    for (int i = 0; i < kLinks; ++i) {
      body_->setupSpherical(i, 1.0F, btVector3(1, 1, 1), i - 1, btQuaternion::getIdentity(),
                            btVector3(0.6F, 0, 0), btVector3(0.6F, 0, 0), true);
    }
    body_->finalizeMultiDof();
    world_.addMultiBody(body_.get());
    for (int link = -1; link < kLinks; ++link) addCollider(link, shapes.compound(4, 0.8F));
  }
  Chain(const Chain&) = delete;
  Chain& operator=(const Chain&) = delete;
  ~Chain() {
    for (auto& collider : colliders_) world_.removeCollisionObject(collider.get());
    world_.removeMultiBody(body_.get());
  }

  [[nodiscard]] bool isFinite() const { return std::isfinite(body_->getBasePos().length()); }
  void push(const btVector3& velocity) { body_->setBaseVel(velocity); }

 private:
  static constexpr int kLinks = 5;

  void addCollider(int link, btCollisionShape* shape) {
    colliders_.push_back(std::make_unique<btMultiBodyLinkCollider>(body_.get(), link));
    btMultiBodyLinkCollider* collider = colliders_.back().get();
    collider->setCollisionShape(shape);
    world_.addCollisionObject(collider, 1, -1);
    if (link < 0) {
      body_->setBaseCollider(collider);
    } else {
      body_->getLink(link).m_collider = collider;
    }
  }

  btMultiBodyDynamicsWorld& world_;
  std::unique_ptr<btMultiBody> body_;
  std::vector<std::unique_ptr<btMultiBodyLinkCollider>> colliders_;
};

/// A cloth, a balloon or a rope, which collides as a whole or in clusters.
class Soft {
 public:
  Soft(btSoftMultiBodyDynamicsWorld& world, Random& random) : world_(world), body_(make(world, random)) {
    if (random.chance(0.3F)) {
      body_->generateClusters(4);
      body_->m_cfg.collisions = btSoftBody::fCollision::CL_RS | btSoftBody::fCollision::CL_SS;
    } else {
      body_->m_cfg.collisions |= btSoftBody::fCollision::VF_SS;
    }
    body_->setTotalMass(random.between(0.1F, 3), true);
    world_.addSoftBody(body_.get());
  }
  Soft(const Soft&) = delete;
  Soft& operator=(const Soft&) = delete;
  ~Soft() { world_.removeSoftBody(body_.get()); }

  void push(const btVector3& velocity) { body_->setVelocity(velocity); }

  /// Not where places overflow Bullet's hash of distances.
  [[nodiscard]] bool isNear() const {
    const btAlignedObjectArray<btSoftBody::Node>& nodes = body_->m_nodes;
    for (int i = 0; i < nodes.size(); ++i) {
      if (!(nodes[i].m_x.length() < 1000)) return false;
    }
    return true;
  }

 private:
  static btSoftBody* make(btSoftMultiBodyDynamicsWorld& world, Random& random) {
    btSoftBodyWorldInfo& info = world.getWorldInfo();
    const btVector3 at = random.inCube(2);
    switch (random.index(3)) {
      case 0:
        return btSoftBodyHelpers::CreatePatch(info, at, at + btVector3(2, 0, 0), at + btVector3(0, 0, 2),
                                              at + btVector3(2, 0, 2), 8, 8, random.index(16), true);
      case 1:
        return btSoftBodyHelpers::CreateEllipsoid(info, at, btVector3(0.8F, 0.5F, 0.6F), 40);
      default:
        return btSoftBodyHelpers::CreateRope(info, at, at + btVector3(0, 2, 1), 8, random.index(4));
    }
  }

  btSoftMultiBodyDynamicsWorld& world_;
  std::unique_ptr<btSoftBody> body_;
};

class AnyInstalled : public SoftMultiBodyWorld {
 public:
  explicit AnyInstalled(std::uint64_t number)
      : shapes_(number), grounds_(shapes_), hasSoft_(number % 2 == 0) {
    installation_ = std::make_unique<btHybridInstallation>(&dispatcher);
    for (int i = 0; i < 10; ++i) addAny();
    chains_.push_back(std::make_unique<Chain>(world, shapes_));
    if (hasSoft_) softs_.push_back(std::make_unique<Soft>(world, random()));
  }

  ~AnyInstalled() {
    chains_.clear();
    softs_.clear();
    character_.reset();
    while (!bodies.empty()) destroy(bodies.size() - 1);
    EXPECT_EQ(countOrphans(), 0);
    EXPECT_EQ(dispatcher.getNumManifolds(), 0);
    if (installation_) {
      EXPECT_EQ(installation_->getCollisionMemory().m_pairs, 0);
    }
  }

  void doAnything() {
    using Deed = void (AnyInstalled::*)();
    static constexpr Deed kDeeds[] = {
        &AnyInstalled::addAny,      &AnyInstalled::destroyAny,  &AnyInstalled::put,
        &AnyInstalled::changeShape, &AnyInstalled::changeParts, &AnyInstalled::look,
        &AnyInstalled::changeWays,  &AnyInstalled::reinstall,   &AnyInstalled::chain,
        &AnyInstalled::putToSleep,  &AnyInstalled::walk,        &AnyInstalled::soften};
    for (int i = random().index(4); i > 0; --i)
      (this->*kDeeds[random().index(static_cast<int>(std::size(kDeeds)))])();
  }

  void stepOn() {
    drawTogether(bodies);
    step();
  }

  /// Bullet's soft bodies leave for infinity in a tenth of these programs, with its own algorithms, too, and
  /// take others with them.
  [[nodiscard]] bool hasBurst() const {
    return hasSoft_ && (!isFinite() || !std::all_of(softs_.begin(), softs_.end(),
                                                    [](const auto& soft) { return soft->isNear(); }));
  }

  [[nodiscard]] int countOrphans() {
    return SoftMultiBodyWorld::countOrphans() - (character_ ? character_->countOwnManifolds() : 0);
  }

  [[nodiscard]] bool isFinite() const {
    return std::all_of(bodies.begin(), bodies.end(),
                       [](const auto& body) {
                         return std::isfinite(body->getWorldTransform().getOrigin().length());
                       }) &&
           std::all_of(chains_.begin(), chains_.end(), [](const auto& chain) { return chain->isFinite(); });
  }

 private:
  [[nodiscard]] Random& random() { return shapes_.random; }
  [[nodiscard]] btRigidBody& any() {
    return *bodies[static_cast<std::size_t>(random().index(static_cast<int>(bodies.size())))];
  }

  void addAny() {
    if (bodies.size() > 25) return;
    if (random().chance(0.2F)) {
      const GroundType type = kGrounds[random().index(static_cast<int>(std::size(kGrounds)))];
      add(0, grounds_.make(type, random().between(0.3F, 1.5F)), random().inCube(2) - btVector3(0, 3, 0));
    } else {
      add(random().between(0.1F, 10), anyShape(), random().inCube(3));
    }
  }

  btCollisionShape* anyShape() {
    const float size = random().between(0.3F, 2.0F);
    if (random().chance(0.3F)) return shapes_.convex(size);
    return shapes_.compound(1 + random().index(8), size, 0.1F);
  }

  void destroy(std::size_t index) {
    world.removeRigidBody(bodies[index].get());
    bodies.erase(bodies.begin() + static_cast<std::ptrdiff_t>(index));
  }

  void destroyAny() {
    if (bodies.size() > 5) destroy(static_cast<std::size_t>(random().index(static_cast<int>(bodies.size()))));
  }

  void put() {
    any().setWorldTransform(btTransform(random().rotation(), random().inCube(3)));
    any().activate();
  }

  void putToSleep() { any().forceActivationState(random().chance(0.5F) ? ISLAND_SLEEPING : ACTIVE_TAG); }

  void clean(const btRigidBody& body) {
    broadphase.getOverlappingPairCache()->cleanProxyFromPairs(
        const_cast<btBroadphaseProxy*>(body.getBroadphaseHandle()), &dispatcher);
    if (character_) character_->cleanPairs(body);
  }

  void changeShape() {
    btRigidBody& body = any();
    if (random().chance(0.5F) || body.getInvMass() == 0) {
      body.getCollisionShape()->setLocalScaling(btVector3(1, 1, 1) * random().between(0.5F, 1.5F));
    } else {
      body.setCollisionShape(anyShape());
      clean(body);
    }
  }

  void changeParts() {
    btRigidBody& body = any();
    if (!body.getCollisionShape()->isCompound()) return;
    auto* parts = static_cast<btCompoundShape*>(body.getCollisionShape());
    if (parts->getNumChildShapes() > 1 && random().chance(0.5F)) {
      parts->removeChildShapeByIndex(random().index(parts->getNumChildShapes()));
    } else {
      parts->addChildShape(random().pose(0.3F), shapes_.convex(0.5F));
    }
  }

  void look() {
    struct Heard : btCollisionWorld::ContactResultCallback {
      btScalar addSingleResult(btManifoldPoint&, const btCollisionObjectWrapper*, int, int,
                               const btCollisionObjectWrapper*, int, int) override {
        return 0;
      }
    } found;
    btRigidBody& a = any();
    btRigidBody& b = any();
    world.contactTest(&a, found);
    if (&a != &b) world.contactPairTest(&a, &b, found);
    world.performDiscreteCollisionDetection();
  }

  void changeWays() {
    if (!installation_) return;
    btHybridCollisionInfo ways = installation_->getCollisionInfo();
    ways.m_pairAlgorithm = random().chance(0.8F);
    ways.m_steps.midphase = static_cast<PairMidphase>(random().index(3));
    ways.m_steps.recycling = random().chance(0.5F) ? 0.0F : random().between(0, 0.01F);
    ways.m_steps.passages = random().chance(0.7F);
    ways.m_steps.lazyManifolds = random().chance(0.8F);
    installation_->setCollisionInfo(ways);
  }

  // Pairs that use the algorithm keep it.
  void reinstall() {
    if (installation_) {
      installation_.reset();
    } else {
      installation_ = std::make_unique<btHybridInstallation>(&dispatcher);
      EXPECT_EQ(installation_->getMistake(), nullptr);
    }
  }

  void walk() { letWalk(character_, world, random()); }

  void chain() {
    if (chains_.size() > 2 || (!chains_.empty() && random().chance(0.3F))) {
      chains_.pop_back();
    } else if (random().chance(0.5F)) {
      chains_.push_back(std::make_unique<Chain>(world, shapes_));
    } else if (!chains_.empty()) {
      chains_.back()->push(random().inCube(5));
    }
  }

  void soften() {
    if (!hasSoft_) return;
    if (softs_.size() > 2 || (!softs_.empty() && random().chance(0.3F))) {
      softs_.erase(softs_.begin() + random().index(static_cast<int>(softs_.size())));
    } else if (random().chance(0.5F)) {
      softs_.push_back(std::make_unique<Soft>(world, random()));
    } else if (!softs_.empty()) {
      softs_.back()->push(random().inCube(5));
    }
  }

  RandomShapes shapes_;
  RandomGrounds grounds_;
  bool hasSoft_;
  std::unique_ptr<btHybridInstallation> installation_;
  std::vector<std::unique_ptr<Chain>> chains_;
  std::vector<std::unique_ptr<Soft>> softs_;
  std::unique_ptr<TestCharacter> character_;
};

TEST(RandomInstallation, BreaksNothing) {
  for (const std::uint64_t number : programs(80)) {
    SCOPED_TRACE("program " + std::to_string(number));
    AnyInstalled program(number);
    for (int step = 0; step < 120; ++step) {
      program.doAnything();
      program.stepOn();
      if (program.hasBurst()) break;
      ASSERT_TRUE(program.isFinite()) << "step " << step;
      ASSERT_EQ(program.countOrphans(), 0) << "step " << step;
    }
  }
}

}  // namespace
}  // namespace scatter::test
