#include "lod/solver_iterations.h"

#include <gtest/gtest.h>

namespace scatter::lod {
namespace {

TEST(SolverIterations, AreAllMadeAsLongAsTheStepFits) {
  EXPECT_EQ(iterationsLeftOut(0.0, 5.0, 10), 0);
  EXPECT_EQ(iterationsLeftOut(-100.0, 5.0, 10), 0);
}

TEST(SolverIterations, AreLeftOutAsManyAsAreNeeded) {
  EXPECT_EQ(iterationsLeftOut(0.1, 5.0, 10), 1);
  EXPECT_EQ(iterationsLeftOut(5.0, 5.0, 10), 1);
  EXPECT_EQ(iterationsLeftOut(5.1, 5.0, 10), 2);
  EXPECT_EQ(iterationsLeftOut(29.0, 5.0, 10), 6);
}

TEST(SolverIterations, AreNeverLeftOutButForThreeInFive) {
  EXPECT_EQ(iterationsLeftOut(1e9, 5.0, 10), 6);
  EXPECT_EQ(iterationsLeftOut(1e9, 5.0, 4), 2);
  EXPECT_EQ(iterationsLeftOut(1e9, 5.0, 1), 0);
  EXPECT_EQ(iterationsLeftOut(1e9, 5.0, 0), 0);
}

TEST(SolverIterations, AreAllMadeIfTheyTakeNothing) {
  EXPECT_EQ(iterationsLeftOut(1e9, 0.0, 10), 0);
}

}  // namespace
}  // namespace scatter::lod
