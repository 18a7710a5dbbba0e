#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>
#include <vector>

#include "RandomShapes.h"
#include "ScriptedWorld.h"

// What a program hears and asks of a world with hybrids must not depend on who finds the contacts.

namespace scatter::test {
namespace {

struct AddedContact {
  const btCollisionObject* bodies[2];
  const btCollisionShape* shapes[2];
  std::array<int, 2> parts;
  std::array<int, 2> children;
  std::array<int, 2> wrapperChildren;
  btVector3 childOrigins[2];
};

std::vector<AddedContact>* heard = nullptr;

bool hear(btManifoldPoint& point, const btCollisionObjectWrapper* wrap0, int part0, int index0,
          const btCollisionObjectWrapper* wrap1, int part1, int index1) {
  heard->push_back({{wrap0->getCollisionObject(), wrap1->getCollisionObject()},
                    {wrap0->getCollisionShape(), wrap1->getCollisionShape()},
                    {part0, part1},
                    {index0, index1},
                    {wrap0->m_index, wrap1->m_index},
                    {wrap0->getWorldTransform().getOrigin(), wrap1->getWorldTransform().getOrigin()}});
  EXPECT_EQ(point.m_index0, index0);
  EXPECT_EQ(point.m_index1, index1);
  return false;
}

/// Hybrids and a sphere, overlapping at rest; fine enough to have many child pairs in contact.
class Heap : public ScriptedWorld {
 public:
  explicit Heap(bool pairAlgorithm) : ScriptedWorld(pairAlgorithm), shapes_(21) {
    const btHybridLevelSet& levels = shapes_.oneLevel(shapes_.plainCompound(10, 1));
    for (int i = 0; i < 4; ++i) addHybrid(levels, shapes_.random.pose(0.5F));
    addOther(1, shapes_.make<btSphereShape>(0.4F), shapes_.random.pose(0.5F));
    addOther(1, shapes_.compound(3, 1), shapes_.random.pose(0.5F));
    addOther(0, shapes_.make<btStaticPlaneShape>(btVector3(0, 1, 0), -0.2F), btTransform::getIdentity());
  }

 private:
  RandomShapes shapes_;
};

using Heard = std::multiset<std::array<int, 4>>;

Heard listen(Heap& w, std::vector<AddedContact>& contacts, ContactAddedCallback callback = hear) {
  for (auto& body : w.bodies) {
    body->setCollisionFlags(body->getCollisionFlags() | btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
  }
  heard = &contacts;
  gContactAddedCallback = callback;
  w.detect();
  gContactAddedCallback = nullptr;
  heard = nullptr;
  Heard result;
  for (const AddedContact& contact : contacts) {
    result.insert({w.numberOf(contact.bodies[0]), w.numberOf(contact.bodies[1]), contact.children[0],
                   contact.children[1]});
  }
  return result;
}

class ContactCallbacks : public InBothModes {};
INSTANTIATE_TEST_SUITE_P(Modes, ContactCallbacks, bothModes(), nameOfMode);

TEST_P(ContactCallbacks, GiveTheChildrenAsBulletGivesThem) {
  Heap ours(true);
  Heap bullets(false);
  std::vector<AddedContact> heardOurs;
  std::vector<AddedContact> heardBullets;
  const Heard a = listen(ours, heardOurs);
  const Heard b = listen(bullets, heardBullets);
  ASSERT_GT(b.size(), 30U);
  for (const auto& contact : b) {
    EXPECT_GT(a.count(contact), 0U) << contact[0] << " " << contact[1] << " " << contact[2] << " "
                                    << contact[3];
  }
  EXPECT_LE(a.size(), b.size() + b.size() / 10);
  for (const AddedContact& contact : heardOurs) {
    for (int side = 0; side < 2; ++side) {
      const auto at = static_cast<std::size_t>(side);
      const btCollisionShape* root = contact.bodies[side]->getCollisionShape();
      if (root->isCompound()) {
        const auto* compound = static_cast<const btCompoundShape*>(root);
        ASSERT_GE(contact.children[at], 0);
        EXPECT_EQ(contact.shapes[side], compound->getChildShape(contact.children[at]));
        EXPECT_EQ(contact.wrapperChildren[at], contact.children[at]);
        const btTransform pose =
            contact.bodies[side]->getWorldTransform() * compound->getChildTransform(contact.children[at]);
        EXPECT_LT((pose.getOrigin() - contact.childOrigins[side]).length(), 1e-5F);
      } else if (root->isConvex()) {
        EXPECT_EQ(contact.shapes[side], root);
      }
    }
  }
}

Heap* asked = nullptr;
int answers = 0;

/// Counts the contacts of two bodies.
struct Answer : btCollisionWorld::ContactResultCallback {
  btScalar addSingleResult(btManifoldPoint&, const btCollisionObjectWrapper*, int, int,
                           const btCollisionObjectWrapper*, int, int) override {
    ++answers;
    return 0;
  }
};

// Asks about two other bodies, whose pair comes and goes inside of the step of the one that is told of.
bool hearAndAsk(btManifoldPoint& point, const btCollisionObjectWrapper* wrap0, int part0, int index0,
                const btCollisionObjectWrapper* wrap1, int part1, int index1) {
  static bool isAsking = false;
  if (isAsking) return false;
  isAsking = true;
  Answer answer;
  asked->world.contactPairTest(asked->bodies[0].get(), asked->bodies[3].get(), answer);
  isAsking = false;
  return hear(point, wrap0, part0, index0, wrap1, part1, index1);
}

TEST_P(ContactCallbacks, MayAskAboutOtherPairs) {
  Heap quiet(true);
  Heap curious(true);
  std::vector<AddedContact> heardQuiet;
  std::vector<AddedContact> heardCurious;
  for (int step = 0; step < 3; ++step) {
    heardQuiet.clear();
    heardCurious.clear();
    answers = 0;
    asked = &curious;
    const Heard plain = listen(quiet, heardQuiet);
    EXPECT_EQ(listen(curious, heardCurious, hearAndAsk), plain);
    EXPECT_GT(answers, static_cast<int>(plain.size()));
  }
}

int started = 0;
int ended = 0;
void countStarted(btPersistentManifold* const&) {
  ++started;
}
void countEnded(btPersistentManifold* const&) {
  ++ended;
}

TEST_P(ContactCallbacks, EveryManifoldThatStartsAlsoEnds) {
  for (const bool pairAlgorithm : {true, false}) {
    started = ended = 0;
    gContactStartedCallback = countStarted;
    gContactEndedCallback = countEnded;
    {
      Heap w(pairAlgorithm);
      w.detect();
      EXPECT_GT(started, 20);
      for (int i = 0; i < 6; ++i) {
        w.place(i,
                btTransform(btQuaternion::getIdentity(), btVector3(0, 50.0F * static_cast<float>(i + 1), 0)));
      }
      w.detect();
    }
    gContactStartedCallback = nullptr;
    gContactEndedCallback = nullptr;
    EXPECT_EQ(started, ended) << "pair algorithm " << pairAlgorithm;
  }
}

bool destroyed(void* data) {
  delete static_cast<int*>(data);
  return true;
}

bool attach(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
            const btCollisionObjectWrapper*, int, int) {
  if (point.m_userPersistentData == nullptr) point.m_userPersistentData = new int(1);
  return false;
}

TEST_P(ContactCallbacks, UserDataOfPointsIsGivenBack) {
  // The address sanitizer sees what is lost or freed twice.
  gContactDestroyedCallback = destroyed;
  {
    Heap w(true);
    for (auto& body : w.bodies) {
      body->setCollisionFlags(body->getCollisionFlags() | btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
    }
    gContactAddedCallback = attach;
    Random random(4);
    for (int step = 0; step < 40; ++step) {
      for (int i = 0; i < 6; ++i) w.place(i, random.pose(0.7F));
      if (step % 2 == 0) w.detect();
      w.detect();
    }
    gContactAddedCallback = nullptr;
  }
  gContactDestroyedCallback = nullptr;
}

struct PairHits : btCollisionWorld::ContactResultCallback {
  btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper* wrap0, int, int index0,
                           const btCollisionObjectWrapper* wrap1, int, int index1) override {
    hits.insert({wrap0->m_index, wrap1->m_index, index0, index1});
    deepest = btMin(deepest, point.getDistance());
    return 0;
  }
  std::multiset<std::array<int, 4>> hits;
  btScalar deepest = 1e9F;
};

class Queries : public InBothModes {};
INSTANTIATE_TEST_SUITE_P(Modes, Queries, bothModes(), nameOfMode);

TEST_P(Queries, ContactTestsGiveWhatBulletGives) {
  Heap ours(true);
  Heap bullets(false);
  ours.detect();
  bullets.detect();
  std::size_t all = 0;
  for (std::size_t i = 0; i < ours.bodies.size(); ++i) {
    PairHits single[2];
    ours.world.contactTest(ours.bodies[i].get(), single[0]);
    bullets.world.contactTest(bullets.bodies[i].get(), single[1]);
    EXPECT_EQ(single[0].hits, single[1].hits);
    for (std::size_t k = 0; k < i; ++k) {
      PairHits pair[2];
      ours.world.contactPairTest(ours.bodies[i].get(), ours.bodies[k].get(), pair[0]);
      bullets.world.contactPairTest(bullets.bodies[i].get(), bullets.bodies[k].get(), pair[1]);
      EXPECT_EQ(pair[0].hits, pair[1].hits) << i << " and " << k;
      EXPECT_EQ(pair[0].deepest, pair[1].deepest);
      all += pair[0].hits.size();
    }
  }
  EXPECT_GT(all, 30U);
  const int before = ours.dispatcher.getNumManifolds();
  ours.detect();
  EXPECT_EQ(ours.dispatcher.getNumManifolds(), before);
  EXPECT_EQ(ours.report().m_missed, 0);
}

struct ChildRay : btCollisionWorld::ClosestRayResultCallback {
  using ClosestRayResultCallback::ClosestRayResultCallback;
  btScalar addSingleResult(btCollisionWorld::LocalRayResult& result, bool inWorldSpace) override {
    child = result.m_localShapeInfo != nullptr ? result.m_localShapeInfo->m_triangleIndex : -1;
    return ClosestRayResultCallback::addSingleResult(result, inWorldSpace);
  }
  int child = -2;
};

TEST_P(Queries, RaysHitTheSameChildren) {
  Heap ours(true);
  Heap bullets(false);
  ours.detect();
  bullets.detect();
  Random random(8);
  int hits = 0;
  for (int i = 0; i < 200; ++i) {
    const btVector3 from = random.direction() * 3;
    const btVector3 to = random.inCube(0.5F);
    ChildRay rays[2] = {ChildRay(from, to), ChildRay(from, to)};
    ours.world.rayTest(from, to, rays[0]);
    bullets.world.rayTest(from, to, rays[1]);
    ASSERT_EQ(rays[0].hasHit(), rays[1].hasHit());
    if (!rays[0].hasHit()) continue;
    ++hits;
    EXPECT_EQ(ours.numberOf(rays[0].m_collisionObject), bullets.numberOf(rays[1].m_collisionObject));
    EXPECT_EQ(rays[0].child, rays[1].child);
    EXPECT_EQ(rays[0].m_closestHitFraction, rays[1].m_closestHitFraction);
  }
  EXPECT_GT(hits, 100);
}

}  // namespace
}  // namespace scatter::test
