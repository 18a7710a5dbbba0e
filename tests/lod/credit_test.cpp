#include "lod/credit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace scatter::lod {
namespace {

/// The same depth for all child pairs.
auto depth(float metres) {
  return [metres](int, int) { return metres; };
}

/// The distance that the contacts of a child pair get: `deep` metres of overlap, and its credit.
float distanceAt(const CreditAccount& account, float deep) {
  return -deep + account.of(1, 2);
}

TEST(Credit, MakesTheDistanceAtTheGrantTheGapOfTheFinestShapes) {
  for (const float gap : {0.0F, 0.02F, 0.2F}) {
    CreditAccount account;
    account.grant(1, 2, 0.15F, gap);
    EXPECT_NEAR(distanceAt(account, 0.15F), gap, 1e-6F);
  }
}

/// Where the finest shapes overlap, the contacts that are held for them press; coarse shapes that overlap
/// less deep, and somewhere else, have no reason to.
TEST(Credit, LeavesNothingToPressWhereTheFinestShapesOverlap) {
  CreditAccount account;
  account.grant(1, 2, 0.15F, -0.005F);
  account.grant(1, 3, 0.01F, -0.03F);
  EXPECT_NEAR(distanceAt(account, 0.15F), 0.0F, 1e-6F);
  EXPECT_FLOAT_EQ(account.of(1, 3), 0.01F);
  account.shrink([](int, int b) { return b == 2 ? 0.14F : 0.01F; });
  EXPECT_FLOAT_EQ(account.of(1, 2), 0.14F);
  EXPECT_FLOAT_EQ(account.of(1, 3), 0.01F);
}

TEST(Credit, IsKeptForEachChildPair) {
  CreditAccount account;
  EXPECT_TRUE(account.empty());
  account.grant(1, 2, 0.1F, 0.0F);
  account.grant(1, 3, 0.2F, 0.05F);
  EXPECT_FLOAT_EQ(account.of(1, 2), 0.1F);
  EXPECT_FLOAT_EQ(account.of(1, 3), 0.25F);
  EXPECT_EQ(account.of(2, 1), 0.0F);
  EXPECT_EQ(account.of(3, 1), 0.0F);
  account.shrink([](int, int b) { return b == 2 ? 0.0F : 0.2F; });
  EXPECT_EQ(account.of(1, 2), 0.0F) << "it has come apart";
  EXPECT_FLOAT_EQ(account.of(1, 3), 0.25F);
  account.close();
  EXPECT_TRUE(account.empty());
}

TEST(Credit, LetsTheGapCloseAndThenStandsInTheWay) {
  CreditAccount account;
  account.grant(1, 2, 0.10F, 0.03F);
  // The coarse shapes go 5 cm deeper, which is 2 cm more than the finest ones have room for.
  float before = distanceAt(account, 0.10F);
  for (float deep = 0.10F; deep <= 0.15F; deep += 0.005F) {
    account.shrink(depth(deep));
    const float now = distanceAt(account, deep);
    EXPECT_LE(now, before + 1e-6F);
    before = now;
  }
  // Its last centimetre counts as closed.
  EXPECT_LE(before, -0.02F + 1e-5F);
  EXPECT_GE(before, -0.03F);
}

TEST(Credit, DoesNotComeBackOnceTheGapHasClosed) {
  CreditAccount account;
  account.grant(1, 2, 0.10F, 0.03F);
  account.shrink(depth(0.13F));
  EXPECT_NEAR(distanceAt(account, 0.13F), 0.0F, 1e-6F);
  account.shrink(depth(0.10F));
  EXPECT_NEAR(distanceAt(account, 0.10F), 0.0F, 1e-6F) << "the gap does not open again";
  account.shrink(depth(0.05F));
  EXPECT_NEAR(distanceAt(account, 0.05F), 0.0F, 1e-6F);
  account.shrink(depth(0.08F));
  EXPECT_NEAR(distanceAt(account, 0.08F), -0.03F, 1e-6F) << "what has come apart touches as usual";
}

TEST(Credit, OfShapesThatHaveComeApartIsGoneForGood) {
  CreditAccount account;
  account.grant(1, 2, 0.1F, 0.02F);
  account.shrink(depth(0.0F));
  EXPECT_TRUE(account.empty());
  account.shrink(depth(0.1F));
  EXPECT_EQ(account.of(1, 2), 0.0F);
}

TEST(Credit, AnAuditTakesTheGapThatWasMeasured) {
  CreditAccount account;
  account.grant(1, 2, 0.1F, 0.0F);
  account.shrink(depth(0.1F));
  account.audit(0.04F, depth(0.12F));
  EXPECT_NEAR(distanceAt(account, 0.12F), 0.04F, 1e-6F);
  account.audit(-0.01F, depth(0.12F));
  EXPECT_NEAR(distanceAt(account, 0.12F), 0.0F, 1e-6F) << "the finest shapes overlap";
  account.audit(0.04F, depth(0.0F));
  EXPECT_TRUE(account.empty());
}

TEST(Credit, OnlyShrinksWithoutAnAudit) {
  std::mt19937_64 random(9);
  const auto upTo = [&random](float most) {
    return most * static_cast<float>(random() >> 40U) / 16777216.0F;
  };
  for (int round = 0; round < 500; ++round) {
    CreditAccount account;
    float deep = upTo(0.3F) + 0.001F;
    account.grant(1, 2, deep, upTo(0.1F) - 0.02F);
    float before = account.of(1, 2);
    for (int step = 0; step < 50; ++step) {
      deep = std::max(deep + upTo(0.04F) - 0.02F, 0.0F);
      account.shrink(depth(deep));
      ASSERT_LE(account.of(1, 2), before);
      ASSERT_GE(account.of(1, 2), 0.0F);
      before = account.of(1, 2);
    }
  }
}

}  // namespace
}  // namespace scatter::lod
