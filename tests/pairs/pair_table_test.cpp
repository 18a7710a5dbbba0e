#include "pairs/pair_table.h"

#include <gtest/gtest.h>

#include <array>

namespace scatter::pairs {
namespace {

TEST(PairTable, TellsWhereAPairHasMovedTo) {
  PairTable table;
  std::array<int, 4> places{};
  for (int& place : places) table.add(&place);
  EXPECT_EQ(places, (std::array{0, 1, 2, 3}));
  for (std::size_t i = 0; i < places.size(); ++i) table[places[i]].jumps = static_cast<int>(i);
  table.remove(places[1]);
  EXPECT_EQ(table.count(), 3);
  EXPECT_EQ(places[3], 1);
  EXPECT_EQ(table[places[3]].jumps, 3);
  EXPECT_EQ(table[places[2]].jumps, 2);
  table.remove(places[2]);
  EXPECT_EQ(table[places[3]].jumps, 3);
}

TEST(PairTable, GivesNewPairsTheMemoryOfOldOnes) {
  PairTable table;
  int place = -1;
  table.add(&place);
  table[place].parts.children().reserve(100);
  table[place].quietUntil = 1.0;
  table[place].origin = ContactOrigin::kKept;
  table.remove(place);
  table.add(&place);
  EXPECT_GE(table[place].parts.children().capacity(), 100U);
  EXPECT_LT(table[place].quietUntil, 0.0);
  EXPECT_EQ(table[place].origin, ContactOrigin::kFound);
  EXPECT_TRUE(table[place].credit.account.empty());
}

}  // namespace
}  // namespace scatter::pairs
