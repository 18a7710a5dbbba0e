#include <gmock/gmock.h>

#include <csignal>

#include "apps/program.h"

namespace scatter::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class RecordingProgramTest : public ProgramTest {
 protected:
  void record(const std::string& file, std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments{"run", "duel", "--frames", "120", "--record", file};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = scatter(std::move(arguments));
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_THAT(outcome.output, HasSubstr("the recording: " + file + ", 121 frames"));
  }
};

TEST_F(RecordingProgramTest, IsReplayedForwardsAndBackwardsAsNumbers) {
  record("duel.rec");
  const Outcome info = scatter({"replay", "duel.rec", "--info"});
  EXPECT_EQ(info.status, 0) << info.errors;
  EXPECT_EQ(info.errors, "");
  EXPECT_THAT(info.output, HasSubstr("duel, hybrid world, bullet"));
  EXPECT_THAT(info.output, HasSubstr("frames 0 to 120"));
  auto forwards =
      linesOf(scatter({"replay", "duel.rec", "--frames", "10:110:20", "--body", "hunter"}).output);
  auto backwards =
      linesOf(scatter({"replay", "duel.rec", "--frames", "110:10:20", "--body", "hunter"}).output);
  ASSERT_EQ(forwards.size(), 7U);
  EXPECT_EQ(forwards[0], "frame,body,name,x,y,z,qw,qx,qy,qz,level,asleep");
  EXPECT_THAT(forwards[1], StartsWith("10,1,hunter,"));
  std::reverse(backwards.begin() + 1, backwards.end());
  EXPECT_EQ(forwards, backwards);
}

TEST_F(RecordingProgramTest, HoldsTheFrameData) {
  record("duel.rec", {"--out", "out"});
  const Outcome data = scatter({"replay", "duel.rec", "--data", "--frames", "1:"});
  std::ofstream(folder / "data.csv") << data.output;
  for (const char* column : {"frame", "state_hash", "contacts", "kinetic_energy"}) {
    EXPECT_EQ(columnOf(folder / "data.csv", column), columnOf(folder / "out" / "frames.csv", column));
  }
}

TEST_F(RecordingProgramTest, DiffSaysWhetherAndWhereTwoRunsPart) {
  record("a.rec");
  record("b.rec");
  for (const std::string seed : {"1", "2"}) {
    EXPECT_EQ(
        scatter({"run", "convergence", "--frames", "20", "--seed", seed, "--record", seed + ".rec"}).status,
        0);
  }
  const Outcome same = scatter({"diff", "a.rec", "b.rec"});
  EXPECT_EQ(same.status, 0) << same.errors;
  EXPECT_EQ(same.output, "the same, bit by bit, in frames 0 to 120\n");
  const Outcome other = scatter({"diff", "1.rec", "2.rec"});
  EXPECT_EQ(other.status, 1) << other.output;
  EXPECT_THAT(other.output, StartsWith("they part in frame "));
  const Outcome refused = scatter({"diff", "a.rec", "none.rec"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.errors, HasSubstr("none.rec"));
}

TEST_F(RecordingProgramTest, IsExportedForOtherPrograms) {
  record("duel.rec");
  for (const char* out : {"duel.glb", "duel.gltf", "duel.mcap"}) {
    const Outcome outcome = scatter({"export", "duel.rec", out, "--frames", "::2"});
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_THAT(outcome.output, StartsWith(std::string(out) + ": 61 frames, 2 bodies"));
    EXPECT_TRUE(std::filesystem::exists(folder / out));
  }
  for (const auto& [out, frames, part] :
       std::vector<std::array<std::string, 3>>{{"duel.usd", "0:9", "must end with .glb, .gltf or .mcap"},
                                               {"x.glb", "9:0", "the other way around"},
                                               {"none/x.glb", "0:9", "none/x.glb"}}) {
    const Outcome outcome = scatter({"export", "duel.rec", out, "--frames", frames});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.errors, HasSubstr(part));
    EXPECT_FALSE(std::filesystem::exists(folder / out));
  }
}

TEST_F(RecordingProgramTest, CompareStoresAFileForEachWorld) {
  const Outcome outcome = scatter({"compare", "duel", "--frames", "20", "--worlds", "standard,finest",
                                   "--repeat", "2", "--record", "duel.rec", "--out", "out"});
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("the recording: duel.standard.rec, 21 frames"));
  EXPECT_THAT(outcome.output, HasSubstr("the recording: duel.finest.rec, 21 frames"));
  EXPECT_EQ(scatter({"replay", "duel.standard.rec", "--info"}).status, 0);
}

TEST_F(RecordingProgramTest, AKilledRunLeavesItsWholeBlocks) {
  const Outcome killed = runProgram({.arguments = {"run", "fleet", "--frames", "100000", "--out", "out",
                                                   "--record", "fleet.rec", "--quiet"},
                                     .folder = folder,
                                     .interruptOnce = folder / "out" / "frames.csv",
                                     .lines = 400,
                                     .signal = SIGKILL});
  ASSERT_EQ(killed.status, 128 + SIGKILL);
  const Outcome info = scatter({"replay", "fleet.rec", "--info"});
  EXPECT_EQ(info.status, 0) << info.errors;
  EXPECT_THAT(info.errors, HasSubstr("are whole"));
  EXPECT_THAT(info.output, HasSubstr("frames 0 to "));
  EXPECT_EQ(scatter({"replay", "fleet.rec", "--frames", "100"}).status, 0);
}

TEST_F(RecordingProgramTest, AnInterruptedRunLeavesAllItsFrames) {
  const Outcome ended = runProgram({.arguments = {"run", "fleet", "--frames", "100000", "--out", "out",
                                                  "--record", "fleet.rec", "--quiet"},
                                    .folder = folder,
                                    .interruptOnce = folder / "out" / "frames.csv",
                                    .lines = 100});
  EXPECT_EQ(ended.status, 128 + SIGINT);
  const std::size_t frames = columnOf(folder / "out" / "frames.csv", "frame").size();
  const Outcome info = scatter({"replay", "fleet.rec", "--info"});
  EXPECT_EQ(info.errors, "");
  EXPECT_THAT(info.output, HasSubstr("frames 0 to " + std::to_string(frames) + ","));
  EXPECT_THAT(info.output, HasSubstr("it was interrupted after frame"));
}

TEST_F(RecordingProgramTest, AFullDiskIsSaidInOneLineAndTheRunGoesOn) {
  const Outcome outcome =
      runProgram({.arguments = {"run", "fleet", "--frames", "300", "--record", "fleet.rec", "--quiet"},
                  .folder = folder,
                  .largestFile = 400000});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.output, HasSubstr("fleet, hybrid world, bullet 3.24: 300 frames"));
  EXPECT_THAT(outcome.errors, HasSubstr("the recording is not whole: cannot write"));
  EXPECT_EQ(linesOf(outcome.errors).size(), 1U);
  EXPECT_EQ(scatter({"replay", "fleet.rec", "--frames", "20", "--body", "hunter-1"}).status, 0);
}

TEST_F(RecordingProgramTest, BadInputIsRefusedInOneLine) {
  expectRefused(scatter({"run", "duel", "--record", "none/duel.rec"}), "there is no folder none");
  expectRefused(scatter({"run", "duel", "--record-contacts"}), "--record-contacts");
  expectRefused(scatter({"replay", "none.rec", "--info"}), "none.rec");
  record("duel.rec");
  for (const auto& [frames, part] :
       std::vector<std::pair<std::string, std::string>>{{"121", "frames 0 to 120"},
                                                        {"x", "names no frames"},
                                                        {"1:2:0", "names no frames"},
                                                        {"5:900", "not 900"}}) {
    const Outcome outcome = scatter({"replay", "duel.rec", "--frames", frames});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.errors, HasSubstr(part));
  }
  EXPECT_THAT(scatter({"replay", "duel.rec", "--body", "nobody"}).errors,
              HasSubstr("no body is called \"nobody\""));
}

}  // namespace
}  // namespace scatter::test
