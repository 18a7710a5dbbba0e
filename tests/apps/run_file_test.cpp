// Scenes that are files, on the command line.

#include <gmock/gmock.h>

#include <fstream>

#include "apps/program.h"

namespace scatter::test {
namespace {

using testing::HasSubstr;

class RunFile : public ProgramTest {
 protected:
  void write(const char* name, const std::string& text) const { std::ofstream(folder / name) << text; }

  [[nodiscard]] std::vector<std::string> hashes(std::vector<std::string> arguments, const char* out) const {
    arguments.insert(arguments.end(), {"--quiet", "--out", out});
    const Outcome outcome = scatter(std::move(arguments));
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    return columnOf(folder / out / "frames.csv", "state_hash");
  }
};

const char* const kBalls = R"(
scene = { summary = "balls", frames = 4, seed = 6 }
region = [{ name = "r", kind = "ball", radius = 9 }]
object = [{ name = "ball", sphere = 1, in = "r", count = 5 }]
)";

TEST_F(RunFile, RunsASceneFileForItsFrames) {
  write("balls.toml", kBalls);
  const Outcome outcome = scatter({"run", "balls.toml", "--quiet"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.errors, "");
  EXPECT_THAT(outcome.output, testing::StartsWith("balls, hybrid world, bullet 3.24: 4 frames, seed 6"));
}

TEST_F(RunFile, TheSeedOnTheCommandLineOverridesTheFiles) {
  write("balls.toml", kBalls);
  const auto own = hashes({"run", "./balls.toml"}, "a");
  EXPECT_EQ(own.size(), 4U);
  EXPECT_EQ(own, hashes({"run", "balls.toml", "--seed", "6"}, "b"));
  EXPECT_NE(own, hashes({"run", "balls.toml", "--seed", "1"}, "c"));
}

TEST_F(RunFile, SaysInOneLineWhatIsWrongWithAFile) {
  write("balls.toml", std::string(kBalls) + "\n[[object]]\nname = \"a\"\nsphere = 1\ncolor = \"red\"\n");
  const Outcome outcome = scatter({"run", "balls.toml"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.errors.rfind("scatter: balls.toml:", 0), 0U) << outcome.errors;
  EXPECT_EQ(linesOf(outcome.errors).size(), 1U);
}

TEST_F(RunFile, AFileThatIsNotThereIsRefused) {
  expectRefused(scatter({"run", "nowhere.toml"}), "cannot read nowhere.toml");
  expectRefused(scatter({"run", "nowhere.gltf"}), "nowhere.gltf");
  expectRefused(scatter({"compare", "nowhere.dae"}), "nowhere.dae");
}

TEST_F(RunFile, ComparesIntoAFolderOfTheScenesName) {
  write("balls.toml", kBalls);
  const Outcome outcome = scatter({"compare", "./balls.toml", "--frames", "3", "--quiet"});
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_TRUE(std::filesystem::exists(folder / "out/balls/report.html"));
}

TEST_F(RunFile, BenchTakesAFile) {
  write("balls.toml", kBalls);
  const Outcome outcome =
      scatter({"bench", "worlds", "--scenes", "balls.toml", "--repeat", "1", "--frames", "3", "--quiet"});
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("balls"));
}

TEST_F(RunFile, RunsTheModelInAColladaFile) {
  const Outcome outcome = scatter({"run", SCATTER_TEST_MODEL_DIR "/hunter.dae", "--frames", "3", "--quiet"});
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, testing::StartsWith("hunter, hybrid world"));
}

TEST_F(RunFile, ListShowsFilesAmongTheScenes) {
  write("mine.toml", kBalls);
  write("broken.toml", "[scen]\n");
  const Outcome outcome = runProgram(
      {.arguments = {"list"}, .folder = folder, .environment = {{"SCATTER_SCENE_PATH", folder.string()}}});
  EXPECT_EQ(outcome.status, 0);
  for (const char* line :
       {"mine           balls (4 frames)", "tower  ", "pile  ", "broken         cannot be read: "}) {
    EXPECT_THAT(outcome.output, HasSubstr(line));
  }
}

}  // namespace
}  // namespace scatter::test
