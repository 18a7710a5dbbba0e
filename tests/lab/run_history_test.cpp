#include <scatter/lab/run_history.h>

#include "lab/play_scene.h"
#include "lab/temporary_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

namespace scatter {
namespace {

using test::makeExperiment;
using test::object;

struct Seen {
  std::vector<BodyId> bodies;
  std::vector<BodyState> states;
  std::vector<int> levels;
  std::vector<LevelEvent> events;
};

Seen look(const World& world) {
  Seen seen;
  for (const auto& item : world.objects()) {
    seen.bodies.push_back(item->body());
    seen.states.push_back(item->state());
    seen.levels.push_back(world.physics().switching().level(item->body()));
  }
  const auto events = world.physics().switching().levelEvents();
  seen.events.assign(events.begin(), events.end());
  return seen;
}

void expectSame(const RunHistory::Frame& frame, const Seen& seen) {
  ASSERT_EQ(std::vector(frame.bodies().begin(), frame.bodies().end()), seen.bodies);
  for (std::size_t i = 0; i < seen.bodies.size(); ++i) {
    EXPECT_EQ(frame.find(seen.bodies[i]), i);
    EXPECT_LT(glm::distance(frame.pose(i).position, seen.states[i].pose.position), kRecordedMetres);
    EXPECT_GT(std::abs(glm::dot(frame.pose(i).rotation, seen.states[i].pose.rotation)), 1.0F - 1e-6F);
    EXPECT_EQ(frame.asleep(i), seen.states[i].asleep);
    EXPECT_EQ(frame.level(i), seen.levels[i]);
  }
  ASSERT_EQ(frame.events().size(), seen.events.size());
  for (std::size_t i = 0; i < seen.events.size(); ++i) {
    const LevelEvent& event = frame.events()[i];
    EXPECT_EQ(event.kind, seen.events[i].kind);
    EXPECT_EQ(event.scope, seen.events[i].scope);
    EXPECT_EQ(event.body, seen.events[i].body);
    EXPECT_EQ(event.other, seen.events[i].other);
    EXPECT_EQ(event.from, seen.events[i].from);
    EXPECT_EQ(event.to, seen.events[i].to);
    EXPECT_EQ(event.onCredit, seen.events[i].onCredit);
    EXPECT_EQ(event.policy, seen.events[i].policy);
  }
}

TEST(RunHistory, GivesBackEveryFrame) {
  RunOptions options = test::playRun(WorldKind::kHybrid, true);
  options.physics.switching.switching = Switching::kBody;
  const auto experiment = makeExperiment({.run = options, .history = {.blockFrames = 16}});
  std::vector<Seen> seen{look(experiment->world())};
  std::size_t events = 0;
  std::size_t sleepers = 0;
  for (int frame = 1; frame <= 200; ++frame) {
    if (frame == 100) experiment->hands().requestLevel({}, 1, Scope::kGlobal);
    if (frame == 120) {
      ASSERT_TRUE(
          experiment->hands().spawnLike(object(*experiment, "plank").body(), {Vec3(0.0F, 4.0F, 0.0F)}));
    }
    if (frame == 150) {
      ASSERT_TRUE(experiment->hands().remove(object(*experiment, "crate-2").body()));
    }
    test::run(*experiment, 1);
    seen.push_back(look(experiment->world()));
    events += seen.back().events.size();
    for (const BodyState& state : seen.back().states) sleepers += state.asleep ? 1U : 0U;
  }
  EXPECT_GT(events, 5U);
  EXPECT_GT(sleepers, 0U);
  const RunHistory& history = experiment->history();
  EXPECT_EQ(history.oldest(), 0U);
  EXPECT_EQ(history.newest(), 200U);
  for (std::size_t frame = seen.size(); frame-- > 0;) {
    SCOPED_TRACE(frame);
    EXPECT_EQ(history.frame(frame).number(), frame);
    expectSame(history.frame(frame), seen[frame]);
  }
}

TEST(RunHistory, KnowsWhatBodiesWereMadeFromUntilNoFrameNamesThem) {
  const auto experiment =
      makeExperiment({.run = test::playRun(WorldKind::kStandard, false), .history = {.blockFrames = 4}});
  test::run(*experiment, 3);
  const BodyId gone = object(*experiment, "crate-3").body();
  ASSERT_TRUE(experiment->hands().remove(gone));
  test::run(*experiment, 2);
  RunHistory& history = experiment->history();
  ASSERT_NE(history.def(gone), nullptr);
  EXPECT_EQ(history.def(gone)->name, "crate-3");
  EXPECT_EQ(history.frame(3).bodies().size(), 6U);
  EXPECT_EQ(history.frame(4).bodies().size(), 5U);
  EXPECT_FALSE(history.frame(4).find(gone));
  history.setBytes(0);
  EXPECT_EQ(history.oldest(), 4U);
  EXPECT_EQ(history.def(gone), nullptr);
  EXPECT_NE(history.def(object(*experiment, "crate-1").body()), nullptr);
}

TEST(RunHistory, StaysWithinItsBytesAndKeepsTheNewestFrames) {
  constexpr std::uint64_t kBytes = 20000;
  const auto experiment = makeExperiment(
      {.run = test::playRun(WorldKind::kStandard, false), .history = {.bytes = kBytes, .blockFrames = 10}});
  object(*experiment, "plank").setVelocity(Vec3(6.0F, 0.0F, 0.0F), Vec3(0.0F));
  std::vector<Vec3> path{object(*experiment, "plank").state().pose.position};
  for (int frame = 1; frame <= 300; ++frame) {
    test::run(*experiment, 1);
    path.push_back(object(*experiment, "plank").state().pose.position);
    EXPECT_LE(experiment->history().bytes(), kBytes);
  }
  const RunHistory& history = experiment->history();
  EXPECT_EQ(history.newest(), 300U);
  EXPECT_GT(history.size(), 30U);
  EXPECT_LT(history.size(), 200U);
  EXPECT_EQ(history.oldest(), 301U - history.size());
  EXPECT_FALSE(history.has(history.oldest() - 1));
  for (std::uint64_t frame = history.oldest(); frame <= history.newest(); ++frame) {
    const auto view = history.frame(frame);
    const Vec3 position = view.pose(*view.find(object(*experiment, "plank").body())).position;
    EXPECT_LT(glm::distance(position, path[frame]), kRecordedMetres);
  }
}

TEST(RunHistory, StartsAnewWhenItIsCleared) {
  const auto experiment = test::play(WorldKind::kStandard, false);
  test::run(*experiment, 300);
  RunHistory& history = experiment->history();
  EXPECT_GT(history.bytes(), 100U);
  history.clear();
  EXPECT_TRUE(history.empty());
  EXPECT_EQ(history.size(), 0U);
  EXPECT_EQ(history.bytes(), 0U);
  test::run(*experiment, 3);
  EXPECT_EQ(history.oldest(), 301U);
  EXPECT_EQ(history.newest(), 303U);
}

// Where nothing can be written, frames are kept in memory.
TEST(RunHistory, NeedsNoDisk) {
  const char* before = std::getenv("TMPDIR");
  const std::string folder = before == nullptr ? "" : before;
  setenv("TMPDIR", "/nowhere", 1);
  const auto experiment =
      makeExperiment({.run = test::playRun(WorldKind::kStandard, false), .history = {.blockFrames = 10}});
  test::run(*experiment, 100);
  folder.empty() ? unsetenv("TMPDIR") : setenv("TMPDIR", folder.c_str(), 1);
  for (std::uint64_t frame = 0; frame <= 100; ++frame) {
    EXPECT_EQ(experiment->history().frame(frame).number(), frame);
  }
}

TEST(RunHistory, ARecordingThatIsStartedLateHasTheFramesBeforeAndIsReplayed) {
  const test::TemporaryFolder folder;
  const auto experiment =
      makeExperiment({.run = test::playRun(WorldKind::kHybrid, true), .history = {.blockFrames = 10}});
  test::run(*experiment, 33);
  ASSERT_TRUE(experiment->startRecording(folder.path() / "late.rec"));
  EXPECT_TRUE(experiment->history().isRecording());
  test::run(*experiment, 22);
  // A program that is killed now leaves the blocks that are whole.
  const auto killed = RunHistory::open(folder.path() / "late.rec");
  ASSERT_TRUE(killed) << killed.error().message;
  EXPECT_EQ((*killed)->newest(), 49U);
  const auto stopped = experiment->history().stopRecording();
  ASSERT_TRUE(stopped) << stopped.error().message;
  EXPECT_FALSE(experiment->history().isRecording());
  test::run(*experiment, 5);
  const auto replayed = RunHistory::open(folder.path() / "late.rec").value();
  EXPECT_EQ(replayed->oldest(), 0U);
  EXPECT_EQ(replayed->newest(), 55U);
  for (std::uint64_t number = 0; number <= 55; ++number) {
    const auto then = experiment->history().frame(number);
    const auto frame = replayed->frame(number);
    ASSERT_TRUE(
        std::equal(frame.bodies().begin(), frame.bodies().end(), then.bodies().begin(), then.bodies().end()));
    for (std::size_t i = 0; i < frame.bodies().size(); ++i) {
      EXPECT_LT(glm::distance(frame.pose(i).position, then.pose(i).position), 2.0F * kRecordedMetres);
    }
  }
  EXPECT_EQ(replayed->def(BodyId{1})->name, experiment->history().def(BodyId{1})->name);
}

TEST(RunHistory, KeepsPairsIfAsked) {
  const auto experiment =
      makeExperiment({.run = test::playRun(WorldKind::kHybrid, true), .history = {.pairLevels = true}});
  test::run(*experiment, 5);
  const auto frame = experiment->history().frame(5);
  ASSERT_EQ(frame.pairs().size(), 5U);
  const PairLevel pair = frame.pairs()[0];
  EXPECT_EQ(pair.level, experiment->world().physics().switching().pairLevel(pair.a, pair.b));
}

}  // namespace
}  // namespace scatter
