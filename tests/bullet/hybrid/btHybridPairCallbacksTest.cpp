#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "PairTestWorld.h"

// What a program hears of contacts while pairs change their levels.

namespace scatter::test {
namespace {

/// Sets Bullet's global callbacks for as long as it lives, and counts what they are told.
class Ears {
 public:
  Ears() {
    heard_ = this;
    gContactAddedCallback = added;
    gContactDestroyedCallback = destroyed;
    gContactStartedCallback = started;
    gContactEndedCallback = ended;
  }
  ~Ears() {
    gContactAddedCallback = nullptr;
    gContactDestroyedCallback = nullptr;
    gContactStartedCallback = nullptr;
    gContactEndedCallback = nullptr;
    heard_ = nullptr;
  }
  Ears(const Ears&) = delete;
  Ears& operator=(const Ears&) = delete;

  /// A contact that was found: the children, and the shapes that the callback was shown.
  struct Found {
    const btCollisionObject* objects[2];
    const btCollisionShape* shapes[2];
    int children[2];
  };

  std::vector<Found> found;
  std::map<std::size_t, int> alive;  ///< Points with user data, and how many times they were given back.
  int doubles = 0;                   ///< Given back more than once, or never given out.
  int starts = 0;
  int ends = 0;

 private:
  static bool added(btManifoldPoint& point, const btCollisionObjectWrapper* wrap0, int, int index0,
                    const btCollisionObjectWrapper* wrap1, int, int index1) {
    heard_->found.push_back({{wrap0->getCollisionObject(), wrap1->getCollisionObject()},
                             {wrap0->getCollisionShape(), wrap1->getCollisionShape()},
                             {index0, index1}});
    if (point.m_userPersistentData) return false;
    const std::size_t number = ++heard_->last_;
    heard_->alive[number] = 0;
    point.m_userPersistentData = reinterpret_cast<void*>(number);
    return false;
  }
  static bool destroyed(void* data) {
    const auto number = reinterpret_cast<std::size_t>(data);
    heard_->doubles += heard_->alive.erase(number) == 0 ? 1 : 0;
    return false;
  }
  static void started(btPersistentManifold* const&) { ++heard_->starts; }
  static void ended(btPersistentManifold* const&) { ++heard_->ends; }

  static inline Ears* heard_ = nullptr;
  std::size_t last_ = 0;
};

void listen(PairTestWorld& w) {
  for (auto& body : w.bodies) {
    body->setCollisionFlags(body->getCollisionFlags() | btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
  }
}

TEST(PairCallbacks, NameTheChildrenOfTheLevelInUse) {
  for (int level = 1; level <= 3; ++level) {
    PairTestWorld w;
    w.world.setGravity(btVector3(0, -10, 0));
    // So small that it is no ground, on which the coarsest level is not used.
    btRigidBody* floor = w.add(0, w.shape<btBoxShape>(btVector3(1.5F, 1, 1.5F)), {0, -1, 0});
    btHybridRigidBody* falling = w.addBlock({0, 1.0F, 0}, 1, level);
    listen(w);
    Ears ears;
    w.steps(60);
    ASSERT_FALSE(ears.found.empty()) << "level " << level;
    ASSERT_EQ(w.levelOf(floor, falling), level);
    for (const Ears::Found& found : ears.found) {
      const int side = found.objects[0] == falling ? 0 : 1;
      ASSERT_EQ(found.objects[side], falling);
      const btCollisionShape* shape = w.block.getLevelShape(level);
      if (shape->isCompound()) {
        const auto* compound = static_cast<const btCompoundShape*>(shape);
        ASSERT_GE(found.children[side], 0);
        ASSERT_LT(found.children[side], compound->getNumChildShapes());
        EXPECT_EQ(found.shapes[side], compound->getChildShape(found.children[side]));
      } else {
        EXPECT_EQ(found.shapes[side], shape);
        EXPECT_EQ(found.children[side], -1);
      }
    }
  }
}

/// Blocks and ships on a heap, asked for other levels all the time.
class Restless : public PairTestWorld {
 public:
  Restless() {
    world.setGravity(btVector3(0, -10, 0));
    addFloor();
    for (int i = 0; i < 8; ++i) {
      const float along = static_cast<float>(i);
      const btTransform pose(btQuaternion(btVector3(1, along, 2).normalized(), along),
                             btVector3(0.3F * static_cast<float>(i % 3), 1 + 1.3F * along, 0));
      addBody(i % 2 == 0 ? block : ship, pose);
    }
    listen(*this);
  }

  void run(int count) {
    for (int i = 0; i < count; ++i) {
      if (i % 7 == 0) {
        world.requestLevel(world.getHybrid(random.index(world.getNumHybrids())), 1 + random.index(3));
      }
      step();
      creditSwitches += pairInfo().creditSwitches;
      audits += pairInfo().audits;
    }
  }

  Random random{8};
  int creditSwitches = 0;
  int audits = 0;
};

TEST(PairCallbacks, EveryPointWithUserDataIsGivenBackOnce) {
  Ears ears;
  {
    Restless w;
    w.run(600);
    EXPECT_GT(w.creditSwitches, 10);
    EXPECT_GT(w.audits, 10);
    EXPECT_EQ(ears.doubles, 0);
    // What was given out and not back is in a manifold.
    std::size_t held = 0;
    for (int i = 0; i < w.dispatcher.getNumManifolds(); ++i) {
      const btPersistentManifold& manifold = w.manifoldAt(i);
      for (int k = 0; k < manifold.getNumContacts(); ++k) {
        held += manifold.getContactPoint(k).m_userPersistentData ? 1U : 0U;
      }
    }
    EXPECT_EQ(held, ears.alive.size());
  }
  EXPECT_EQ(ears.doubles, 0);
  EXPECT_TRUE(ears.alive.empty()) << ears.alive.size() << " never given back";
}

TEST(PairCallbacks, EveryManifoldThatStartsAlsoEnds) {
  Ears ears;
  {
    Restless w;
    w.run(600);
  }
  EXPECT_GT(ears.starts, 100);
  EXPECT_EQ(ears.starts, ears.ends);
}

}  // namespace
}  // namespace scatter::test
