#include <scatter/lab/contact_survey.h>

#include "lab/fake_physics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scatter {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;

RunOptions verifiedRun(std::string scene, int every, test::FakeBehaviour behaviour = {}) {
  RunOptions options = test::fakeRun(WorldKind::kHybrid, 12, behaviour);
  options.scene = std::move(scene);
  options.physics.collision.verifyEvery = every;
  return options;
}

TEST(ContactCheck, KeepsTheFirstMissedWithTheirFramesAndTheLatestSums) {
  ContactCheck check;
  ContactReport report{
      .steps = 1, .childPairs = 50, .expected = 20, .missed = 0, .extra = 2, .doubtful = 3, .lastMissed = {}};
  check.follow(4, report);
  EXPECT_TRUE(check.firstMissed.empty());
  report.missed = 30;
  report.lastMissed.assign(30, {.bodyA = "a", .bodyB = "b", .childA = 1, .childB = 2, .distance = 0.0F});
  check.follow(8, report);
  EXPECT_EQ(check.firstMissed.size(), ContactCheck::kMissesKept);
  EXPECT_EQ(check.firstMissed.front().frame, 8U);
  // The list of a step that was counted already is not taken in again.
  check.firstMissed.clear();
  check.follow(9, report);
  EXPECT_TRUE(check.firstMissed.empty());
  EXPECT_EQ(check.missed, 30U);
  EXPECT_EQ(check.expected, 20U);
  EXPECT_EQ(check.extra, 2U);
  EXPECT_EQ(check.doubtful, 3U);
}

TEST(SurveyContacts, AddsUpWhatBruteForceFoundInEachScene) {
  // Of 12 frames, those 3, 6, 9 and 12 are verified, or 5 and 10; the fake expects 10 contacts in each.
  const auto scenes = surveyContacts({verifiedRun("one", 3, {.missedStep = 6}), verifiedRun("two", 5)});
  ASSERT_TRUE(scenes);
  ASSERT_EQ(scenes->size(), 2U);
  EXPECT_EQ((*scenes)[0].check.steps, 4U);
  EXPECT_EQ((*scenes)[0].check.expected, 40U);
  EXPECT_EQ((*scenes)[0].check.missed, 3U);
  ASSERT_EQ((*scenes)[0].check.firstMissed.size(), 3U);
  EXPECT_EQ((*scenes)[0].check.firstMissed[2].frame, 6U);
  EXPECT_EQ((*scenes)[1].check.missed, 0U);
  const ContactCheck total = totalOf(*scenes);
  EXPECT_EQ(total.steps, 6U);
  EXPECT_EQ(total.childPairs, 600U);
  EXPECT_EQ(total.expected, 60U);
  EXPECT_EQ(total.missed, 3U);
  EXPECT_EQ(total.extra, 6U);
  EXPECT_EQ(total.doubtful, 12U);
}

TEST(SurveyContacts, FailsAsARunDoes) {
  EXPECT_THAT(surveyContacts({verifiedRun("one", 3, {.invalidStep = 2})}).error().message,
              HasSubstr("frame 2"));
}

TEST(FormatContacts, HasALineForEachSceneAndTheSum) {
  const auto scenes = surveyContacts({verifiedRun("one", 3, {.missedStep = 6}), verifiedRun("two", 5)});
  ASSERT_TRUE(scenes);
  const std::string table = formatContacts(*scenes);
  EXPECT_THAT(table, ContainsRegex("one +12 +4 +400 +40 +3 +4 +8 +10.00\n"));
  EXPECT_THAT(table, ContainsRegex("two +12 +2 +200 +20 +0 +2 +4 +10.00\n"));
  EXPECT_THAT(table, ContainsRegex("all +24 +6 +600 +60 +3 +6 +12 +10.00\n"));
  EXPECT_EQ(contactsCsv(*scenes),
            "scene,frames,frames_verified,child_pairs,expected,missed,extra,doubtful\n"
            "one,12,4,400,40,3,4,8\n"
            "two,12,2,200,20,0,2,4\n");
  // The fake misses part 5 of "left" and the only part of "right".
  EXPECT_THAT(formatMisses((*scenes)[0].check),
              HasSubstr("missed in frame 6: left part 5 and right, distance -0.5000 m\n"));
}

}  // namespace
}  // namespace scatter
