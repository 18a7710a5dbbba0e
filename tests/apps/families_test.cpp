#include <gmock/gmock.h>

#include <fstream>

#include "apps/program.h"

namespace scatter::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class FamiliesTest : public ProgramTest {};

TEST_F(FamiliesTest, AreListedWithoutAFolder) {
  const Outcome outcome = scatter({"families"});
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("wheel_stack"));
  EXPECT_TRUE(fs::is_empty(folder));
}

TEST_F(FamiliesTest, AreWrittenAndRun) {
  const Outcome outcome = scatter(
      {"families", "--only", "rooms,quiet", "--seeds", "3,4", "--scale", "0.02", "--out", "new/scenes"});
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_THAT(linesOf(outcome.output),
              testing::ElementsAre("new/scenes/rooms-3.toml", "new/scenes/quiet-3.toml",
                                   "new/scenes/rooms-4.toml", "new/scenes/quiet-4.toml"));
  const Outcome run = scatter({"run", "new/scenes/rooms-3.toml", "--frames", "5"});
  EXPECT_EQ(run.status, 0) << run.errors;
}

TEST_F(FamiliesTest, AreWrittenIntoAFolderThatIsThere) {
  fs::create_directory(folder / "f");
  std::ofstream(folder / "f/mine.txt") << "mine";
  for (int i = 0; i < 2; ++i) {
    const Outcome outcome = scatter({"families", "--only", "wheel_stack", "--out", "f"});
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
  }
  EXPECT_TRUE(fs::exists(folder / "f/mine.txt"));
  EXPECT_TRUE(fs::exists(folder / "f/wheel_stack-1/wheel-1.dae"));
}

TEST_F(FamiliesTest, AFileIsNoFolder) {
  std::ofstream(folder / "f") << "a file";
  const Outcome outcome = scatter({"families", "--only", "quiet", "--scale", "0.02", "--out", "f"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.errors, HasSubstr("is not a folder"));
  EXPECT_EQ(linesOf(outcome.errors).size(), 1U);
}

TEST_F(FamiliesTest, AFullDiskLeavesNothing) {
  const Outcome outcome = runProgram(
      {.arguments = {"families", "--scale", "0.02", "--out", "f"}, .folder = folder, .largestFile = 4000});
  EXPECT_NE(outcome.status, 0);
  EXPECT_EQ(linesOf(outcome.errors).size(), 1U) << outcome.errors;
  EXPECT_TRUE(fs::is_empty(folder));
}

}  // namespace
}  // namespace scatter::test
