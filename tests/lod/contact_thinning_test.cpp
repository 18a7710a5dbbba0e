#include "lod/contact_thinning.h"

#include <gtest/gtest.h>

namespace scatter::lod {
namespace {

constexpr double kSaving = 0.5;
constexpr double kRoom = 1000.0;

/// Bodies with contacts to spare, and how often somebody looked.
struct Pile {
  int spare = 600;
  int looks = 0;

  ContactThinning::Find find() {
    return [this](const ThinningRule& rule) {
      EXPECT_GT(rule.mostAlike, 0);
      EXPECT_TRUE(ContactThinning::concerns(rule.leastContacts));
      EXPECT_FALSE(ContactThinning::concerns(rule.leastContacts - 1));
      ++looks;
      return SpareContacts{1000, spare};
    };
  }
};

TEST(ContactThinning, ShowsAllContactsAsLongAsThereIsRoom) {
  ContactThinning thinning(kSaving);
  Pile pile;
  thinning.settle(850.0, kRoom, pile.find());
  EXPECT_EQ(thinning.hidden(), 0);
  EXPECT_EQ(thinning.saved(), 0.0);
  EXPECT_EQ(pile.looks, 0) << "a quiet step pays nothing";
  EXPECT_EQ(thinning.expected(100), 0.0);
}

TEST(ContactThinning, SparesAsManyContactsAsAreNeededBeforeTheBudgetIsUsedUp) {
  ContactThinning thinning(kSaving);
  Pile pile;
  for (const double full : {900.0, 950.0, 1100.0, 1179.0}) {
    thinning.settle(full, kRoom, pile.find());
    EXPECT_GT(full - thinning.saved(), 0.83 * kRoom);
    EXPECT_LE(full - thinning.saved(), 0.88 * kRoom);
    EXPECT_EQ(thinning.saved(), kSaving * thinning.hidden());
    EXPECT_EQ(thinning.mostSaved(), kSaving * pile.spare);
  }
  thinning.settle(2000.0, kRoom, pile.find());
  EXPECT_EQ(thinning.hidden(), pile.spare);
  EXPECT_EQ(thinning.expected(100), kSaving * 60) << "the next step may save as much";
}

TEST(ContactThinning, HidesAsManyWhileALittleLessIsNeeded) {
  ContactThinning thinning(kSaving);
  Pile pile;
  thinning.settle(1100.0, kRoom, pile.find());
  const int hidden = thinning.hidden();
  for (int i = 0; i < 200; ++i) {
    thinning.settle(i % 2 == 0 ? 1090.0 : 1110.0, kRoom, pile.find());
    EXPECT_EQ(thinning.hidden(), hidden) << i;
  }
}

TEST(ContactThinning, ShowsThemAgainWhenThereHasBeenRoomForAWhile) {
  ContactThinning thinning(kSaving);
  Pile pile;
  thinning.settle(2000.0, kRoom, pile.find());
  int steps = 0;
  while (thinning.hidden() > 0 && steps < 1000) {
    // Now and then all are needed: that does not count as room.
    thinning.settle(steps == 8 ? 1180.0 : 700.0, kRoom, pile.find());
    ++steps;
  }
  EXPECT_GT(steps, 16);
  EXPECT_LT(steps, 40);
  thinning.settle(800.0, kRoom, pile.find());
  EXPECT_EQ(thinning.saved(), 0.0) << "nor does it go to and fro";
}

// A budget is used while what it is spent on falls asleep.
TEST(ContactThinning, FollowsALoadThatFallsFromStepToStep) {
  ContactThinning thinning(kSaving);
  Pile pile;
  for (double full = 1180.0; full > 890.0; full -= 2.0) {
    thinning.settle(full, kRoom, pile.find());
    EXPECT_GT(full - thinning.saved(), 0.78 * kRoom) << full;
  }
}

TEST(ContactThinning, LooksNowAndThenWhereThereIsNothingToSpare) {
  ContactThinning thinning(kSaving);
  Pile pile;
  pile.spare = 0;
  for (int i = 0; i < 100; ++i) {
    thinning.settle(2000.0, kRoom, pile.find());
    EXPECT_EQ(thinning.saved(), 0.0);
  }
  EXPECT_LE(pile.looks, 30);
  EXPECT_GE(pile.looks, 20);
  pile.spare = 800;
  for (int i = 0; i < 4; ++i) thinning.settle(2000.0, kRoom, pile.find());
  EXPECT_EQ(thinning.hidden(), 800);
}

}  // namespace
}  // namespace scatter::lod
