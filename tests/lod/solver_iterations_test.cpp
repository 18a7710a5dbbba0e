#include "lod/solver_iterations.h"

#include <gtest/gtest.h>

namespace scatter::lod {
namespace {

constexpr double kRoomOfStep = 100.0;

TEST(SolverIterations, AreAllMadeAsLongAsTheStepFits) {
  EXPECT_EQ(iterationsLeftOut(100.0, kRoomOfStep, 5.0, 10), 0);
  EXPECT_EQ(iterationsLeftOut(20.0, kRoomOfStep, 5.0, 10), 0);
}

TEST(SolverIterations, AreLeftOutAsManyAsAreNeeded) {
  EXPECT_EQ(iterationsLeftOut(100.1, kRoomOfStep, 5.0, 10), 1);
  EXPECT_EQ(iterationsLeftOut(105.0, kRoomOfStep, 5.0, 10), 1);
  EXPECT_EQ(iterationsLeftOut(105.1, kRoomOfStep, 5.0, 10), 2);
  EXPECT_EQ(iterationsLeftOut(129.0, kRoomOfStep, 5.0, 10), 6);
}

TEST(SolverIterations, AreNeverLeftOutButForThreeInFive) {
  EXPECT_EQ(iterationsLeftOut(149.0, kRoomOfStep, 5.0, 10), 6);
  EXPECT_EQ(iterationsLeftOut(120.0, kRoomOfStep, 5.0, 4), 2);
  EXPECT_EQ(iterationsLeftOut(120.0, kRoomOfStep, 5.0, 1), 0);
  EXPECT_EQ(iterationsLeftOut(120.0, kRoomOfStep, 5.0, 0), 0);
}

TEST(SolverIterations, AreAllMadeIfThatIsFarFromEnough) {
  EXPECT_EQ(iterationsLeftOut(151.0, kRoomOfStep, 5.0, 10), 0);
  EXPECT_EQ(iterationsLeftOut(1e9, kRoomOfStep, 5.0, 10), 0);
  EXPECT_EQ(iterationsLeftOut(110.0, kRoomOfStep, 0.0, 10), 0);
}

}  // namespace
}  // namespace scatter::lod
