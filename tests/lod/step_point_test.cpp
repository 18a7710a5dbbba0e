#include "lod/step_point.h"

#include <gtest/gtest.h>

namespace scatter::lod {
namespace {

// Units take 1 ms before the point and 3 ms after it, on a machine whose speed changes from step to step.
StepPoint experienced() {
  StepPoint point;
  for (int i = 0; i < 40; ++i) {
    const double speed = 1.0 + 0.3 * (i % 4);
    point.begin();
    point.pass(50.0, 50.0 * speed);
    point.learn(100.0, 200.0 * speed);
  }
  point.begin();
  return point;
}

TEST(StepPoint, LeavesEverythingToAStepThatIsAsUsual) {
  StepPoint point = experienced();
  for (const double perUnit : {0.5, 2.0, 7.0}) {
    point.pass(50.0, 50.0 * perUnit / 2.0);
    EXPECT_DOUBLE_EQ(point.room(100.0, perUnit), 100.0);
    point.pass(50.0, 10.0 * perUnit / 2.0);
    EXPECT_DOUBLE_EQ(point.room(100.0, perUnit), 100.0) << "no more than that to one that has been quick";
  }
}

TEST(StepPoint, TakesTheRestOfASlowStepForAsSlow) {
  StepPoint point = experienced();
  // 100 of 200 ms are gone, and each unit that is left takes 6.
  point.pass(50.0, 100.0);
  EXPECT_DOUBLE_EQ(point.room(100.0, 2.0), 50.0 + 100.0 / 6.0);
  point.pass(50.0, 1000.0);
  EXPECT_DOUBLE_EQ(point.room(100.0, 2.0), 50.0);
}

TEST(StepPoint, KnowsNothingAtFirst) {
  StepPoint point;
  EXPECT_DOUBLE_EQ(point.room(100.0, 2.0), 100.0) << "of a step that has not come to it";
  point.pass(50.0, 100.0);
  EXPECT_DOUBLE_EQ(point.room(100.0, 2.0), 100.0);
  point.pass(50.0, 125.0);
  EXPECT_DOUBLE_EQ(point.room(100.0, 2.0), 50.0 + 75.0 / 2.5);
}

TEST(StepPoint, LearnsNothingOfStepsThatDoNotComeToIt) {
  StepPoint point = experienced();
  for (int i = 0; i < 40; ++i) {
    point.begin();
    point.learn(100.0, 1000.0);
    point.pass(100.0, 1000.0);
    point.learn(100.0, 1000.0);
  }
  point.pass(50.0, 50.0);
  EXPECT_DOUBLE_EQ(point.room(100.0, 2.0), 100.0);
}

}  // namespace
}  // namespace scatter::lod
