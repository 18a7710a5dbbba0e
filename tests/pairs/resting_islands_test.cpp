#include "pairs/resting_islands.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "pairs/fake_body.h"

namespace scatter::pairs {
namespace {

using ::testing::ElementsAre;
using testing::FakeBody;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

class RestingIslandsTest : public ::testing::Test {
 protected:
  RestingIslandsTest() { floor.isFixed = true; }

  std::vector<PlannedBody*> wake(double room) {
    std::vector<PlannedBody*> bodies;
    islands.wake(room, bodies);
    return bodies;
  }

  FakeBody a, b, c, d, e, floor;
  RestingIslands islands;
};

TEST_F(RestingIslandsTest, NobodyWakesWhoIsOwedNothing) {
  islands.add(a, b, 1.0, false);
  EXPECT_THAT(wake(100.0), IsEmpty());
  EXPECT_FALSE(islands.isWoken(a));
  EXPECT_FALSE(islands.isWoken(e)) << "it is not known";
}

TEST_F(RestingIslandsTest, AWholeIslandWakesHoweverItsPairsCameTogether) {
  islands.add(a, b, 1.0, false);
  islands.add(c, d, 1.0, true);
  islands.add(e, floor, 1.0, false);
  islands.add(d, a, 1.0, false);
  islands.add(b, d, 1.0, false);
  EXPECT_THAT(wake(4.0), UnorderedElementsAre(&a, &b, &c, &d));
  EXPECT_TRUE(islands.isWoken(b));
  EXPECT_FALSE(islands.isWoken(e));
}

TEST_F(RestingIslandsTest, AChainOfManyBodiesIsOneIsland) {
  constexpr int kMany = 20000;
  std::vector<std::unique_ptr<FakeBody>> chain;
  for (int i = 0; i < kMany; ++i) chain.push_back(std::make_unique<FakeBody>());
  // Numbered one way, joined the other.
  for (const auto& body : chain) islands.add(*body, floor, 0.0, false);
  for (std::size_t i = chain.size() - 1; i > 0; --i) islands.add(*chain[i], *chain[i - 1], 1.0, i == 1);
  EXPECT_THAT(wake(kMany - 2.0), IsEmpty());
  EXPECT_EQ(wake(kMany).size(), chain.size());
}

TEST_F(RestingIslandsTest, AFloorJoinsNobodyAndDoesNotWake) {
  islands.add(a, floor, 1.0, true);
  islands.add(floor, b, 1.0, false);
  islands.add(floor, floor, 1.0, true);
  EXPECT_THAT(wake(100.0), ElementsAre(&a));
}

TEST_F(RestingIslandsTest, IslandsWakeAsLongAsThereIsRoomForAllOfThem) {
  islands.add(a, floor, 3.0, true);
  islands.add(b, c, 2.0, false);
  islands.add(b, c, 3.0, true);
  islands.add(d, floor, 1.0, true);
  islands.add(d, floor, 1.0, false);
  EXPECT_THAT(wake(5.0), ElementsAre(&a, &d)) << "b and c would take 5 of the 2 that are left";
}

TEST_F(RestingIslandsTest, ClearedItKnowsNobody) {
  islands.add(a, b, 1.0, true);
  wake(100.0);
  islands.clear();
  EXPECT_FALSE(islands.isWoken(a));
  EXPECT_THAT(wake(100.0), IsEmpty());
}

}  // namespace
}  // namespace scatter::pairs
