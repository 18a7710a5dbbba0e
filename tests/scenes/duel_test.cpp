// The story of the report's section 5.1.5.1, told by counters and events.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "scenes/scene_world.h"

namespace scatter::test {
namespace {

constexpr int kDuelFrames = 1300;

struct DuelLog {
  struct Entry {
    int frame;
    LevelEvent event;
  };
  std::vector<Entry> events;
  std::vector<StepCounters> counters;
  std::vector<int> hunterLevel;
  std::vector<int> fighterLevel;
  std::vector<double> kineticEnergy;
  int hunterLevels = 0;

  /// The first frame from `start` on in which the ships have a contact point.
  [[nodiscard]] int firstContact(int start) const {
    for (int i = start; i < kDuelFrames; ++i) {
      if (counters[static_cast<std::size_t>(i)].contacts > 0) return i;
    }
    return kDuelFrames;
  }

  /// The first frame from `start` on in which the ships' bounds do not overlap.
  [[nodiscard]] int firstApart(int start) const {
    for (int i = start; i < kDuelFrames; ++i) {
      if (counters[static_cast<std::size_t>(i)].overlappingPairs == 0) return i;
    }
    return kDuelFrames;
  }

  [[nodiscard]] std::uint32_t peakManifolds(int from, int to) const {
    std::uint32_t peak = 0;
    for (int i = from; i < to; ++i) peak = std::max(peak, counters[static_cast<std::size_t>(i)].manifolds);
    return peak;
  }
};

DuelLog runDuel(WorldKind kind) {
  SceneWorld scene("duel", kind);
  const auto* hunter = dynamic_cast<HybridObject*>(scene.world.find("hunter"));
  const auto* fighter = dynamic_cast<HybridObject*>(scene.world.find("fighter"));
  EXPECT_NE(hunter, nullptr);
  EXPECT_NE(fighter, nullptr);
  DuelLog log;
  log.hunterLevels = hunter->levelCount();
  for (int i = 0; i < kDuelFrames; ++i) {
    log.hunterLevel.push_back(hunter->level());
    log.fighterLevel.push_back(fighter->level());
    scene.step();
    log.counters.push_back(scene.counters());
    log.kineticEnergy.push_back(scene.world.physics().kineticEnergy());
    for (const LevelEvent& event : scene.world.physics().switching().levelEvents())
      log.events.push_back({i, event});
  }
  return log;
}

class Duel : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    standard_ = new DuelLog(runDuel(WorldKind::kStandard));
    hybrid_ = new DuelLog(runDuel(WorldKind::kHybrid));
  }
  static void TearDownTestSuite() {
    delete standard_;
    delete hybrid_;
    standard_ = hybrid_ = nullptr;
  }

  static const DuelLog& standard() { return *standard_; }
  static const DuelLog& hybrid() { return *hybrid_; }

  /// The frame in which the ships' coarse bounds first overlap.
  static int overlap() {
    int frame = 0;
    while (hybrid().counters[static_cast<std::size_t>(frame)].overlappingPairs == 0) ++frame;
    return frame;
  }

 private:
  static inline DuelLog* standard_ = nullptr;
  static inline DuelLog* hybrid_ = nullptr;
};

TEST_F(Duel, TheStandardWorldIsAlwaysAtTheFinestLevelAndHasNoEvents) {
  EXPECT_EQ(standard().hunterLevels, 3);
  EXPECT_THAT(standard().events, testing::IsEmpty());
  EXPECT_THAT(standard().hunterLevel, testing::Each(3));
}

TEST_F(Duel, BothShipsAreAtTheFinestLevelUntilRequestsComeJustBeforeTheBoundsOverlap) {
  ASSERT_THAT(hybrid().events, testing::Not(testing::IsEmpty()));
  const int request = hybrid().events.front().frame;
  EXPECT_EQ(hybrid().events.front().event.kind, LevelEventKind::kRequested);
  for (int i = 0; i <= request; ++i) {
    ASSERT_EQ(hybrid().hunterLevel[static_cast<std::size_t>(i)], 3) << "frame " << i;
    ASSERT_EQ(hybrid().fighterLevel[static_cast<std::size_t>(i)], 3) << "frame " << i;
  }
  // The margin is three steps of travel at the ships' speed; they still gain a little.
  EXPECT_LE(request, overlap());
  EXPECT_GE(request, overlap() - 5);
}

TEST_F(Duel, EveryRequestSwitchesWithinThreeFramesOrIsAcknowledgedAndRetriedUntilItEnds) {
  struct Standing {
    int since;
    bool acknowledged;
    int lastTry;
  };
  std::map<BodyId, Standing> standing;
  int switches = 0;
  for (const DuelLog::Entry& entry : hybrid().events) {
    const BodyId body = entry.event.body;
    switch (entry.event.kind) {
      case LevelEventKind::kRequested:
        standing[body] = {entry.frame, false, entry.frame};
        break;
      case LevelEventKind::kAcknowledged:
        ASSERT_TRUE(standing.contains(body));
        EXPECT_LE(entry.frame - standing[body].since, 3);
        standing[body].acknowledged = true;
        break;
      case LevelEventKind::kBlocked:
        ASSERT_TRUE(standing.contains(body));
        EXPECT_TRUE(standing[body].acknowledged);
        EXPECT_LE(entry.frame - standing[body].lastTry, SwitchingDef{}.retryInterval);
        standing[body].lastTry = entry.frame;
        break;
      case LevelEventKind::kSwitched:
        ++switches;
        ASSERT_TRUE(standing.contains(body));
        EXPECT_TRUE(entry.frame - standing[body].since <= 3 ||
                    entry.frame - standing[body].lastTry <= SwitchingDef{}.retryInterval);
        standing[body].lastTry = entry.frame;
        break;
      case LevelEventKind::kRetracted:
        standing.erase(body);
        break;
    }
  }
  EXPECT_GE(switches, 2);
}

TEST_F(Duel, BothShipsAreCoarseWhenTheyFirstTouch) {
  const auto contact = static_cast<std::size_t>(hybrid().firstContact(0));
  ASSERT_LT(contact, hybrid().hunterLevel.size());
  EXPECT_EQ(hybrid().hunterLevel[contact], 1);
  EXPECT_EQ(hybrid().fighterLevel[contact], 1);
}

TEST_F(Duel, TheShipsCollidePartAndMeetAgain) {
  for (const DuelLog* log : {&standard(), &hybrid()}) {
    const int first = log->firstContact(0);
    const int apart = log->firstApart(first);
    ASSERT_LT(apart, kDuelFrames) << "the bounds never part after the first collision";
    EXPECT_LT(log->firstContact(apart), kDuelFrames) << "no second contact";
  }
}

TEST_F(Duel, TheSecondContactNeedsFarFewerManifoldsThanInTheStandardWorld) {
  auto atSecondContact = [](const DuelLog& log) {
    const int second = log.firstContact(log.firstApart(log.firstContact(0)));
    return log.peakManifolds(second, kDuelFrames);
  };
  EXPECT_GE(atSecondContact(standard()), 8U);
  EXPECT_LE(atSecondContact(hybrid()) * 4, atSecondContact(standard()));
}

TEST_F(Duel, TheShipsEndInASlowRotation) {
  for (const DuelLog* log : {&standard(), &hybrid()}) {
    const double peak = *std::max_element(log->kineticEnergy.begin(), log->kineticEnergy.end());
    EXPECT_LT(log->kineticEnergy.back(), 0.02 * peak);
    EXPECT_GT(log->counters.back().contacts, 0U);
  }
}

}  // namespace
}  // namespace scatter::test
