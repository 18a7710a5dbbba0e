#include <gtest/gtest.h>
#include <scatter/bullet/contact_trials.h>

#include <algorithm>

namespace scatter::test {
namespace {

#if defined(__SANITIZE_ADDRESS__) || !defined(NDEBUG)
constexpr std::uint64_t kSeeds = 1;
#else
constexpr std::uint64_t kSeeds = 2;
#endif

// From the first seeds the pair algorithm has learned; nobody has looked at those from the thousandth on.
constexpr std::uint64_t kFirstSeeds[] = {0, 1000};

class ContactTrials : public testing::TestWithParam<std::string> {};

TEST_P(ContactTrials, HybridsHaveTheContactsOfTheEngine) {
  for (const std::uint64_t first : kFirstSeeds) {
    ContactTrial all;
    for (std::uint64_t seed = first; seed < first + kSeeds; ++seed) {
      const ContactTrial trial = runContactTrial(GetParam(), seed);
      EXPECT_EQ(trial.missed, 0U) << "seed " << seed << ", of " << trial.expected;
      EXPECT_EQ(trial.extra, 0U) << "seed " << seed << ", of " << trial.expected;
      all += trial;
    }
    EXPECT_LE(all.doubtful * 10000, all.expected);
  }
}

std::string identifier(const testing::TestParamInfo<std::string>& shape) {
  std::string name = shape.param;
  std::erase_if(name, [](char c) { return c == ' ' || c == '-'; });
  return name;
}

INSTANTIATE_TEST_SUITE_P(Shapes, ContactTrials, testing::ValuesIn(contactTrialShapes()), identifier);

TEST(ContactTrialWorlds, AreTheSameAgainAndNotEmpty) {
  std::uint64_t expected = 0;
  for (const std::string& shape : contactTrialShapes()) expected += runContactTrial(shape, 2).expected;
  EXPECT_GT(expected, 20000U);
  const ContactTrial one = runContactTrial("hull", 3);
  const ContactTrial same = runContactTrial("hull", 3);
  EXPECT_EQ(one.childPairs, same.childPairs);
  EXPECT_EQ(one.expected, same.expected);
}

}  // namespace
}  // namespace scatter::test
