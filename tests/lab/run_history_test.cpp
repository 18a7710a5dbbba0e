#include <scatter/lab/run_history.h>

#include "lab/play_scene.h"

#include <gtest/gtest.h>

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
    EXPECT_EQ(frame.pose(i).position, seen.states[i].pose.position);
    EXPECT_EQ(frame.pose(i).rotation, seen.states[i].pose.rotation);
    EXPECT_EQ(frame.asleep(i), seen.states[i].asleep);
    EXPECT_EQ(frame.level(i), seen.levels[i]);
  }
  ASSERT_EQ(frame.eventCount(), seen.events.size());
  for (std::size_t i = 0; i < seen.events.size(); ++i) {
    const LevelEvent event = frame.event(i);
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

TEST(RunHistory, GivesBackEveryFrameExactly) {
  RunOptions options = test::playRun(WorldKind::kHybrid, true);
  options.physics.switching.switching = Switching::kBody;
  const auto experiment = makeExperiment({.run = options});
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
  for (std::size_t frame = 0; frame < seen.size(); ++frame) {
    SCOPED_TRACE(frame);
    EXPECT_EQ(history.frame(frame).number(), frame);
    expectSame(history.frame(frame), seen[frame]);
  }
}

TEST(RunHistory, KnowsWhatBodiesWereMadeFromUntilNoFrameNamesThem) {
  const auto experiment = test::play(WorldKind::kStandard, false);
  test::run(*experiment, 3);
  const BodyId gone = object(*experiment, "crate-3").body();
  ASSERT_TRUE(experiment->hands().remove(gone));
  test::run(*experiment, 1);
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
  constexpr std::size_t kBytes = 20000;
  const auto experiment =
      makeExperiment({.run = test::playRun(WorldKind::kStandard, false), .history = {.bytes = kBytes}});
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
    EXPECT_EQ(view.pose(*view.find(object(*experiment, "plank").body())).position, path[frame]);
  }
}

TEST(RunHistory, AccountsForAllThatItKeeps) {
  const auto experiment = test::play(WorldKind::kStandard, false);
  RunHistory& history = experiment->history();
  const std::size_t one = history.bytes();
  for (int i = 0; i < 40; ++i) {
    const auto copy = experiment->hands().spawnLike(object(*experiment, "plank").body(),
                                                    {Vec3(0.0F, 10.0F + static_cast<float>(i), 0.0F)});
    ASSERT_TRUE(copy);
    test::run(*experiment, 1);
    ASSERT_TRUE(experiment->hands().remove((*copy)->body()));
  }
  test::run(*experiment, 1);
  EXPECT_GT(history.bytes(), 10 * one);
  history.setBytes(0);
  EXPECT_EQ(history.size(), 1U);
  EXPECT_EQ(history.bytes(), one);
  history.clear();
  EXPECT_TRUE(history.empty());
  EXPECT_EQ(history.bytes(), 0U);
}

TEST(RunHistory, ThreeHundredBodiesTakeAsMuchAsItsDocumentationSays) {
  World world(makeBulletPhysics({}));
  for (int i = 0; i < 300; ++i) {
    BodyDef def;
    def.pose.position.x = 3.0F * static_cast<float>(i);
    ASSERT_TRUE(world.add(def));
  }
  RunHistory history;
  history.record(world);
  const std::size_t first = history.bytes();
  for (int i = 0; i < 10; ++i) {
    world.step(1.0F / 60.0F);
    history.record(world);
  }
  const std::size_t frame = (history.bytes() - first) / 10;
  EXPECT_NEAR(static_cast<double>(HistoryDef{}.bytes / frame), 30000.0, 1000.0);
}

TEST(RunHistory, KeepsPairsIfAsked) {
  const auto experiment =
      makeExperiment({.run = test::playRun(WorldKind::kHybrid, true), .history = {.pairLevels = true}});
  test::run(*experiment, 5);
  const auto frame = experiment->history().frame(5);
  ASSERT_EQ(frame.pairCount(), 5U);
  const PairLevel pair = frame.pair(0);
  EXPECT_EQ(pair.level, experiment->world().physics().switching().pairLevel(pair.a, pair.b));
}

}  // namespace
}  // namespace scatter
