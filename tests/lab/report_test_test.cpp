// The story of the report's section 5.1.5, told by real runs.

#include <scatter/lab/report_test.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <scatter/bullet/bullet_physics.h>

#include <algorithm>
#include <map>

#include "lab/temporary_folder.h"

namespace scatter {
namespace {

using test::TemporaryFolder;
using testing::HasSubstr;

class ReportTests : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder();
    tests_ = new std::map<int, ReportTest>();
    for (int number = 1; number <= kReportTests; ++number) {
      auto test = runReportTest(number, engine(), folder_->path() / ("test-" + std::to_string(number)));
      ASSERT_TRUE(test) << test.error().message;
      tests_->emplace(number, std::move(*test));
    }
  }
  static void TearDownTestSuite() {
    delete tests_;
    delete folder_;
    tests_ = nullptr;
    folder_ = nullptr;
  }

  static EngineFactory engine() {
    return [](const PhysicsDef& def) -> Result<std::unique_ptr<Physics>> { return makeBulletPhysics(def); };
  }
  static const ReportTest& of(int number) { return tests_->at(number); }

  static double measure(int number, const std::string& name) {
    for (const ReportMeasure& measure : of(number).measures) {
      if (measure.name == name) return measure.ours;
    }
    ADD_FAILURE() << "no measure " << name;
    return -1.0;
  }

  /// The frames of a ship's events of one kind. Hunters come before Fighters, and ids count from 1.
  static std::vector<std::uint64_t> framesOf(int number, LevelEventKind kind, std::uint32_t body) {
    std::vector<std::uint64_t> frames;
    for (const FrameEvent& event : of(number).run.events) {
      if (event.event.kind == kind && event.event.body == BodyId{body}) frames.push_back(event.frame);
    }
    return frames;
  }

  static const std::filesystem::path& folder() { return folder_->path(); }

 private:
  static inline TemporaryFolder* folder_ = nullptr;
  static inline std::map<int, ReportTest>* tests_ = nullptr;
};

TEST_F(ReportTests, RunAsLongAsTheReports) {
  EXPECT_EQ(of(1).run.table.frames(), 1300U);
  EXPECT_EQ(of(2).run.table.frames(), 1300U);
  EXPECT_EQ(of(3).run.table.frames(), 1600U);
  EXPECT_EQ(of(4).run.table.frames(), 1600U);
}

TEST_F(ReportTests, TheDefaultBuildIsPlainAndHasNoEvents) {
  for (const int number : {1, 3}) {
    EXPECT_EQ(of(number).run.options.physics.world, WorldKind::kStandard);
    EXPECT_THAT(of(number).run.events, testing::IsEmpty());
  }
}

TEST_F(ReportTests, BothShipsAskAtTheOverlapAndOnlyTheHunterSwitchesAtOnce) {
  const auto hunterAsks = framesOf(2, LevelEventKind::kRequested, 1);
  ASSERT_EQ(hunterAsks.size(), 1U);
  EXPECT_EQ(framesOf(2, LevelEventKind::kRequested, 2), hunterAsks);
  EXPECT_EQ(static_cast<double>(hunterAsks[0]), measure(2, "bounds overlap, frame") + 1.0);
  EXPECT_EQ(framesOf(2, LevelEventKind::kSwitched, 1), hunterAsks);
  EXPECT_THAT(framesOf(2, LevelEventKind::kAcknowledged, 2), testing::ElementsAre(hunterAsks[0]));
  EXPECT_EQ(framesOf(2, LevelEventKind::kBlocked, 2).at(0), hunterAsks[0]);
}

TEST_F(ReportTests, TheFighterSwitchesAfterTheCollisionAndBeforeTheSecondOne) {
  const auto switched = framesOf(2, LevelEventKind::kSwitched, 2);
  ASSERT_EQ(switched.size(), 1U);
  EXPECT_GT(static_cast<double>(switched[0]), measure(2, "first contact, frame"));
  EXPECT_LT(static_cast<double>(switched[0]), measure(2, "bounds overlap again, frame"));
  EXPECT_THAT(framesOf(2, LevelEventKind::kRetracted, 2), testing::IsEmpty());
}

TEST_F(ReportTests, TheSecondMeetingHasFarFewerPartPairsAndManifolds) {
  EXPECT_EQ(measure(1, "box pairs when they overlap again"), 18.0 * 22.0);
  EXPECT_EQ(measure(2, "box pairs when they overlap again"), 8.0 * 8.0);
  EXPECT_LT(measure(2, "most manifolds, second meeting"), 0.6 * measure(1, "most manifolds, second meeting"));
}

TEST_F(ReportTests, TriesAddNoObjects) {
  for (const int number : {1, 2}) EXPECT_EQ(measure(number, "objects at most"), 2.0);
  for (const int number : {3, 4}) EXPECT_EQ(measure(number, "objects at most"), 31.0);
}

TEST_F(ReportTests, TheCrowdSwitchesBeforeThePeakAndWhileItDisperses) {
  EXPECT_GT(measure(4, "switches up to the peak"), 0.0);
  EXPECT_GT(measure(4, "switches until frame 550"), 0.0);
  EXPECT_GT(measure(4, "tries that failed"), 0.0);
  EXPECT_GT(measure(4, "most requests that wait"), 0.0);
  EXPECT_LT(measure(4, "manifolds, most of the run"), 0.5 * measure(3, "manifolds, most of the run"));
}

TEST_F(ReportTests, RequestsThatWaitAreRetractedWhenTheLoadIsFine) {
  std::size_t retracted = 0;
  const auto& pairs = of(4).run.table.values("narrowphase_pairs");
  for (const FrameEvent& event : of(4).run.events) {
    if (event.event.kind == LevelEventKind::kRetracted && pairs.at(event.frame - 2) < 50.0) ++retracted;
  }
  EXPECT_GT(retracted, 1U);
  EXPECT_EQ(measure(4, "retracted since the load is fine"), static_cast<double>(retracted));
}

TEST_F(ReportTests, TheStoryIsToldByFrame) {
  for (int number = 1; number <= kReportTests; ++number) {
    const auto& story = of(number).story;
    EXPECT_TRUE(std::is_sorted(story.begin(), story.end(),
                               [](const StoryLine& a, const StoryLine& b) { return a.frame < b.frame; }));
    for (const StoryLine& line : story) {
      EXPECT_THAT(formatReportTest(of(number)), HasSubstr(std::to_string(line.frame) + "  "));
    }
  }
}

TEST_F(ReportTests, LeaveTheirFilesAndTheReportsFigures) {
  ASSERT_TRUE(drawReportFigures({&of(1), &of(2)}, folder() / "figures"));
  ASSERT_TRUE(drawReportFigures({&of(4)}, folder() / "figures"));
  for (const char* name :
       {"test-2/frames.csv", "test-2/events.csv", "test-2/summary.json", "figures/fig-5-05.png",
        "figures/fig-5-06.svg", "figures/fig-5-07.svg", "figures/fig-5-08.png", "figures/fig-5-09.svg",
        "figures/fig-5-10.svg", "figures/fig-5-11.png"}) {
    EXPECT_GT(std::filesystem::file_size(folder() / name), 100U) << name;
  }
}

TEST_F(ReportTests, OthersAreRefused) {
  for (const int number : {-1, 0, 5}) {
    const auto test = runReportTest(number, engine(), folder() / "none");
    ASSERT_FALSE(test);
    EXPECT_THAT(test.error().message, HasSubstr("give 1 to 4"));
  }
  EXPECT_FALSE(std::filesystem::exists(folder() / "none"));
  EXPECT_FALSE(drawReportFigures({}, folder() / "none"));
}

}  // namespace
}  // namespace scatter
