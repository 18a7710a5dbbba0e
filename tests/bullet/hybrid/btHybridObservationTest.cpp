#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "PairTestWorld.h"

// What programs that use Bullet directly see of pairs and requests, and change while a world runs.

namespace scatter::test {
namespace {

using testing::ElementsAre;

const btBroadphasePair* pairOf(PairTestWorld& w, btCollisionObject* a, btCollisionObject* b) {
  return w.world.getPairCache()->findPair(a->getBroadphaseHandle(), b->getBroadphaseHandle());
}

int contactsIn(const btBroadphasePair& pair) {
  btAlignedObjectArray<btHybridManifoldView> manifolds;
  btHybridGetManifolds(pair, manifolds);
  int count = 0;
  for (int i = 0; i < manifolds.size(); ++i) count += manifolds[i].m_manifold->getNumContacts();
  return count;
}

TEST(HybridView, OfAPairWithoutHybridsIsEmpty) {
  PairTestWorld w;
  auto* box = w.shape<btBoxShape>(btVector3(0.5F, 0.5F, 0.5F));
  btRigidBody* a = w.add(1, box, {0, 0, 0});
  btRigidBody* b = w.add(1, box, {0.99F, 0, 0});
  w.addBlock({20, 0, 0});
  w.step();
  const btHybridPairView view = w.world.viewPair(*pairOf(w, a, b));
  EXPECT_EQ(view.m_level, 0);
  EXPECT_EQ(view.m_finestLevel, 0);
  EXPECT_FALSE(view.m_credited);
  EXPECT_EQ(contactsIn(*pairOf(w, a, b)), 4);
}

TEST(HybridView, OfABlockedPairCountsDownToTheNextTry) {
  PairTestWorld w;
  w.world.getPairSwitchingInfo().m_credit = false;
  btHybridRigidBody* a = w.addBlock({0, 0, 0});
  btHybridRigidBody* b = w.addBlock({1, 0, 0});
  w.step();
  ASSERT_TRUE(w.world.requestLevel(a, 1));
  EXPECT_FALSE(w.world.viewRequest(a).m_tried);
  w.step();
  const btHybridPairView first = w.world.viewPair(*pairOf(w, a, b));
  EXPECT_EQ(first.m_level, 3);
  EXPECT_EQ(first.m_request.m_targetLevel, 1);
  EXPECT_TRUE(first.m_request.m_tried);
  EXPECT_STREQ(first.m_request.m_policy, "program");
  EXPECT_EQ(w.world.viewRequest(a).m_blockedBy, b);
  EXPECT_EQ(w.world.viewRequest(b).m_targetLevel, 0);
  const std::size_t tries = w.pairs.story(a, b).size();
  w.steps(first.m_request.m_retrySteps - 1);
  EXPECT_EQ(w.pairs.story(a, b).size(), tries);
  w.step();
  EXPECT_EQ(w.pairs.story(a, b).size(), tries + 1) << "tried again in the step that was named";
}

TEST(HybridView, ManifoldsAreThoseOfTheDispatcher) {
  PairTestWorld w;
  w.world.setGravity(btVector3(0, -10, 0));
  btRigidBody* floor = w.addFloor();
  btHybridRigidBody* lower = w.addBlock({0, 0.5F, 0});
  btHybridRigidBody* upper = w.addBlock({0, 1.5F, 0});
  w.steps(30);
  for (int step = 0; step < 2; ++step) {
    EXPECT_GT(contactsIn(*pairOf(w, lower, upper)), 0);
    EXPECT_EQ(contactsIn(*pairOf(w, lower, upper)), w.contactsOf(lower, upper));
    EXPECT_EQ(contactsIn(*pairOf(w, floor, lower)), w.contactsOf(floor, lower));
    w.requestAll(2);
    w.step();
    EXPECT_TRUE(w.world.viewPair(*pairOf(w, lower, upper)).m_credited);
  }
}

TEST(HybridHeld, ObjectIsMetFinelyWhateverIsAskedFor) {
  PairTestWorld w;
  btRigidBody* plain = w.add(1, w.shape<btBoxShape>(btVector3(0.5F, 0.5F, 0.5F)), {-1.25F, 0, 0});
  btHybridRigidBody* a = w.addBlock({0, 0, 0});
  btHybridRigidBody* b = w.addBlock({1.45F, 0, 0});
  w.requestAll(1);
  w.step();
  ASSERT_EQ(w.levelOf(a, b), 1);
  ASSERT_EQ(w.levelOf(a, plain), 1);
  w.world.setHeld(plain, true);
  w.steps(2);
  EXPECT_EQ(w.levelOf(a, plain), 3);
  EXPECT_EQ(w.levelOf(a, b), 1) << "nobody holds these";
  w.world.setHeld(plain, false);
  w.steps(2);
  EXPECT_EQ(w.levelOf(a, plain), 1);
}

TEST(SwitchingMode, ChangesWithAllRequestsRetracted) {
  PairTestWorld w;
  btHybridRigidBody* a = w.addBlock({0, 0, 0});
  btHybridRigidBody* b = w.addBlock({1.45F, 0, 0});
  w.requestAll(1);
  w.step();
  ASSERT_EQ(w.levelOf(a, b), 1);
  w.world.requestLevel(a, 2);
  ASSERT_EQ(w.world.setSwitchingMode(BT_HYBRID_BODY_SWITCHING), 0);
  EXPECT_EQ(w.world.getSwitchingMode(), BT_HYBRID_BODY_SWITCHING);
  EXPECT_EQ(a->getLevel(), 3);
  EXPECT_FALSE(a->getRequest().isStanding());
  EXPECT_THAT(w.pairs.story(a),
              ElementsAre("requested 1", "acknowledged 1", "switched 1", "requested 2", "retracted 2"));
  w.world.requestLevel(a, 1);
  w.step();
  EXPECT_EQ(a->getCollisionShape(), w.block.getLevelShape(1)) << "a body's level is its shape now";
  ASSERT_EQ(w.world.setSwitchingMode(BT_HYBRID_PAIR_SWITCHING), 0);
  EXPECT_EQ(a->getCollisionShape(), w.block.getLevelShape(3));
  EXPECT_EQ(w.world.setSwitchingMode(BT_HYBRID_PAIR_SWITCHING), 0) << "nothing to do";
  w.step();
  EXPECT_EQ(w.levelOf(a, b), 3);
}

TEST(SwitchingMode, ChangesUnderAStackThatDoesNotNotice) {
  PairTestWorld w;
  w.world.setGravity(btVector3(0, -10, 0));
  w.addFloor();
  btHybridRigidBody* top = nullptr;
  for (int i = 0; i < 5; ++i) top = w.addBlock({0, 0.5F + static_cast<float>(i), 0});
  w.steps(60);
  w.requestAll(2);
  w.steps(30);
  ASSERT_GT(w.pairInfo().creditedPairs, 0);
  const btVector3 before = top->getWorldTransform().getOrigin();
  for (const btHybridSwitchingMode mode : {BT_HYBRID_BODY_SWITCHING, BT_HYBRID_PAIR_SWITCHING}) {
    ASSERT_EQ(w.world.setSwitchingMode(mode), 0);
    double most = 0;
    for (int i = 0; i < 60; ++i) {
      w.step();
      most = std::max(most, w.kineticEnergy());
    }
    // Contacts are found anew, without what they bore: about as if nothing had held 5 kg for one step.
    EXPECT_LT(most, 1.1 * 0.5 * 5 * (10.0 / 60) * (10.0 / 60));
    EXPECT_LT((top->getWorldTransform().getOrigin() - before).length(), 0.02F);
  }
}

TEST(SwitchingMode, IsRefusedWherePairsOnCreditAreDeep) {
  PairTestWorld w;
  btHybridRigidBody* a = w.addBlock({0, 0, 0});
  btHybridRigidBody* b = w.addBlock({0.8F, 0, 0});
  w.step();
  w.world.requestLevel(a, 2);
  w.step();
  ASSERT_TRUE(w.world.viewPair(*pairOf(w, a, b)).m_credited);
  EXPECT_EQ(w.world.setSwitchingMode(BT_HYBRID_BODY_SWITCHING), 1);
  EXPECT_EQ(w.world.getSwitchingMode(), BT_HYBRID_PAIR_SWITCHING);
  EXPECT_EQ(w.levelOf(a, b), 2);
}

}  // namespace
}  // namespace scatter::test
