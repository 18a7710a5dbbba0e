#include <scatter/lab/run.h>

#include "lab/fake_physics.h"
#include "lab/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

namespace scatter {
namespace {

using test::contentOf;
using test::fakeRun;
using test::TemporaryFolder;
using testing::HasSubstr;
using testing::Not;

TEST(RunScene, UpdatesTheSceneBeforeEachOfItsFrames) {
  int updates = 0;
  RunOptions options = fakeRun(WorldKind::kHybrid, 5);
  options.makeScene = [&updates] { return std::make_unique<test::FakeScene>(&updates); };
  int called = 0;
  const auto run = runScene(options, [&](const RunProgress& progress) {
    EXPECT_EQ(progress.frame, ++called);
    EXPECT_EQ(progress.frames, 5);
    EXPECT_EQ(updates, called);
    EXPECT_GE(progress.seconds, 0.0);
  });
  ASSERT_TRUE(run);
  EXPECT_EQ(called, 5);
  EXPECT_EQ(run->table.frames(), 5U);
  EXPECT_EQ(run->options.label, "hybrid");
  EXPECT_EQ(run->summary.levelEvents[static_cast<std::size_t>(LevelEventKind::kSwitched)], 1U);
  EXPECT_EQ(run->summary.counter("switches_coarser").total, 1.0);
}

TEST(RunScene, WritesItsFolder) {
  TemporaryFolder folder;
  RunOptions options = fakeRun(WorldKind::kStandard, 3);
  options.out = folder.path() / "new" / "out";
  ASSERT_TRUE(runScene(options));
  const std::string csv = contentOf(*options.out / "frames.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 4);
  EXPECT_EQ(csv.rfind("frame,time_s,physics_ms,", 0), 0U);
  EXPECT_THAT(contentOf(*options.out / "summary.json"), HasSubstr("\"frames\": 3"));
  EXPECT_EQ(contentOf(*options.out / "events.csv"), "frame,kind,scope,policy,body,other,from,to,on_credit\n");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(*options.out), {}), 3);
}

TEST(RunScene, WritesEveryLevelEvent) {
  TemporaryFolder folder;
  RunOptions options = fakeRun(WorldKind::kHybrid, 3);
  options.out = folder.path();
  const auto run = runScene(options);
  ASSERT_TRUE(run);
  EXPECT_EQ(contentOf(folder.path() / "events.csv"),
            "frame,kind,scope,policy,body,other,from,to,on_credit\n"
            "2,requested,local,speed,0,0,0,0,0\n"
            "2,switched,global,governor,1,4,3,2,1\n");
  EXPECT_TRUE(run->events.empty());
  const auto& byPolicy = run->summary.levelEventsByPolicy;
  ASSERT_EQ(byPolicy.size(), 2U);
  EXPECT_EQ(byPolicy.at("governor")[static_cast<std::size_t>(LevelEventKind::kSwitched)], 1U);
  EXPECT_EQ(byPolicy.at("governor")[static_cast<std::size_t>(LevelEventKind::kRequested)], 0U);
  EXPECT_EQ(byPolicy.at("speed")[static_cast<std::size_t>(LevelEventKind::kRequested)], 1U);
}

TEST(RunScene, EndsWhereHandsCannotDoWhatTheyAreTold) {
  const TemporaryFolder folder;
  RunOptions options = fakeRun(WorldKind::kStandard, 8);
  options.out = folder.path();
  options.hands.add(2, RemoveAction{BodyId{99}});
  const auto run = runScene(options);
  ASSERT_FALSE(run);
  EXPECT_THAT(run.error().message, HasSubstr("what hands were to do cannot be done, frame 2: "));
  EXPECT_THAT(contentOf(folder.path() / "summary.json"), HasSubstr("frame 2: "));
}

TEST(RunScene, KeepsEventsIfAsked) {
  RunOptions options = fakeRun(WorldKind::kHybrid, 3);
  options.keepEvents = true;
  const auto run = runScene(options);
  ASSERT_TRUE(run);
  ASSERT_EQ(run->events.size(), 2U);
  EXPECT_EQ(run->events[1].frame, 2U);
  EXPECT_EQ(run->events[1].event.policy, "governor");
  TemporaryFolder folder;
  ASSERT_TRUE(writeEventCsv(folder.path() / "events.csv", run->events));
  EXPECT_THAT(contentOf(folder.path() / "events.csv"), HasSubstr("\n2,switched,global,governor,1,4,3,2,1\n"));
}

TEST(RunScene, ALostStateEndsTheRunAndKeepsWhatWasRecorded) {
  TemporaryFolder folder;
  RunOptions options = fakeRun(WorldKind::kStandard, 10, {.invalidStep = 4});
  options.out = folder.path();
  const auto run = runScene(options);
  ASSERT_FALSE(run);
  EXPECT_THAT(run.error().message, HasSubstr("'left'"));
  EXPECT_THAT(run.error().message, HasSubstr("frame 4"));
  EXPECT_THAT(run.error().message, Not(HasSubstr("\n")));
  const std::string csv = contentOf(folder.path() / "frames.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5);
  EXPECT_THAT(contentOf(folder.path() / "summary.json"), HasSubstr("\"stopped\""));
}

TEST(RunScene, RefusesWhatItCannotRunInOneLineAndWritesNothing) {
  TemporaryFolder folder;
  const RunOptions good = fakeRun(WorldKind::kStandard, 3);
  const auto expectRefused = [&](RunOptions options, const char* words) {
    options.out = folder.path() / "out";
    const auto run = runScene(options);
    ASSERT_FALSE(run) << words;
    EXPECT_THAT(run.error().message, HasSubstr(words));
    EXPECT_THAT(run.error().message, Not(HasSubstr("\n")));
    EXPECT_EQ(folder.entries(), 0U);
  };
  RunOptions unknown = good;
  unknown.makeScene = nullptr;
  unknown.scene = "no-such-scene";
  expectRefused(unknown, "no-such-scene");
  RunOptions frames = good;
  frames.frames = -1;
  expectRefused(frames, "at least one frame");
  RunOptions label = good;
  label.label = "../up";
  expectRefused(label, "'../up'");
  RunOptions budget = good;
  budget.budgetMs = 0.0;
  expectRefused(budget, "budget");
  RunOptions fidelity = good;
  fidelity.fidelityEvery = -1;
  expectRefused(fidelity, "every -1 frames");
  RunOptions engine = good;
  engine.engine = nullptr;
  expectRefused(engine, "engine");
  RunOptions broken = good;
  broken.engine = [](const PhysicsDef&) -> Result<std::unique_ptr<Physics>> {
    return fail("engine is out of order");
  };
  expectRefused(broken, "out of order");
}

TEST(RunScene, RefusesAFolderThatCannotBeWrittenBeforeTheFirstFrame) {
  TemporaryFolder folder;
  std::ofstream(folder.path() / "plain") << "x";
  RunOptions options = fakeRun(WorldKind::kStandard, 3);
  options.out = folder.path() / "plain" / "out";
  int frames = 0;
  const auto run = runScene(options, [&](const RunProgress&) { ++frames; });
  ASSERT_FALSE(run);
  EXPECT_THAT(run.error().message, HasSubstr("not a folder"));
  EXPECT_EQ(frames, 0);
}

TEST(RunScene, ShowsTheWorldAfterTheLastFrame) {
  RunOptions options = fakeRun(WorldKind::kStandard, 6);
  std::uint64_t frame = 0;
  options.inspect = [&frame](const World& world) { frame = world.frame(); };
  ASSERT_TRUE(runScene(options));
  EXPECT_EQ(frame, 6U);
}

TEST(RunScene, SameSeedSameHashes) {
  const auto a = runScene(fakeRun(WorldKind::kHybrid, 20));
  const auto b = runScene(fakeRun(WorldKind::kHybrid, 20));
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->table.hashes("state_hash"), b->table.hashes("state_hash"));
}

}  // namespace
}  // namespace scatter
