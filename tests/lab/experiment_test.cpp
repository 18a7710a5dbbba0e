#include <scatter/lab/experiment.h>
#include <scatter/lab/figures.h>

#include "lab/fake_physics.h"
#include "lab/play_scene.h"
#include "lab/temporary_folder.h"
#include "trials.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <ostream>

namespace scatter {
namespace {

using test::contentOf;
using test::fakeRun;
using test::makeExperiment;
using test::TemporaryFolder;
using testing::HasSubstr;
using testing::Not;

struct Played {
  const char* name;
  const char* scene;
  PhysicsDef physics;
};

void PrintTo(const Played& played, std::ostream* out) {
  *out << played.name;
}

PhysicsDef hybridWorld(Switching switching, double units) {
  PhysicsDef def;
  def.world = WorldKind::kHybrid;
  def.switching.switching = switching;
  def.switching.policy = switching == Switching::kBody ? Policy::kProximity : Policy::kNone;
  def.switching.budget.units = units;
  return def;
}

RunOptions runOf(const Played& played, int frames) {
  RunOptions options;
  options.scene = played.scene;
  options.engine = [](const PhysicsDef& def) -> Result<std::unique_ptr<Physics>> {
    return makeBulletPhysics(def);
  };
  options.physics = played.physics;
  options.frames = frames;
  options.keepEvents = true;
  return options;
}

class PlayedScene : public testing::TestWithParam<Played> {};

TEST_P(PlayedScene, HasTheHashesAndEventsOfARun) {
  constexpr int kFrames = test::kSanitized ? 60 : 150;
  const auto run = runScene(runOf(GetParam(), kFrames));
  ASSERT_TRUE(run) << run.error().message;
  const auto experiment = makeExperiment({.run = runOf(GetParam(), 0), .history = {.pairLevels = true}});
  for (int frame = 0; frame < kFrames; ++frame) {
    ASSERT_TRUE(experiment->step());
    (void)experiment->hands().pick(Vec3(0.0F, 50.0F, 0.0F), Vec3(0.0F, -50.0F, 0.0F));
  }
  EXPECT_EQ(experiment->table().hashes("state_hash"), run->table.hashes("state_hash"));
  ASSERT_EQ(experiment->events().size(), run->events.size());
  EXPECT_EQ(experiment->levelEvents(), run->summary.levelEvents);
  EXPECT_EQ(static_cast<double>(experiment->switches().coarser),
            run->summary.counter("switches_coarser").total);
  EXPECT_EQ(static_cast<double>(experiment->switches().finer), run->summary.counter("switches_finer").total);
}

INSTANTIATE_TEST_SUITE_P(
    Worlds, PlayedScene,
    testing::Values(Played{"tower_standard", "tower", {}},
                    Played{"convergence_pair", "convergence", hybridWorld(Switching::kPair, 400.0)},
                    Played{"convergence_body", "convergence", hybridWorld(Switching::kBody, 0.0)},
                    Played{"breakables_pair", "breakables", hybridWorld(Switching::kPair, 600.0)},
                    Played{"telekinesis_pair", "telekinesis", hybridWorld(Switching::kPair, 1000.0)}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Experiment, StartsAgainTheSame) {
  const auto experiment =
      makeExperiment({.run = runOf({"", "convergence", hybridWorld(Switching::kPair, 400.0)}, 0)});
  test::run(*experiment, 90);
  const auto first = experiment->table().hashes("state_hash");
  experiment->hands().gather(Vec3(0.0F));
  test::run(*experiment, 30);
  ASSERT_TRUE(experiment->restart());
  EXPECT_EQ(experiment->restarts(), 1);
  EXPECT_EQ(experiment->world().frame(), 0U);
  EXPECT_EQ(experiment->table().frames(), 0U);
  EXPECT_EQ(experiment->history().size(), 1U);
  EXPECT_FALSE(experiment->hands().gathering());
  test::run(*experiment, 90);
  EXPECT_EQ(experiment->table().hashes("state_hash"), first);
}

TEST(Experiment, StartsAgainInAnotherPhysics) {
  const auto experiment = test::play(WorldKind::kHybrid, true);
  EXPECT_EQ(experiment->options().label, "hybrid");
  ASSERT_TRUE(experiment->restart(PhysicsDef{}));
  EXPECT_EQ(experiment->world().physics().kind(), WorldKind::kStandard);
  EXPECT_EQ(experiment->options().label, "standard");
}

TEST(Experiment, OpensAnotherSceneAsIfItHadBegunWithIt) {
  const Played duel{"duel", "duel", hybridWorld(Switching::kPair, 0.0)};
  const Played mugs{"mugs", "mugs", hybridWorld(Switching::kPair, 0.0)};
  const auto other = makeExperiment({.run = runOf(mugs, 0)});
  test::run(*other, 5);
  ASSERT_TRUE(other->open("duel"));
  const auto fresh = makeExperiment({.run = runOf(duel, 0)});
  test::run(*other, 20);
  test::run(*fresh, 20);
  EXPECT_EQ(other->world().physics().stateHash(), fresh->world().physics().stateHash());
  EXPECT_EQ(other->options().frames, fresh->options().frames);
  EXPECT_EQ(other->options().summary, fresh->options().summary);
  EXPECT_EQ(other->table().frames(), 20U);
  const auto opened = other->open("nowhere");
  ASSERT_FALSE(opened);
  EXPECT_THAT(opened.error().message, HasSubstr("nowhere"));
  EXPECT_EQ(other->options().scene, "duel");
  test::run(*other, 1);
}

TEST(Experiment, AFailedRestartLeavesEverythingAsItWas) {
  bool works = true;
  RunOptions options = fakeRun(WorldKind::kStandard, 1);
  options.engine = [&works](const PhysicsDef& def) -> Result<std::unique_ptr<Physics>> {
    if (!works) return fail("engine is out of order");
    return std::make_unique<test::FakePhysics>(def);
  };
  const auto experiment = makeExperiment({.run = options});
  test::run(*experiment, 3);
  works = false;
  const auto restarted = experiment->restart();
  ASSERT_FALSE(restarted);
  EXPECT_THAT(restarted.error().message, HasSubstr("out of order"));
  EXPECT_EQ(experiment->world().frame(), 3U);
  test::run(*experiment, 1);
  EXPECT_EQ(experiment->table().frames(), 4U);
}

TEST(Experiment, ALostStateStopsItWithOneLineUntilItStartsAgain) {
  const auto experiment = makeExperiment({.run = fakeRun(WorldKind::kStandard, 1, {.invalidStep = 3})});
  test::run(*experiment, 2);
  const auto lost = experiment->step();
  ASSERT_FALSE(lost);
  EXPECT_THAT(lost.error().message, HasSubstr("'left'"));
  EXPECT_THAT(lost.error().message, HasSubstr("frame 3"));
  EXPECT_THAT(lost.error().message, Not(HasSubstr("\n")));
  EXPECT_EQ(experiment->stopped(), lost.error().message);
  EXPECT_EQ(experiment->table().frames(), 3U);
  EXPECT_FALSE(experiment->step());
  EXPECT_EQ(experiment->table().frames(), 3U);
  ASSERT_TRUE(experiment->restart());
  EXPECT_TRUE(experiment->step());
}

TEST(Experiment, RefusesWhatARunRefuses) {
  RunOptions options = fakeRun(WorldKind::kStandard, 1);
  options.budgetMs = 0.0;
  const auto refused = Experiment::create({.run = options});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("budget"));
}

TEST(Experiment, WritesTheRunUntilNow) {
  const Played played{"", "convergence", hybridWorld(Switching::kPair, 400.0)};
  TemporaryFolder folder;
  RunOptions written = runOf(played, 60);
  written.out = folder.path() / "run";
  ASSERT_TRUE(runScene(written));
  const auto experiment = makeExperiment({.run = runOf(played, 0)});
  EXPECT_FALSE(experiment->write(folder.path() / "early", false));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "early"));
  test::run(*experiment, 60);
  const auto out = folder.path() / "experiment";
  const auto done = experiment->write(out, false);
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_EQ(contentOf(out / "events.csv"), contentOf(*written.out / "events.csv"));
  const std::string csv = contentOf(out / "frames.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 61);
  EXPECT_THAT(contentOf(out / "summary.json"), HasSubstr("\"frames\": 60"));
  EXPECT_FALSE(std::filesystem::exists(out / "hands.txt"));
  experiment->hands().gather(Vec3(0.0F));
  test::run(*experiment, 1);
  ASSERT_TRUE(experiment->write(out, false));
  EXPECT_EQ(contentOf(out / "hands.txt"), "60 gather 0 0 0\n");
}

TEST(Experiment, DrawsFiguresIfAsked) {
  if (!checkGnuplot()) GTEST_SKIP() << "gnuplot is not installed";
  TemporaryFolder folder;
  const auto experiment = makeExperiment({.run = fakeRun(WorldKind::kHybrid, 1)});
  test::run(*experiment, 20);
  const auto done = experiment->write(folder.path() / "out", true);
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "out" / "figures" / "overview.svg"));
}

TEST(Experiment, ABudgetThatIsChangedStaysChanged) {
  const auto experiment =
      makeExperiment({.run = runOf({"", "convergence", hybridWorld(Switching::kPair, 0.0)}, 0)});
  test::run(*experiment, 2);
  ASSERT_TRUE(experiment->setBudget({.units = 300.0}));
  EXPECT_EQ(experiment->summary().physics.switching.budget.units, 300.0);
  test::run(*experiment, 1);
  EXPECT_EQ(experiment->world().physics().switching().budgetUnits().given, 300.0);
  ASSERT_TRUE(experiment->restart());
  test::run(*experiment, 1);
  EXPECT_EQ(experiment->world().physics().switching().budgetUnits().given, 300.0);
}

}  // namespace
}  // namespace scatter
