#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "PairTestWorld.h"

// Levels of pairs, requests for them, and what is told of them.

namespace scatter::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// Two crosses this far from each other overlap at levels 1 and 2, and are apart at their finest.
const btVector3 kHooked(0.6F, 0.7F, 0.8F);

TEST(PairLevel, IsTheFinestWithoutAReason) {
  PairTestWorld w;
  btHybridRigidBody* a = w.addCross({0, 0, 0});
  btHybridRigidBody* b = w.addCross({1.9F, 0, 0});
  btHybridRigidBody* c = w.addCross({30, 0, 0});
  w.step();
  EXPECT_EQ(w.levelOf(a, b), 3);
  EXPECT_EQ(w.levelOf(b, a), 3);
  EXPECT_EQ(w.levelOf(a, c), 0);
  EXPECT_EQ(w.pairInfo().pairs, 1);
  EXPECT_EQ(w.pairInfo().finestPairs, 1);
}

TEST(PairLevel, CountsTheLevelsOfTheBodyThatHasMore) {
  PairTestWorld w;
  btHybridLevelSet two;
  two.addLevel(w.shape<btBoxShape>(btVector3(1, 1, 1)));
  two.addLevel(w.shape<btBoxShape>(btVector3(0.5F, 0.5F, 0.5F)));
  btHybridRigidBody* cross = w.addCross({0, 0, 0});
  btHybridRigidBody* box = w.addHybrid(two, {1.8F, 0, 0});
  btRigidBody* plain = w.add(1, w.shape<btBoxShape>(btVector3(0.5F, 0.5F, 0.5F)), {-1.4F, 0, 0});
  btRigidBody* other = w.add(1, w.shape<btBoxShape>(btVector3(0.5F, 0.5F, 0.5F)), {-2.3F, 0, 0});
  w.step();
  EXPECT_EQ(w.levelOf(cross, box), 3);
  EXPECT_EQ(w.levelOf(plain, cross), 3);
  EXPECT_EQ(w.levelOf(plain, other), 0) << "neither has levels";
  w.world.removeRigidBody(box);
}

TEST(PairLevel, IsEachPairsOwn) {
  PairTestWorld w;
  btHybridRigidBody* a = w.addCross({0, 0, 0});
  btHybridRigidBody* b = w.addCross({2.005F, 0, 0});
  btHybridRigidBody* c = w.addCross({-2.005F, 0, 0});
  ASSERT_TRUE(w.world.requestLevel(b, 1));
  ASSERT_TRUE(w.world.requestLevel(c, 2));
  w.step();
  EXPECT_EQ(w.levelOf(a, b), 1);
  EXPECT_EQ(w.levelOf(a, c), 2);
  EXPECT_EQ(a->getLevel(), 3);
  EXPECT_EQ(a->getCollisionShape(), w.cross.getLevelShape(3)) << "for rays and drawing";
  EXPECT_EQ(b->getCollisionShape(), w.cross.getLevelShape(3));
}

TEST(PairRequest, OfABodyWithoutPairsIsFulfilledAtTheNextStep) {
  PairTestWorld w;
  btHybridRigidBody* body = w.addCross({0, 0, 0});
  ASSERT_TRUE(w.world.requestLevel(body, 1));
  EXPECT_EQ(body->getLevel(), 3);
  w.step();
  EXPECT_EQ(body->getLevel(), 1);
  EXPECT_THAT(w.pairs.story(body), ElementsAre("requested 1", "acknowledged 1", "switched 1"));
  EXPECT_EQ(w.world.getStepInfo().m_switchesCoarser, 1);
}

TEST(PairRequest, StandsUntilAllPairsComply) {
  PairTestWorld w;
  w.world.getPairSwitchingInfo().m_credit = false;
  btHybridRigidBody* a = w.addCross({0, 0, 0});
  btHybridRigidBody* far = w.addCross({2.005F, 0, 0});
  btHybridRigidBody* hooked = w.addCross(-kHooked);
  w.step();
  w.world.requestLevel(a, 1);
  w.steps(30);
  EXPECT_EQ(w.levelOf(a, far), 1) << "one neighbour need not wait for the other";
  EXPECT_EQ(w.levelOf(a, hooked), 3);
  EXPECT_EQ(a->getLevel(), 3);
  EXPECT_TRUE(a->getRequest().isStanding());
  w.world.removeRigidBody(hooked);
  w.steps(2);
  EXPECT_EQ(a->getLevel(), 1);
  EXPECT_FALSE(a->getRequest().isStanding());
  EXPECT_THAT(w.pairs.story(a), ElementsAre("requested 1", "acknowledged 1", "switched 1"));
}

TEST(PairRequest, CanBeRetractedAndLetsThePairsBeFineAgain) {
  PairTestWorld w;
  w.world.getPairSwitchingInfo().m_credit = false;
  btHybridRigidBody* a = w.addCross({0, 0, 0});
  btHybridRigidBody* b = w.addCross(kHooked);
  btHybridRigidBody* c = w.addCross({-2.005F, 0, 0});
  w.step();
  w.world.requestLevel(a, 1);
  w.step();
  ASSERT_EQ(w.levelOf(a, b), 3);
  ASSERT_EQ(w.levelOf(a, c), 1);
  w.world.retractRequest(a);
  w.steps(40);
  EXPECT_FALSE(a->getRequest().isStanding());
  EXPECT_EQ(w.levelOf(a, c), 3);
  EXPECT_EQ(w.pairs.reason, BT_HYBRID_RETRACTED_BY_CALLER);
  EXPECT_EQ(w.pairs.story(a, b).back(), "retracted 3 to 1");
}

TEST(PairRequest, ForTheFinestLevelGivesDetailBack) {
  PairTestWorld w;
  btHybridRigidBody* a = w.addCross({0, 0, 0}, 1);
  btHybridRigidBody* b = w.addCross({2.005F, 0, 0}, 1);
  w.step();
  ASSERT_EQ(w.levelOf(a, b), 1) << "bodies start at the level that they were made with";
  w.world.requestLevel(a, 3);
  w.steps(30);
  EXPECT_EQ(a->getLevel(), 3);
  EXPECT_EQ(w.levelOf(a, b), 1) << "the other body still holds it";
  w.world.requestLevel(b, 3);
  w.steps(30);
  EXPECT_EQ(w.levelOf(a, b), 3);
}

TEST(PairRequest, IsNotHeldUpByPairsThatDoNotCollide) {
  PairTestWorld w;
  btHybridRigidBody* body = w.addCross({0, 0, 0});
  btHybridRigidBody* sensor = w.addCross(kHooked);
  btHybridRigidBody* ignored = w.addCross(-kHooked);
  w.step();
  sensor->setCollisionFlags(sensor->getCollisionFlags() | btCollisionObject::CF_NO_CONTACT_RESPONSE);
  body->setIgnoreCollisionCheck(ignored, true);
  ignored->setIgnoreCollisionCheck(body, true);
  w.world.requestLevel(body, 1);
  w.steps(30);
  EXPECT_EQ(body->getLevel(), 1);
  EXPECT_FALSE(body->getRequest().isStanding());
}

TEST(PairRequest, EndsWhenTheBodyLeavesTheWorld) {
  PairTestWorld w;
  w.world.getPairSwitchingInfo().m_credit = false;
  btHybridRigidBody* a = w.addCross({0, 0, 0});
  btHybridRigidBody* b = w.addCross(kHooked);
  w.step();
  w.world.requestLevel(a, 1);
  w.step();
  w.world.removeRigidBody(a);
  EXPECT_EQ(w.pairs.reason, BT_HYBRID_RETRACTED_BY_REMOVAL);
  EXPECT_EQ(w.pairs.story(a, b).back(), "retracted 3 to 1");
  w.step();
  EXPECT_EQ(w.pairInfo().retractions, 1);
  EXPECT_EQ(w.pairInfo().requests, 0);
}

TEST(PairEvent, TellsASwitchToSeparatedShapes) {
  PairTestWorld w;
  btHybridRigidBody* a = w.addCross({0, 0, 0});
  btHybridRigidBody* b = w.addCross({2.005F, 0, 0});
  w.step();
  EXPECT_THAT(w.pairs.events, IsEmpty()) << "a new pair at its finest level is nothing to tell of";
  w.world.requestLevel(a, 1);
  w.step();
  EXPECT_THAT(w.pairs.story(a, b), ElementsAre("requested 3 to 1", "acknowledged 3 to 1", "switched 3 to 1"));
  EXPECT_STREQ(w.pairs.events[0].m_policy, "program");
  EXPECT_EQ(w.pairInfo().switchesCoarser, 1);
  EXPECT_EQ(w.pairInfo().creditSwitches, 0);
  EXPECT_GT(w.pairInfo().separationQueries, 0);
}

TEST(PairEvent, TellsASwitchOnCreditPartOfTheWay) {
  PairTestWorld w;
  btHybridRigidBody* a = w.addCross({0, 0, 0});
  btHybridRigidBody* b = w.addCross({0.1F, 1.99F, 0.1F});
  w.steps(3);
  ASSERT_GT(w.contactsOf(a, b), 0);
  w.world.getPairSwitchingInfo().m_creditLevel = 2;
  w.world.requestLevel(a, 1);
  w.step();
  const std::vector<std::string> story = w.pairs.story(a, b);
  ASSERT_GE(story.size(), 3U);
  EXPECT_EQ(story[0], "requested 3 to 1");
  EXPECT_EQ(story[1], "acknowledged 3 to 1");
  EXPECT_EQ(story[2], "switched 3 to 2 on credit");
  EXPECT_EQ(w.levelOf(a, b), 2);
  EXPECT_TRUE(a->getRequest().isStanding());
}

TEST(PairEvent, TellsBlockedTriesAndRetriesFinerOnesAtTheInterval) {
  PairTestWorld w;
  w.world.getPairSwitchingInfo().m_retryInterval = 5;
  btHybridRigidBody* a = w.addCross({0, 0, 0}, 1);
  btHybridRigidBody* b = w.addCross({2.005F, 0, 0}, 1);
  w.step();
  ASSERT_EQ(w.levelOf(a, b), 1);
  w.requestAll(3);
  // Held 3 cm inside each other.
  const auto hold = [&](float x) {
    for (btHybridRigidBody* body : {a, b}) {
      body->setLinearVelocity(btVector3(0, 0, 0));
      body->setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(body == b ? x : 0, 0, 0)));
    }
    w.step();
  };
  for (int i = 0; i < 11; ++i) hold(1.97F);
  EXPECT_THAT(w.pairs.story(a, b), ElementsAre("requested 1 to 3", "acknowledged 1 to 3", "blocked 1 to 3",
                                               "blocked 1 to 3", "blocked 1 to 3"));
  for (int i = 0; i < 5; ++i) hold(2.1F);
  EXPECT_EQ(w.pairs.story(a, b).back(), "switched 1 to 3");
  EXPECT_EQ(w.levelOf(a, b), 3);
}

TEST(PairLevel, OfASensorStaysTheFinest) {
  PairTestWorld w;
  btHybridRigidBody* a = w.addCross({0, 0, 0});
  btHybridRigidBody* b = w.addCross({2.005F, 0, 0});
  b->setCollisionFlags(b->getCollisionFlags() | btCollisionObject::CF_NO_CONTACT_RESPONSE);
  w.step();
  w.world.requestLevel(a, 1);
  w.world.addPolicy("coarsest");
  w.steps(20);
  EXPECT_EQ(w.levelOf(a, b), 3);
  b->setCollisionFlags(0);
  w.steps(20);
  EXPECT_EQ(w.levelOf(a, b), 1);
}

TEST(Policies, AreCheckedAndTakenBack) {
  PairTestWorld w;
  EXPECT_STRNE(w.world.addPolicy("no such thing"), nullptr);
  btHybridRigidBody* a = w.addCross({0, 0, 0});
  btHybridRigidBody* b = w.addCross({2.005F, 0, 0});
  EXPECT_EQ(w.world.addPolicy("coarsest"), nullptr);
  w.steps(8);
  EXPECT_EQ(w.levelOf(a, b), 1);
  w.world.removePolicies();
  w.steps(40);
  EXPECT_EQ(w.levelOf(a, b), 3);
}

}  // namespace
}  // namespace scatter::test
