#include "lod/contact_thinning.h"

#include <gtest/gtest.h>

namespace scatter::lod {
namespace {

constexpr double kSaving = 0.5;
constexpr double kRoom = 1000.0;

/// Bodies with contacts to spare, and how often somebody looked.
struct Pile {
  int hidden = 600;
  int looks = 0;

  ContactThinning::Find find() {
    return [this](const ThinningRule& rule) {
      EXPECT_GT(rule.mostAlike, 0);
      EXPECT_TRUE(ContactThinning::concerns(rule.leastContacts));
      EXPECT_FALSE(ContactThinning::concerns(rule.leastContacts - 1));
      ++looks;
      return SpareContacts{1000, hidden};
    };
  }
};

TEST(ContactThinning, ShowsAllContactsAsLongAsThereIsRoom) {
  ContactThinning thinning(kSaving);
  Pile pile;
  EXPECT_EQ(thinning.settle(800.0, kRoom, pile.find()), 0.0);
  EXPECT_EQ(thinning.hidden(), 0);
  EXPECT_EQ(pile.looks, 0) << "a quiet step pays nothing";
  EXPECT_EQ(thinning.expected(100), 0.0);
}

TEST(ContactThinning, SparesContactsBeforeTheBudgetIsUsedUp) {
  ContactThinning thinning(kSaving);
  Pile pile;
  EXPECT_EQ(thinning.settle(900.0, kRoom, pile.find()), kSaving * pile.hidden);
  EXPECT_EQ(thinning.hidden(), pile.hidden);
  EXPECT_EQ(thinning.expected(100), kSaving * 60) << "the next step will save as much";
}

TEST(ContactThinning, ShowsThemAgainWhenThereHasBeenRoomForAWhile) {
  ContactThinning thinning(kSaving);
  Pile pile;
  thinning.settle(2000.0, kRoom, pile.find());
  int steps = 0;
  while (thinning.hidden() > 0 && steps < 1000) {
    // Now and then it is needed: that does not count as room.
    thinning.settle(steps == 20 ? 900.0 : 700.0, kRoom, pile.find());
    ++steps;
  }
  EXPECT_GT(steps, 40);
  EXPECT_LT(steps, 100);
  EXPECT_EQ(thinning.settle(800.0, kRoom, pile.find()), 0.0) << "nor does it go to and fro";
}

TEST(ContactThinning, LooksNowAndThenWhereThereIsNothingToSpare) {
  ContactThinning thinning(kSaving);
  Pile pile;
  pile.hidden = 0;
  for (int i = 0; i < 100; ++i) EXPECT_EQ(thinning.settle(2000.0, kRoom, pile.find()), 0.0);
  EXPECT_LE(pile.looks, 30);
  EXPECT_GE(pile.looks, 20);
  pile.hidden = 800;
  for (int i = 0; i < 4; ++i) thinning.settle(2000.0, kRoom, pile.find());
  EXPECT_EQ(thinning.hidden(), 800);
}

}  // namespace
}  // namespace scatter::lod
