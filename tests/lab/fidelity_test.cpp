#include <scatter/lab/fidelity.h>

#include <scatter/lab/run.h>

#include "lab/fake_physics.h"
#include "lab/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cmath>

namespace scatter {
namespace {

using test::fakeRun;

scatter::Run fidelityRun(int frames, int every, test::FakeBehaviour behaviour = {}) {
  RunOptions options = fakeRun(WorldKind::kHybrid, frames, behaviour);
  options.fidelityEvery = every;
  auto run = runScene(options);
  EXPECT_TRUE(run);
  return std::move(*run);
}

TEST(Fidelity, IsSampledEverySoManyFramesAndLeftOutInTheOthers) {
  const auto run = fidelityRun(12, 5);
  const auto& visible = run.table.values("visible_overlap_pairs");
  for (std::size_t i = 0; i < visible.size(); ++i) {
    const std::size_t frame = i + 1;
    EXPECT_EQ(std::isnan(visible[i]), frame % 5 != 0) << frame;
    EXPECT_EQ(std::isnan(run.table.values("contact_gap_p95")[i]), frame % 5 != 0) << frame;
    EXPECT_FALSE(std::isnan(run.table.values("largest_jump")[i])) << frame;
  }
  // The fake has step % 4 overlaps, and as many pairs that touch finely as steps.
  EXPECT_EQ(visible[4], 1.0);
  EXPECT_EQ(visible[9], 2.0);
  EXPECT_EQ(run.table.values("sampled_finest_pairs")[9], 10.0);
  EXPECT_EQ(run.table.values("sampled_touching_pairs")[9], 13.0);
  EXPECT_EQ(run.table.values("contact_gap_p95")[9], 3.0);
}

TEST(Fidelity, StatisticsAreThoseOfTheSamples) {
  const FidelityStatistics fidelity = fidelityRun(12, 5).summary.fidelity;
  EXPECT_EQ(fidelity.every, 5);
  EXPECT_EQ(fidelity.samples, 2U);
  EXPECT_EQ(fidelity.touchingByLevel, (std::vector<std::uint64_t>{15, 6}));
  EXPECT_EQ(fidelity.touchingPairs(), 21U);
  EXPECT_DOUBLE_EQ(fidelity.share(0), 15.0 / 21.0);
  EXPECT_DOUBLE_EQ(fidelity.share(1), 6.0 / 21.0);
  EXPECT_EQ(fidelity.share(2), 0.0);
  EXPECT_DOUBLE_EQ(fidelity.visibleOverlapMean, 1.5);
  EXPECT_EQ(fidelity.visibleOverlapPeak, 2U);
  EXPECT_DOUBLE_EQ(fidelity.visibleOverlapPer100, 300.0 / 21.0);
  // Six gaps: 1, 1, 2, 2, 3, 3.
  EXPECT_EQ(fidelity.contactGaps, 6U);
  EXPECT_EQ(fidelity.contactGapP95, 3.0);
  EXPECT_EQ(fidelity.contactGapMax, 3.0);
  // 5 of 8 and 10 of 13.
  EXPECT_DOUBLE_EQ(fidelity.finestShareMean, (5.0 / 8.0 + 10.0 / 13.0) / 2.0);
  EXPECT_DOUBLE_EQ(fidelity.finestShareWorst, 5.0 / 8.0);
  EXPECT_EQ(fidelity.finestShareWorstFrame, 5U);
}

TEST(Fidelity, TheFinestShareIsThatOfEveryFrameIfThePhysicsCountsIt) {
  const FidelityStatistics fidelity = fidelityRun(10, 5, {.countsTouching = true}).summary.fidelity;
  EXPECT_DOUBLE_EQ(fidelity.finestShareMean, 0.99);
  EXPECT_DOUBLE_EQ(fidelity.finestShareWorst, 0.9);
  EXPECT_EQ(fidelity.finestShareWorstFrame, 7U);
}

TEST(Fidelity, TheImpactFollowsTheMostKineticEnergy) {
  // The fake's energy grows with every step, so that the last one is the impact: a sample, with 10 of 13.
  const FidelityStatistics fidelity = fidelityRun(10, 5).summary.fidelity;
  EXPECT_EQ(fidelity.impactFrame, 10U);
  EXPECT_DOUBLE_EQ(fidelity.impactFinestShare, 10.0 / 13.0);
  EXPECT_EQ(fidelity.impactContactGapP95, 3.0);
  EXPECT_DOUBLE_EQ(fidelity.impactVisibleOverlapPer100, 200.0 / 13.0);
  // Without a sample there is nothing to say.
  EXPECT_EQ(fidelityRun(12, 5).summary.fidelity.impactFinestShare, 1.0);
}

TEST(Fidelity, AJumpIsWhatVelocityDoesNotExplain) {
  const auto run = fidelityRun(9, 3, {.jumpStep = 4});
  EXPECT_NEAR(run.summary.fidelity.largestJump, 0.5, 1e-6);
  EXPECT_EQ(run.summary.fidelity.largestJumpFrame, 4U);
  EXPECT_NEAR(run.table.values("largest_jump")[3], 0.5, 1e-6);
  EXPECT_LT(run.table.values("largest_jump")[2], 1e-6);
}

// Moves the first object before step 3, as a program may.
class MovingScene final : public Scene {
 public:
  Result<void> build(World& world, const SceneOptions& options) override {
    return scene_.build(world, options);
  }
  void update(World& world) override {
    if (world.frame() == 2) {
      world.objects().front()->setPose({Vec3(100.0F), kNoRotation});
    }
  }

 private:
  test::FakeScene scene_;
};

TEST(Fidelity, WhatTheSceneMovesIsNoJump) {
  RunOptions options = fakeRun(WorldKind::kHybrid, 5);
  options.makeScene = [] { return std::make_unique<MovingScene>(); };
  options.fidelityEvery = 1;
  const auto run = runScene(options);
  ASSERT_TRUE(run);
  EXPECT_LT(run->summary.fidelity.largestJump, 1e-4);
}

TEST(Fidelity, WithoutItThereAreNoColumnsAndNoStatistics) {
  const auto run = runScene(fakeRun(WorldKind::kHybrid, 5));
  ASSERT_TRUE(run);
  EXPECT_EQ(run->table.find("visible_overlap_pairs"), nullptr);
  EXPECT_EQ(run->summary.fidelity.every, 0);
}

TEST(Fidelity, NothingTouchedIsAllFinest) {
  const FidelityStatistics fidelity = fidelityRun(4, 5).summary.fidelity;
  EXPECT_EQ(fidelity.samples, 0U);
  EXPECT_EQ(fidelity.finestShareMean, 1.0);
  EXPECT_EQ(fidelity.finestShareWorst, 1.0);
  EXPECT_EQ(fidelity.finestShareWorstFrame, 0U);
  EXPECT_EQ(fidelity.visibleOverlapPer100, 0.0);
  EXPECT_EQ(fidelity.contactGapP95Percent(), 0.0);
}

TEST(Fidelity, ALostStateIsNotMeasured) {
  RunOptions options = fakeRun(WorldKind::kHybrid, 10, {.invalidStep = 4});
  options.fidelityEvery = 2;
  test::TemporaryFolder folder;
  options.out = folder.path();
  EXPECT_FALSE(runScene(options));
  const auto json = nlohmann::json::parse(test::contentOf(folder.path() / "summary.json"));
  EXPECT_EQ(json["fidelity"]["samples"], 1);
}

// Two hybrids of 2 and 4 m and a box.
class LengthScene final : public Scene {
 public:
  Result<void> build(World& world, const SceneOptions& /*options*/) override {
    for (const float half : {1.0F, 2.0F, 0.0F}) {
      BodyDef def;
      def.name = "body";
      def.pose.position.x = half;
      if (half > 0.0F) {
        LevelSetDef levels{.name = "box", .levels = {}, .mass = {}};
        levels.levels = {Level{{{Box{Vec3(half + 1.0F)}, {}}}}, Level{{{Box{Vec3(half, 0.5F, 0.5F)}, {}}}}};
        auto made = LevelSet::create(levels);
        EXPECT_TRUE(made);
        def.shape = *made;
      }
      if (auto added = world.add(def); !added) {
        return tl::unexpected(added.error());
      }
    }
    return {};
  }
};

TEST(Fidelity, GapsAreInPercentOfTheMeanLengthOfTheHybrids) {
  RunOptions options = fakeRun(WorldKind::kHybrid, 5);
  options.makeScene = [] { return std::make_unique<LengthScene>(); };
  options.fidelityEvery = 5;
  const auto run = runScene(options);
  ASSERT_TRUE(run);
  EXPECT_DOUBLE_EQ(run->summary.fidelity.length, 3.0);
  EXPECT_DOUBLE_EQ(run->summary.fidelity.contactGapP95Percent(), 100.0);
}

TEST(Fidelity, ThePileIsMeasuredAtTheEnd) {
  const FidelityStatistics fidelity = fidelityRun(4, 2).summary.fidelity;
  EXPECT_DOUBLE_EQ(fidelity.kineticEnergyEnd, (1.0 + 2.0 + 3.0 + 4.0) / 4.0 / 3.0);
  RunOptions options = test::fakeRun(WorldKind::kHybrid, 2);
  options.makeScene = [] { return std::make_unique<LengthScene>(); };
  options.fidelityEvery = 1;
  const auto run = runScene(options);
  ASSERT_TRUE(run);
  // Of the two hybrids, one metre apart.
  EXPECT_DOUBLE_EQ(run->summary.fidelity.pileRadius, 0.5);
}

TEST(Fidelity, IsInTheSummary) {
  const auto run = fidelityRun(12, 5, {.jumpStep = 4});
  test::TemporaryFolder folder;
  ASSERT_TRUE(writeSummary(folder.path() / "summary.json", run.summary));
  const auto json = nlohmann::json::parse(test::contentOf(folder.path() / "summary.json"))["fidelity"];
  EXPECT_EQ(json["visible_overlap_pairs"]["mean"], 1.5);
  EXPECT_EQ(json["visible_overlap_pairs"]["peak"], 2);
  EXPECT_EQ(json["contact_gap_p95"], 3.0);
  EXPECT_EQ(json["touching_by_level"][1]["touching_pairs"], 6);
  EXPECT_EQ(json["finest_share"]["worst_frame"], 5);
  EXPECT_EQ(json["largest_jump_frame"], 4);
  EXPECT_EQ(json["impact"]["first_frame"], 12);
  EXPECT_EQ(json["kinetic_energy_last_100_mean"], run.summary.fidelity.kineticEnergyEnd);
}

}  // namespace
}  // namespace scatter
