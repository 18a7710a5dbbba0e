#include "lod/contact_ladder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace scatter::lod {
namespace {

/// Bodies with so many contacts to spare at each rung, and which rungs were asked for.
struct Pile {
  int contacts = 1000;
  int atFirst = 600;
  int atSecond = 800;
  std::vector<int> asked;

  ContactLadder::Find find() {
    return [this](const ContactRung& rung) {
      asked.push_back(rung.mostAlike);
      return SpareContacts{contacts, rung.mostAlike > 4 ? atFirst : atSecond};
    };
  }
};

constexpr double kSaving = 0.5;
constexpr double kRoom = 1000.0;

TEST(ContactLadder, ShowsAllContactsAsLongAsThereIsRoom) {
  ContactLadder ladder(kSaving);
  Pile pile;
  EXPECT_EQ(ladder.settle(800.0, kRoom, pile.find()), 0.0);
  EXPECT_EQ(ladder.rung(), 0);
  EXPECT_EQ(ladder.hidden(), 0);
  EXPECT_TRUE(pile.asked.empty()) << "a quiet step pays nothing";
  EXPECT_EQ(ladder.expected(100), 0.0);
}

TEST(ContactLadder, TakesTheFirstRungBeforeTheBudgetIsUsedUp) {
  ContactLadder ladder(kSaving);
  Pile pile;
  EXPECT_EQ(ladder.settle(900.0, kRoom, pile.find()), kSaving * pile.atFirst);
  EXPECT_EQ(ladder.rung(), 1);
  EXPECT_EQ(ladder.hidden(), pile.atFirst);
  EXPECT_EQ(ladder.expected(100), kSaving * 60);
  EXPECT_TRUE(ladder.concerns(32));
  EXPECT_FALSE(ladder.concerns(31));
}

TEST(ContactLadder, TakesTheSecondRungOnlyWhereTheFirstIsNotEnough) {
  ContactLadder ladder(kSaving);
  Pile pile;
  EXPECT_EQ(ladder.settle(1260.0, kRoom, pile.find()), kSaving * pile.atFirst);
  EXPECT_EQ(ladder.settle(1300.0, kRoom, pile.find()), kSaving * pile.atSecond);
  EXPECT_EQ(ladder.rung(), 2);
  EXPECT_EQ(pile.asked, (std::vector<int>{8, 8, 4}))
      << "the last one that is asked for is the one that is taken";
}

TEST(ContactLadder, ComesDownWhenThereHasBeenRoomForAWhile) {
  ContactLadder ladder(kSaving);
  Pile pile;
  ladder.settle(2000.0, kRoom, pile.find());
  ASSERT_EQ(ladder.rung(), 2);
  std::vector<int> rungs;
  for (int i = 0; i < 200; ++i) {
    ladder.settle(700.0, kRoom, pile.find());
    rungs.push_back(ladder.rung());
  }
  EXPECT_EQ(rungs.front(), 2) << "not at once";
  EXPECT_EQ(rungs[60], 0);
  EXPECT_TRUE(std::is_sorted(rungs.rbegin(), rungs.rend())) << "nor to and fro";
}

TEST(ContactLadder, StaysWhereTheRungBelowWouldNotFit) {
  ContactLadder ladder(kSaving);
  Pile pile;
  pile.atFirst = 10;
  ladder.settle(1200.0, kRoom, pile.find());
  ASSERT_EQ(ladder.rung(), 2);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(ladder.settle(1200.0, kRoom, pile.find()), kSaving * pile.atSecond);
    EXPECT_EQ(pile.asked.back(), 4);
  }
}

TEST(ContactLadder, LooksNowAndThenWhereThereIsNothingToSpare) {
  ContactLadder ladder(kSaving);
  Pile pile;
  pile.atFirst = pile.atSecond = 0;
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(ladder.settle(2000.0, kRoom, pile.find()), 0.0);
    EXPECT_EQ(ladder.rung(), 0);
  }
  EXPECT_LE(pile.asked.size(), 60U);
  EXPECT_GE(pile.asked.size(), 20U);
  pile.atSecond = 800;
  for (int i = 0; i < 8; ++i) ladder.settle(2000.0, kRoom, pile.find());
  EXPECT_EQ(ladder.rung(), 2);
}

}  // namespace
}  // namespace scatter::lod
