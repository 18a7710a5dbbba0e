#include <scatter/lab/loop.h>

#include <gtest/gtest.h>

#include <string>

namespace scatter {
namespace {

TEST(Loop, RunsTasksInTheOrderOfTheReportsFigure) {
  ManualClock clock;
  Loop loop(clock);
  std::string order;
  loop.add(LoopTask::kFrameData, [&] { order += 'f'; });
  loop.add(LoopTask::kRenderer, [&] { order += 'r'; });
  loop.add(LoopTask::kDebug, [&] { order += 'd'; });
  loop.add(LoopTask::kProfiling, [&] { order += 'p'; });
  loop.add(LoopTask::kPhysics, [&] { order += 'P'; });
  loop.add(LoopTask::kInput, [&] { order += 'i'; });
  loop.add(LoopTask::kInput, [&] { order += 'I'; });
  clock.advance(1.0 / 60.0);
  loop.runOnce();
  EXPECT_EQ(order, "iIPpdrf");
}

TEST(Loop, MakesOneStepALoopAtTheFrequencyOfTheStep) {
  ManualClock clock;
  Loop loop(clock);
  for (int i = 0; i < 6001; ++i) {
    loop.runOnce();
  }
  // The first loop starts at time zero, when no step is due.
  EXPECT_EQ(loop.report().steps, 6000U);
  EXPECT_NEAR(clock.now(), 6001.0 / 60.0, 1e-9);
  EXPECT_EQ(loop.report().droppedSeconds, 0.0);
  EXPECT_EQ(loop.report().lateLoops, 0U);
}

TEST(Loop, StepsTheTimeThatPassedWhateverTheFrequency) {
  for (const double frequency : {10.0, 24.0, 50.0, 144.0, 1000.0}) {
    ManualClock clock;
    Loop loop(clock, {.frequency = frequency});
    while (clock.now() < 10.0) {
      loop.runOnce();
    }
    EXPECT_NEAR(static_cast<double>(loop.report().steps), 600.0, 60.0 / frequency + 1.0) << frequency;
  }
}

TEST(Loop, RateChangesTheNumberOfStepsWithoutAJump) {
  ManualClock clock;
  Loop loop(clock);
  for (int i = 0; i < 61; ++i) {
    loop.runOnce();
  }
  EXPECT_EQ(loop.report().steps, 60U);
  loop.setPhysicsRate(0.25);
  for (int i = 0; i < 60; ++i) {
    loop.runOnce();
  }
  EXPECT_EQ(loop.report().steps, 75U);
  loop.setPhysicsRate(4.0);
  for (int i = 0; i < 60; ++i) {
    loop.runOnce();
  }
  // The first of these loops sees time that passed after the change: it is all at the new rate.
  EXPECT_NEAR(static_cast<double>(loop.report().steps), 315.0, 1.0);
}

TEST(Loop, RateIsClamped) {
  ManualClock clock;
  Loop loop(clock);
  loop.setPhysicsRate(0.0);
  EXPECT_EQ(loop.physicsRate(), 0.05);
  loop.setPhysicsRate(100.0);
  EXPECT_EQ(loop.physicsRate(), 4.0);
}

TEST(Loop, PauseStopsPhysicsAloneAndSingleStepMakesOne) {
  ManualClock clock;
  Loop loop(clock);
  int pictures = 0;
  loop.add(LoopTask::kRenderer, [&] { ++pictures; });
  loop.runOnce();
  loop.pausePhysics();
  for (int i = 0; i < 10; ++i) {
    loop.runOnce();
  }
  const auto paused = loop.report().steps;
  EXPECT_LE(paused, 1U);
  EXPECT_EQ(pictures, 11);
  loop.singleStep();
  loop.runOnce();
  loop.runOnce();
  EXPECT_EQ(loop.report().steps, paused + 1);
  loop.resumePhysics();
  for (int i = 0; i < 10; ++i) {
    loop.runOnce();
  }
  // Ten periods passed since, not the twelve of the pause as well.
  EXPECT_NEAR(static_cast<double>(loop.report().steps), static_cast<double>(paused) + 11.0, 1.0);
}

TEST(Loop, SlowPhysicsIsBoundedAndWhatIsDroppedIsCounted) {
  ManualClock clock;
  Loop loop(clock, {.maxSteps = 4});
  // A step costs twice the time it simulates: without a bound every loop would have more to do.
  loop.add(LoopTask::kPhysics, [&] { clock.advance(2.0 / 60.0); });
  std::uint64_t before = 0;
  for (int i = 0; i < 100; ++i) {
    loop.runOnce();
    ASSERT_LE(loop.report().steps - before, 4U);
    before = loop.report().steps;
  }
  EXPECT_GT(loop.report().loopsWithDropped, 90U);
  EXPECT_GT(loop.report().lateLoops, 90U);
  // Every second is stepped, dropped, or less than a step and still to come; the last loop's own time is
  // not yet taken in.
  const double stepped = static_cast<double>(loop.report().steps) / 60.0;
  EXPECT_NEAR(stepped + loop.report().droppedSeconds, loop.physicsTimer().seconds(), 1.0 / 60.0);
}

TEST(Loop, OneLongFrameIsNotFollowedByAHurry) {
  ManualClock clock;
  Loop loop(clock);
  loop.runOnce();
  clock.advance(100.0);
  loop.runOnce();
  EXPECT_EQ(loop.report().steps, 8U);
  EXPECT_NEAR(loop.report().droppedSeconds, 100.0 + 1.0 / 60.0 - 8.0 / 60.0, 1.0 / 60.0);
  const double after = clock.now();
  for (int i = 0; i < 10; ++i) {
    loop.runOnce();
  }
  EXPECT_NEAR(clock.now() - after, 10.0 / 60.0, 1e-9);
  EXPECT_EQ(loop.report().lateLoops, 1U);
}

TEST(Loop, StopEndsRunAndLeavesOutFurtherCatchUpSteps) {
  ManualClock clock;
  Loop loop(clock);
  int frames = 0;
  loop.add(LoopTask::kPhysics, [&] { loop.stop(); });
  loop.add(LoopTask::kFrameData, [&] { ++frames; });
  clock.advance(5.0 / 60.0);
  loop.run();
  EXPECT_EQ(loop.report().steps, 1U);
  EXPECT_EQ(frames, 1);
  EXPECT_TRUE(loop.stopRequested());
}

TEST(Loop, StepFractionIsWhatHasPassedOfTheNextStep) {
  ManualClock clock;
  Loop loop(clock);
  clock.advance(1.25 / 60.0);
  loop.runOnce();
  EXPECT_NEAR(loop.stepFraction(), 0.25, 1e-9);
}

}  // namespace
}  // namespace scatter
