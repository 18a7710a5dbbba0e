#include <gtest/gtest.h>

#include "PairTestWorld.h"
#include "TestCharacter.h"

// A character keeps pairs of its own beside those of the broadphase, and dispatches them between steps.

namespace scatter::test {
namespace {

/// A block, and a character whose ghost is 10 cm from it.
class Walk : public PairTestWorld {
 public:
  explicit Walk(btHybridSwitchingMode mode = BT_HYBRID_PAIR_SWITCHING) : PairTestWorld(mode) {
    world.setGravity(btVector3(0, 0, 0));
    world.getSwitchingInfo().m_proximity = false;
  }

  /// Of the pair of the ghost and the block that the ghost keeps; null if it has none.
  [[nodiscard]] btCollisionAlgorithm* ownAlgorithm() {
    btHashedOverlappingPairCache& own = character_.ownPairs();
    return own.getNumOverlappingPairs() > 0 ? own.getOverlappingPairArray()[0].m_algorithm : nullptr;
  }

  btHybridRigidBody* hybrid = addBlock({0, 0, 0});

 private:
  TestCharacter character_{world, {0.9F, 0, 0}, btCollisionObject::CF_NO_CONTACT_RESPONSE};
};

TEST(Character, HasPairsThatNobodyPlans) {
  Walk w;
  w.requestAll(1);
  w.steps(3);
  ASSERT_NE(w.ownAlgorithm(), nullptr);
  EXPECT_EQ(w.pairInfo().pairs, 1);
  EXPECT_EQ(w.world.getCollisionMemory().m_pairs, 2);
}

TEST(Character, LosesItsPairsWhenTheKindOfSwitchingChanges) {
  Walk w;
  for (const btHybridSwitchingMode mode : {BT_HYBRID_BODY_SWITCHING, BT_HYBRID_PAIR_SWITCHING}) {
    w.steps(3);
    ASSERT_NE(w.ownAlgorithm(), nullptr);
    ASSERT_EQ(w.world.setSwitchingMode(mode), 0);
    EXPECT_EQ(w.ownAlgorithm(), nullptr);
    EXPECT_EQ(w.world.getCollisionMemory().m_pairs, 0);
  }
  w.steps(3);
}

TEST(Character, LosesItsPairsWhenOtherAlgorithmsAreToCollide) {
  Walk w;
  w.steps(3);
  btHybridCollisionInfo ways = w.world.getCollisionInfo();
  ways.m_pairAlgorithm = false;
  ASSERT_EQ(w.world.setCollisionInfo(ways), nullptr);
  EXPECT_EQ(w.ownAlgorithm(), nullptr);
  w.steps(3);
  EXPECT_EQ(w.world.getCollisionMemory().m_pairs, 0);
}

// Bullet's algorithm for a compound would take the box that is the block's first level for one.
TEST(Character, MeetsTheShapeOfABodyThatHasSwitched) {
  Walk w(BT_HYBRID_BODY_SWITCHING);
  btHybridCollisionInfo ways = w.world.getCollisionInfo();
  ways.m_pairAlgorithm = false;
  ASSERT_EQ(w.world.setCollisionInfo(ways), nullptr);
  w.steps(3);
  ASSERT_EQ(w.hybrid->getLevel(), 3);
  w.requestAll(1);
  w.steps(3);
  EXPECT_EQ(w.hybrid->getLevel(), 1);
  EXPECT_NE(w.ownAlgorithm(), nullptr);
}

TEST(Character, MayOutliveItsPairsWithBodies) {
  Walk w;
  w.steps(3);
  w.world.removeRigidBody(w.hybrid);
  EXPECT_EQ(w.ownAlgorithm(), nullptr);
  EXPECT_EQ(w.world.getCollisionMemory().m_pairs, 0);
  w.steps(3);
}

}  // namespace
}  // namespace scatter::test
