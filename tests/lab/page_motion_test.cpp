#include "lab/page/page_motion.h"

#include <scatter/lab/comparison.h>
#include <scatter/lab/run.h>
#include <scatter/world/observation.h>

#include "lab/frame_sampler.h"
#include "lab/play_scene.h"
#include "lab/scene_run.h"
#include "lab/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scatter::lab {
namespace {

TEST(PageMotion, HasAllFramesOfARun) {
  test::TemporaryFolder folder;
  RunOptions options = test::playRun(WorldKind::kHybrid, /*gravity=*/true);
  options.frames = 300;
  options.record = RecordOptions{.file = folder.path() / "run.rec"};
  ASSERT_TRUE(runScene(options));
  const auto recording = Recording::open(folder.path() / "run.rec").value();
  PageShapes shapes;
  PageBlobs blobs;
  const auto motion = pageMotion(*recording, shapes, blobs);
  ASSERT_TRUE(motion) << motion.error().message;
  EXPECT_EQ((*motion)["first"], 0);
  EXPECT_EQ((*motion)["last"], 300);
  EXPECT_EQ((*motion)["step"], 1);
  EXPECT_EQ((*motion)["bodies"].size(), 7U);
  EXPECT_EQ((*motion)["stopped"], "");
  std::uint64_t next = 0;
  for (const auto& block : (*motion)["blocks"]) {
    EXPECT_EQ(block["first"], next);
    next += block["frames"].get<std::uint64_t>();
  }
  EXPECT_EQ(next, 301U);
  // Five crates share a shape with both levels; the floor and the plank have their own.
  const auto look = shapes.finish(blobs);
  EXPECT_EQ(look["shapes"].size(), 3U);
  EXPECT_EQ(look["shapes"][(*motion)["bodies"][1][1].get<std::size_t>()]["levels"].size(), 2U);
}

TEST(CompareWorlds, RecordsTheFirstRunOfEachWorldInItsFolder) {
  test::TemporaryFolder folder;
  CompareOptions options{
      .runs = {test::playRun(WorldKind::kStandard, true), test::playRun(WorldKind::kHybrid, true)},
      .repeat = 2,
      .out = folder.path() / "out",
      .recordRuns = true};
  for (RunOptions& run : options.runs) run.frames = 20;
  const auto comparison = compareWorlds(options);
  ASSERT_TRUE(comparison) << comparison.error().message;
  for (const ComparedWorld& world : comparison->worlds) {
    ASSERT_TRUE(world.recording);
    EXPECT_EQ(*world.recording, folder.path() / "out" / world.label() / "repeat-1" / "run.rec");
    EXPECT_EQ(Recording::open(*world.recording).value()->last(), 20U);
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out/standard/repeat-2/run.rec"));

  // Runs that are taken as they are bring theirs along; a comparison without recordings leaves none behind.
  options.resume = true;
  EXPECT_EQ(compareWorlds(options).value().worlds[1].recording, comparison->worlds[1].recording);
  options.resume = false;
  options.anew = true;
  options.recordRuns = false;
  EXPECT_FALSE(compareWorlds(options).value().worlds[1].recording);
  EXPECT_FALSE(std::filesystem::exists(*comparison->worlds[1].recording));
}

TEST(FrameSampler, HasTheCoarsestLevelInUseOfEachBody) {
  RunOptions options = test::playRun(WorldKind::kHybrid, /*gravity=*/false);
  options.scene = "convergence";
  options.makeScene = {};
  options.frames = 420;
  options.physics.switching.switching = Switching::kPair;
  options.physics.switching.budget.units = 60.0;
  auto run = SceneRun::create(resolveRun(options).value());
  ASSERT_TRUE(run) << run.error().message;
  FrameSampler sampler(/*contacts=*/false);
  int coarse = 0;
  for (int frame = 0; frame < options.frames; ++frame) {
    (*run)->step();
    FrameSample sample;
    sampler.sample((*run)->world(), nullptr, sample);
    Observation observed;
    (*run)->world().physics().diagnostics().observe({.bodies = true, .pairs = false, .contacts = false},
                                                    observed);
    ASSERT_EQ(sample.bodies.size(), observed.bodies.size());
    for (std::size_t i = 0; i < sample.bodies.size(); ++i) {
      ASSERT_EQ(sample.bodies[i].body, observed.bodies[i].body);
      ASSERT_EQ(sample.bodies[i].level, observed.bodies[i].coarsestLevel)
          << "frame " << frame << ", body " << i;
      coarse +=
          sample.bodies[i].level < (*run)->world().physics().switching().levelCount(sample.bodies[i].body);
    }
  }
  EXPECT_GT(coarse, 100);
}

}  // namespace
}  // namespace scatter::lab
