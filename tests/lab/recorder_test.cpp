#include <scatter/lab/recorder.h>

#include "lab/fake_physics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace scatter {
namespace {

std::unique_ptr<World> fakeWorld(test::FakeBehaviour behaviour = {}) {
  auto world = std::make_unique<World>(std::make_unique<test::FakePhysics>(PhysicsDef{}, behaviour));
  EXPECT_TRUE(test::FakeScene().build(*world, {}));
  return world;
}

TEST(FrameRecorder, HasExactlyTheAgreedColumnsInOrder) {
  const auto world = fakeWorld();
  FrameData data(2);
  const FrameRecorder recorder(*world, data);
  std::string names;
  for (const Channel& channel : data.channels()) {
    names += (names.empty() ? "" : ",") + channel.name;
  }
  EXPECT_EQ(
      names,
      "frame,time_s,physics_ms,physics_cpu_ms,update_aabbs_ms,predict_motion_ms,collision_detection_ms,"
      "islands_ms,noncontact_constraints_ms,contact_constraints_ms,integrate_ms,vehicles_ms,activation_ms,"
      "plan_ms,cpu_load,objects,hybrids,joints,overlapping_pairs,narrowphase_pairs,pairs_with_hybrid,"
      "pairs_without_hybrid,manifolds,contacts,new_contacts,requests,switches_coarser,switches_finer,"
      "retractions,credited_pairs,finest_pairs,touching_pairs,touching_finest_pairs,reused_pairs,hidden_"
      "contacts,resting_bodies,woken_bodies,iterations_left_out,blocked_tries,"
      "separation_queries,cost_units,planned_units,floor_units,reachable_units,budget_verdict,withheld_pairs,"
      "overdue_pairs,"
      "pairs_skipped,list_rebuilds,child_pairs,child_"
      "pairs_"
      "asleep,recycled,"
      "bounds_rejected,axis_rejected,gjk_runs,gjk_iterations,detector_runs,half_space_runs,ground_pieces,"
      "awake_"
      "bodies,budget_"
      "ms,budget_"
      "units,revised_units,settled_units,kinetic_"
      "energy,max_"
      "penetration,state_hash");
}

TEST(FrameRecorder, FillsAFrameFromOneStep) {
  const auto world = fakeWorld();
  FrameData data(8);
  FrameRecorder recorder(*world, data, 5.0);
  ASSERT_TRUE(recorder.step());
  ASSERT_TRUE(recorder.step());
  const auto value = [&](const char* name) { return data.value(*data.find(name)); };
  EXPECT_EQ(value("frame"), 2.0);
  EXPECT_NEAR(value("time_s"), 2.0 / 60.0, 1e-8);
  EXPECT_GT(value("physics_ms"), 0.0);
  EXPECT_GE(value("physics_cpu_ms"), 0.0);
  EXPECT_EQ(value("update_aabbs_ms"), 1.0);
  EXPECT_EQ(value("plan_ms"), 10.0);
  EXPECT_EQ(value("objects"), 2.0);
  EXPECT_EQ(value("awake_bodies"), 2.0);
  EXPECT_EQ(value("manifolds"), 8.0);
  EXPECT_EQ(value("narrowphase_pairs"), 4.0);
  EXPECT_EQ(value("budget_ms"), 5.0);
  EXPECT_EQ(value("budget_units"), 2.0 / 7.0);
  EXPECT_EQ(value("revised_units"), 2.0 / 8.0);
  EXPECT_EQ(value("settled_units"), 2.0 / 9.0);
  EXPECT_EQ(value("kinetic_energy"), 2.0 / 3.0);
  EXPECT_EQ(value("max_penetration"), 0.25);
  EXPECT_EQ(data.hash(*data.find("state_hash")), world->physics().stateHash());
  EXPECT_EQ(data.value(*data.find("manifolds"), 1), 4.0);
}

TEST(FrameRecorder, EveryCountOfThePairAlgorithmHasItsColumn) {
  const auto world = fakeWorld({.work = PairWork{.pairs = 1,
                                                 .pairsSkipped = 2,
                                                 .rebuilds = 3,
                                                 .childPairs = 4,
                                                 .childPairsAsleep = 5,
                                                 .recycled = 6,
                                                 .boundsRejected = 7,
                                                 .axisRejected = 8,
                                                 .gjkRuns = 9,
                                                 .gjkIterations = 10,
                                                 .detectorRuns = 11,
                                                 .halfSpaceRuns = 12,
                                                 .pieces = 13}});
  FrameData data(2);
  FrameRecorder recorder(*world, data);
  ASSERT_TRUE(recorder.step());
  double expected = 2.0;
  for (const char* column :
       {"pairs_skipped", "list_rebuilds", "child_pairs", "child_pairs_asleep", "recycled", "bounds_rejected",
        "axis_rejected", "gjk_runs", "gjk_iterations", "detector_runs", "half_space_runs", "ground_pieces"}) {
    EXPECT_EQ(data.value(*data.find(column)), expected++) << column;
  }
}

TEST(FrameRecorder, NamesTheObjectWhoseStateIsLost) {
  const auto world = fakeWorld({.invalidStep = 3});
  FrameData data(8);
  FrameRecorder recorder(*world, data);
  ASSERT_TRUE(recorder.step());
  ASSERT_TRUE(recorder.step());
  const auto lost = recorder.step();
  ASSERT_FALSE(lost);
  EXPECT_THAT(lost.error().message, testing::HasSubstr("'left'"));
  EXPECT_THAT(lost.error().message, testing::HasSubstr("frame 3"));
  EXPECT_EQ(data.framesBegun(), 3U);
}

}  // namespace
}  // namespace scatter
