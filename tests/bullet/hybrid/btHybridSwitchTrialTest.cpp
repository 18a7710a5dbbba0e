#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "SwitchTrial.h"

// A thousandth of what bench/switches does.

namespace scatter::test {
namespace {

#if defined(__SANITIZE_ADDRESS__) || !defined(NDEBUG)
constexpr std::uint64_t kTrials = 2;
#else
constexpr std::uint64_t kTrials = 12;
#endif

SwitchTally trials(Situation situation, btHybridSwitchingMode mode, std::uint64_t count,
                   bool safetyConditions) {
  SwitchTally all;
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    all += runSwitchTrial({.situation = situation,
                           .mode = mode,
                           .seed = 500 + seed,
                           .moments = 12,
                           .safetyConditions = safetyConditions});
  }
  return all;
}

class SwitchTrials : public testing::TestWithParam<std::tuple<Situation, btHybridSwitchingMode>> {};

TEST_P(SwitchTrials, PressMoveAndDriveNothing) {
  const auto [situation, mode] = GetParam();
  const SwitchTally all = trials(situation, mode, kTrials, true);
  EXPECT_TRUE(all.isClean()) << all.complaint;
  RecordProperty("switches", std::to_string(all.switches));
  // Bodies in contact hardly ever switch as a whole.
  const bool isFree = situation == Situation::kApart || situation == Situation::kMoving;
  const long least = mode == BT_HYBRID_PAIR_SWITCHING || isFree ? 5 * static_cast<long>(kTrials) : -1;
  EXPECT_GT(all.switches, least);
}

INSTANTIATE_TEST_SUITE_P(All, SwitchTrials,
                         testing::Combine(testing::ValuesIn(kSituations),
                                          testing::Values(BT_HYBRID_PAIR_SWITCHING,
                                                          BT_HYBRID_BODY_SWITCHING)),
                         [](const auto& one) {
                           const bool byPairs = std::get<1>(one.param) == BT_HYBRID_PAIR_SWITCHING;
                           return std::string(nameOf(std::get<0>(one.param))) +
                                  (byPairs ? "_pairs" : "_bodies");
                         });

/// The trials would see bad switches, and so would the world's own count.
TEST(SwitchTrialsWithoutSafety, PressAndGainEnergy) {
  const SwitchTally all = trials(Situation::kTouching, BT_HYBRID_PAIR_SWITCHING, 12, false);
  EXPECT_GT(all.unsafe, 60);
  EXPECT_GT(all.deeper, 60);
  EXPECT_GT(all.pushed, 0);
  EXPECT_GT(all.gained, 0);
}

}  // namespace
}  // namespace scatter::test
