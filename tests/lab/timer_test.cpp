#include <scatter/lab/timer.h>

#include <gtest/gtest.h>

#include <random>

namespace scatter {
namespace {

TEST(SystemClock, SleepsAtLeastUntilTheTime) {
  SystemClock clock;
  const double until = clock.now() + 0.002;
  clock.sleepUntil(until);
  EXPECT_GE(clock.now(), until);
}

TEST(ManualClock, SleepingNeverTurnsItBack) {
  ManualClock clock;
  clock.advance(2.0);
  clock.sleepUntil(1.0);
  EXPECT_EQ(clock.now(), 2.0);
  clock.sleepUntil(3.0);
  EXPECT_EQ(clock.now(), 3.0);
}

TEST(Timer, StandsStillUntilStartedAndMovesOnlyInUpdate) {
  ManualClock clock;
  Timer timer(clock);
  clock.advance(1.0);
  timer.update();
  EXPECT_EQ(timer.seconds(), 0.0);
  timer.start();
  clock.advance(0.5);
  EXPECT_EQ(timer.seconds(), 0.0);
  timer.update();
  EXPECT_EQ(timer.seconds(), 0.5);
}

TEST(Timer, PauseKeepsTheTimeUntilThenAndLeavesOutTheRest) {
  ManualClock clock;
  Timer timer(clock);
  timer.start();
  clock.advance(1.0);
  timer.pause();
  clock.advance(10.0);
  timer.update();
  EXPECT_EQ(timer.seconds(), 1.0);
  timer.resume();
  EXPECT_EQ(timer.seconds(), 1.0);
  clock.advance(2.0);
  timer.update();
  EXPECT_EQ(timer.seconds(), 3.0);
}

TEST(Timer, ResetGoesToZeroAndKeepsRunning) {
  ManualClock clock;
  Timer timer(clock);
  timer.start();
  clock.advance(4.0);
  timer.reset();
  EXPECT_EQ(timer.seconds(), 0.0);
  clock.advance(1.0);
  timer.update();
  EXPECT_EQ(timer.seconds(), 1.0);
  EXPECT_EQ(timer.elapsed(), 5.0);
}

TEST(SubTimer, RunsAtItsOwnRateAndChangesItWithoutAJump) {
  ManualClock clock;
  Timer timer(clock);
  timer.start();
  SubTimer half(timer, 0.5);
  clock.advance(8.0);
  timer.update();
  // 8 s at rate 0.5 are 4 s, though the sub-timer has not been updated before the change.
  half.setRate(3.0);
  EXPECT_EQ(half.seconds(), 4.0);
  clock.advance(2.0);
  timer.update();
  half.update();
  EXPECT_EQ(half.seconds(), 10.0);
}

TEST(SubTimer, PausesAndIsUntouchedByAResetOfItsSource) {
  ManualClock clock;
  Timer timer(clock);
  timer.start();
  SubTimer sub(timer);
  clock.advance(1.0);
  timer.reset();
  sub.update();
  EXPECT_EQ(sub.seconds(), 1.0);
  sub.pause();
  clock.advance(5.0);
  timer.update();
  sub.resume();
  EXPECT_EQ(sub.seconds(), 1.0);
  sub.reset();
  EXPECT_EQ(sub.seconds(), 0.0);
}

TEST(SubTimer, StandsStillWhileItsSourceIsPaused) {
  ManualClock clock;
  Timer timer(clock);
  SubTimer sub(timer, 2.0);
  clock.advance(1.0);
  timer.update();
  sub.update();
  EXPECT_EQ(sub.seconds(), 0.0);
}

TEST(SubTimer, NeverRunsBackWhateverIsDoneToIt) {
  ManualClock clock;
  Timer timer(clock);
  timer.start();
  SubTimer sub(timer);
  std::mt19937_64 random(7);
  double before = 0.0;
  for (int i = 0; i < 2000; ++i) {
    clock.advance(static_cast<double>(random() % 100) / 1000.0);
    switch (random() % 6) {
      case 0:
        sub.setRate(static_cast<double>(random() % 5));
        break;
      case 1:
        sub.pause();
        break;
      case 2:
        sub.resume();
        break;
      case 3:
        timer.reset();
        break;
      case 4:
        timer.pause();
        break;
      default:
        timer.resume();
    }
    timer.update();
    sub.update();
    ASSERT_GE(sub.seconds(), before);
    before = sub.seconds();
  }
  EXPECT_GT(before, 0.0);
}

}  // namespace
}  // namespace scatter
