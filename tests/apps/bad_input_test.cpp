#include <gmock/gmock.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "apps/program.h"

namespace scatter::test {
namespace {

namespace fs = std::filesystem;

struct Refusal {
  const char* name;
  std::vector<std::string> arguments;
  const char* message;  ///< Part of the line.
};

std::string refusalName(const testing::TestParamInfo<Refusal>& info) {
  return info.param.name;
}

class BadUsage : public ProgramTest, public testing::WithParamInterface<Refusal> {};

TEST_P(BadUsage, IsRefusedInOneLine) {
  expectRefused(scatter(GetParam().arguments), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Names, BadUsage,
    testing::Values(
        Refusal{"noCommand",
                {},
                "list, run, compare, replay, diff, export, report-test, levels, convert, families, bench"},
        Refusal{"unknownCommand",
                {"rum"},
                "did you mean \"run\"? Known: list, run, compare, replay, diff, export, report-test, levels, "
                "convert, families, bench"},
        Refusal{"unknownOption", {"run", "tower", "--frmes", "3"}, "did you mean \"--frames\"?"},
        Refusal{"extraArgument", {"run", "tower", "extra"}, "unexpected argument \"extra\""},
        Refusal{"noScene", {"run"}, "SCENE is required"},
        Refusal{"unknownScene", {"run", "towr"}, "did you mean \"tower\"?"},
        Refusal{"sceneWithLineBreak", {"run", "to\nwer"}, "unknown scene"},
        Refusal{
            "unknownSceneToCompare",
            {"compare", "towr"},
            "armada, breakables, collapse, convergence, duel, fleet, fleet_boxes, mugs, pile, quiet_apart"},
        Refusal{"unknownWorld", {"run", "tower", "--world", "hybird"}, "did you mean \"hybrid\"?"},
        Refusal{
            "unknownWorldToCompare", {"compare", "tower", "--worlds", "standard,hybird"}, "unknown world"},
        Refusal{"sameWorldTwice", {"compare", "tower", "--worlds", "hybrid,hybrid"}, "two worlds"},
        Refusal{"noWorlds", {"compare", "tower", "--worlds", ""}, "unknown world \"\""},
        Refusal{"unknownPolicy", {"run", "tower", "--policy", "finset"}, "did you mean \"finest\"?"},
        Refusal{
            "unknownEngine", {"run", "tower", "--engine", "ode"}, "unknown engine \"ode\"; known: bullet"},
        Refusal{"unknownSwitching", {"run", "tower", "--switching", "pairs"}, "did you mean \"pair\"?"},
        Refusal{"policyParameter", {"run", "tower", "--policy", "speed:form=5"}, "form"},
        Refusal{"policyValue", {"run", "tower", "--policy", "speed:from=fast"}, "fast"},
        Refusal{"parameterOfNoPolicy", {"run", "tower", "--policy", "from=5"}, "--policy"},
        Refusal{"twoModePolicies", {"run", "tower", "--policy", "finest,coarsest"}, "leave out coarsest"},
        Refusal{"policyOfPairsForBodies",
                {"run", "tower", "--switching", "body", "--policy", "speed"},
                "use --switching pair"},
        Refusal{"switchingOfAWorldWithItsOwn",
                {"run", "tower", "--world", "coarsest-body", "--switching", "pair"},
                "its own switching mode"},
        Refusal{"switchingInStandardWorld",
                {"run", "tower", "--world", "standard", "--switching", "body"},
                "--switching has no"},
        Refusal{"pairsWithBulletsCollision",
                {"run", "tower", "--switching", "pair", "--collision", "bullet"},
                "pair algorithm"},
        Refusal{
            "twoBudgets", {"run", "tower", "--budget-ms", "3", "--budget-units", "9"}, "give one of them"},
        Refusal{"budgetAndReplay", {"run", "tower", "--budget-ms", "3", "--replay", "f.csv"}, "one of them"},
        Refusal{"unitsForBodies",
                {"run", "tower", "--switching", "body", "--budget-units", "9"},
                "--budget-units has no meaning here"},
        Refusal{"unitsForEverythingFinest",
                {"run", "tower", "--policy", "finest", "--budget-units", "9"},
                "--budget-units has no meaning here"},
        Refusal{"creditForBodies",
                {"compare", "tower", "--worlds", "standard,hybrid-body", "--no-credit"},
                "--no-credit has no meaning here"},
        Refusal{"proximityStepsForPairs",
                {"run", "tower", "--proximity-steps", "4"},
                "--proximity-steps has no meaning here"},
        Refusal{"quietStepsForPairs",
                {"run", "tower", "--quiet-steps", "4"},
                "--quiet-steps has no meaning here"},
        Refusal{"noRecording", {"run", "tower", "--replay", "nowhere/frames.csv"}, "nowhere/frames.csv"},
        Refusal{
            "budgetWithoutUnit", {"run", "tower", "--world", "hybrid@5"}, "hybrid@5ms or hybrid@3000units"},
        Refusal{"negativeBudget", {"run", "tower", "--world", "hybrid@-5ms"}, "is not understood"},
        Refusal{"budgetOfAStandardWorld", {"run", "tower", "--world", "standard@5ms"}, "takes no budget"},
        Refusal{"budgetOfACoarseWorld", {"run", "tower", "--world", "coarsest@5ms"}, "takes no budget"},
        Refusal{"budgetWithBodies",
                {"run", "tower", "--world", "hybrid@5ms", "--switching", "body"},
                "takes no budget"},
        Refusal{"unknownBenchWorld", {"bench", "worlds", "--worlds", "standart"}, "unknown world"},
        Refusal{"noFidelityScene", {"bench", "fidelity"}, "SCENE is required"},
        Refusal{"noFidelityBudget", {"bench", "fidelity", "duel", "--budgets", "0"}, "is not understood"},
        Refusal{"policyInStandardWorld",
                {"run", "tower", "--world", "standard", "--policy", "none"},
                "--policy has no"},
        Refusal{"unknownCollision", {"run", "tower", "--collision", "bulet"}, "did you mean \"bullet\"?"},
        Refusal{"collisionInStandardWorld",
                {"run", "tower", "--world", "standard", "--collision", "scatter"},
                "--collision has no"},
        Refusal{"verificationInStandardWorld",
                {"run", "tower", "--world", "standard", "--verify-contacts", "5"},
                "--verify-contacts has no"},
        Refusal{"twoCollisions",
                {"compare", "tower", "--worlds", "standard,finest-bullet", "--collision", "scatter"},
                "has its own collision"},
        Refusal{"noFloor", {"bench", "spread", "--floors", "0"}, "--floors"},
        Refusal{"unknownFamily",
                {"families", "--out", "f", "--only", "quiet,wheel_box"},
                "unknown family \"wheel_box\"; did you mean \"wheels_box\"?"},
        Refusal{"seedsWithoutFamilies",
                {"bench", "worlds", "--scenes", "duel", "--seeds", "1,2"},
                "--seeds has no meaning here; it goes with --scenes families"},
        Refusal{"scaleWithoutFamilies", {"bench", "worlds", "--scale", "0.5"}, "goes with --scenes families"},
        Refusal{"noBenchCommand", {"bench"}, "scatter bench --list"},
        Refusal{"unknownBenchCommand", {"bench", "colision"}, "did you mean \"collision\"?"},
        Refusal{"unknownBenchOption", {"bench", "contacts", "--scens", "duel"}, "did you mean \"--scenes\"?"},
        Refusal{"extraBenchArgument", {"bench", "spread", "fleet"}, "unexpected argument \"fleet\""},
        Refusal{"unknownBenchScene", {"bench", "collision", "--scene", "flet"}, "did you mean \"fleet\"?"},
        Refusal{"contactsOfAStandardWorld", {"bench", "contacts", "--world", "standard"}, "hybrid world"},
        Refusal{
            "twoPolicies", {"run", "tower", "--world", "finest", "--policy", "none"}, "has its own policy"}),
    refusalName);

INSTANTIATE_TEST_SUITE_P(
    Numbers, BadUsage,
    testing::Values(
        Refusal{"zeroFrames", {"run", "tower", "--frames", "0"}, "--frames: needs a whole number from 1"},
        Refusal{"negativeFrames", {"run", "tower", "--frames", "-3"}, "not \"-3\""},
        Refusal{"framesInWords", {"run", "tower", "--frames", "many"}, "not \"many\""},
        Refusal{"framesWithUnit", {"compare", "tower", "--frames", "60s"}, "not \"60s\""},
        Refusal{"halfAFrame", {"run", "tower", "--frames", "1.5"}, "not \"1.5\""},
        Refusal{"tooManyFrames", {"run", "tower", "--frames", "99999999999"}, "not \"99999999999\""},
        Refusal{"noFrames", {"run", "tower", "--frames"}, "--frames"},
        Refusal{"negativeSeed", {"run", "tower", "--seed", "-1"}, "--seed: needs a whole number from 0"},
        Refusal{"noBudget", {"run", "tower", "--budget-ms", "0"}, "--budget-ms: needs a number above 0"},
        Refusal{"budgetNotANumber", {"run", "tower", "--budget-ms", "nan"}, "not \"nan\""},
        Refusal{"endlessBudget", {"run", "tower", "--budget-ms", "inf"}, "not \"inf\""},
        Refusal{"noRetries", {"run", "tower", "--retry-interval", "0"}, "--retry-interval"},
        Refusal{"tooNear", {"run", "tower", "--proximity-steps", "-1"}, "needs a number from 0"},
        Refusal{"negativeLoad", {"run", "tower", "--load-fine-pairs", "-1"}, "--load-fine-pairs"},
        Refusal{"noUnits", {"run", "tower", "--budget-units", "0"}, "--budget-units: needs a number above 0"},
        Refusal{"noScale", {"families", "--out", "f", "--scale", "0"}, "--scale"},
        Refusal{"wordAsFamilySeed", {"families", "--out", "f", "--seeds", "1,two"}, "not \"two\""},
        Refusal{"hugeFamilySeed",
                {"families", "--out", "f", "--seeds", "9000000000000001"},
                "the seed of a family must be at most"},
        Refusal{"noCreditLevel", {"run", "tower", "--credit-level", "0"}, "--credit-level"},
        Refusal{"noSamples", {"run", "tower", "--fidelity", "0"}, "--fidelity: needs a whole number from 1"},
        Refusal{"noVerification", {"run", "tower", "--verify-contacts", "0"}, "needs a whole number from 1"},
        Refusal{
            "cutFramesWithoutCut", {"bench", "budget", "--cut-frames", "9"}, "--cut-frames says how long"},
        Refusal{"seedsOfNoScene",
                {"bench", "budget", "--scene-seeds", "2"},
                "--scene-seeds are those of --scenes"},
        Refusal{"overIntoAFolder", {"bench", "budget", "--over", "."}, "--over \".\" does not name a file"},
        Refusal{"cutByTheClock", {"bench", "budget", "--cut", "2", "--clock"}, "--cut has no meaning"},
        Refusal{"cutOnAMachine", {"bench", "budget", "--cut", "2", "--machine", "m.csv"}, "with --machine"},
        Refusal{"clockAndMachine", {"bench", "budget", "--clock", "--machine", "m.csv"}, "one of them"},
        Refusal{"noMachine",
                {"bench", "budget", "--scenes", "duel", "--machine", "none.csv"},
                "--machine: cannot read none.csv"},
        Refusal{"budgetSeedsWithoutFamily",
                {"bench", "budget", "--scenes", "duel", "--seeds", "2"},
                "--seeds has no meaning here"},
        Refusal{"budgetOfNoFloor", {"bench", "budget", "--floors", "0"}, "--floors"},
        Refusal{"budgetOfUnknownWorld", {"bench", "budget", "--world", "hybird"}, "did you mean \"hybrid\""},
        Refusal{"noSeeds", {"bench", "spread", "--seeds", "0"}, "--seeds"},
        Refusal{"sceneAndFamily",
                {"bench", "spread", "--scene", "duel", "--family", "wall"},
                "leave one of them out"},
        Refusal{"unknownFamily", {"bench", "spread", "--family", "wals"}, "did you mean \"wall\""},
        Refusal{"scaleWithoutFamily", {"bench", "spread", "--scale", "2"}, "goes with --family"},
        Refusal{"memoryOfNoFrames", {"bench", "memory", "--every", "0"}, "--every"},
        Refusal{"levelsOfNoMesh", {"bench", "levels"}, "MESH is required"},
        Refusal{"levelsOfMissingMesh", {"bench", "levels", "nowhere.obj"}, "nowhere.obj"},
        Refusal{"programWithoutPlaces",
                {"bench", "levels", "x.obj", "--program", "hacd=hacd_parts"},
                "with {mesh} and {hulls} in the command"},
        Refusal{"programOfNoParts",
                {"bench", "levels", "x.obj", "--program", "hacd@0={mesh} {hulls}"},
                "is not understood"},
        Refusal{"nobodysLevels", {"bench", "levels", "x.obj", "--others-only"}, "without --program"},
        Refusal{"noBenchRepeats", {"bench", "collision", "--repeat", "0"}, "--repeat"},
        Refusal{"neverVerified", {"bench", "contacts", "--verify-every", "0"}, "--verify-every"},
        Refusal{"csvIntoAFolder", {"bench", "collision", "--csv", "/tmp"}, "does not name a file"},
        Refusal{"csvBelowAFile", {"bench", "spread", "--csv", "/dev/null/x"}, "choose another folder"},
        Refusal{"noRepeats", {"compare", "tower", "--repeat", "0"}, "--repeat"}),
    refusalName);

class BadFolder : public ProgramTest, public testing::WithParamInterface<const char*> {};

// So many frames that a check after the run would time out.
TEST_P(BadFolder, IsRefusedBeforeTheRun) {
  for (const char* command : {"run", "compare"}) {
    expectRefused(scatter({command, "tower", "--frames", "50000000", "--out", GetParam()}),
                  "choose another folder");
  }
}

INSTANTIATE_TEST_SUITE_P(Paths, BadFolder,
                         testing::Values("/proc/x", "/dev/full", "/dev/full/x", SCATTER_PROGRAM,
                                         SCATTER_PROGRAM "/below/a/file"));

// Else it would be replaced by a file.
TEST_F(ProgramTest, ARecordingIntoAPipeIsRefused) {
  const fs::path pipe = fs::temp_directory_path() / (folder.filename().string() + ".pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  expectRefused(scatter({"run", "tower", "--frames", "50000000", "--record", pipe.string()}),
                "is a device or a pipe; choose the name of a file");
  EXPECT_TRUE(fs::is_fifo(pipe));
  fs::remove(pipe);
}

TEST_F(ProgramTest, AFolderWithoutANameIsRefused) {
  expectRefused(scatter({"run", "tower", "--out", ""}), "the output folder has no name");
}

TEST_F(ProgramTest, ARecordingThatCannotBeReplayedIsRefused) {
  const struct {
    const char* content;
    const char* message;
  } recordings[] = {
      {"", "no column budget_units"},
      {"frame,budget_ms\n1,16\n", "no column budget_units"},
      {"frame,budget_units\n", "has no frames"},
      {"frame,budget_units\n1,30\n2,many\n", "line 3"},
      {"frame,budget_units\n1,30\n2\n", "line 3"},
      {"frame,budget_units\n1,-3\n", "budget_units below 0"},
      {"budget_units,settled_units\n30,-1\n", "settled_units below 0"},
      {"budget_units,settled_units\n30,30\n30,\n", "line 3"},
      {"budget_units,revised_units\n30,-1\n", "revised_units below 0"},
      {"frame,budget_units\n1,0\n2,0\n", "had no budget"},
  };
  const fs::path file = fs::temp_directory_path() / (folder.filename().string() + ".csv");
  for (const auto& recording : recordings) {
    std::ofstream(file, std::ios::trunc) << recording.content;
    expectRefused(scatter({"run", "tower", "--frames", "5", "--replay", file.string()}), recording.message);
  }
  fs::remove(file);
}

TEST_F(ProgramTest, AMissingGnuplotIsFoundBeforeTheRun) {
  const Outcome outcome = runProgram({.arguments = {"compare", "tower", "--frames", "50000000"},
                                      .folder = folder,
                                      .environment = {{"PATH", folder.string()}}});
  expectRefused(outcome, "gnuplot-nox");
}

struct Breakage {
  const char* name;
  std::vector<std::string>
      after;         ///< Stand before the place in hunter.dae, in this order; none: all is replaced.
  const char* text;  ///< What is there instead of all until the next tag.
  const char* message;
};

class BrokenModel : public ProgramTest, public testing::WithParamInterface<Breakage> {
 protected:
  /// A folder with a copy of the Hunter's model that is broken as the parameter says.
  [[nodiscard]] fs::path breakModel() const {
    std::string text = readText(fs::path(SCATTER_TEST_MODEL_DIR) / "hunter.dae");
    std::size_t from = 0;
    for (const std::string& mark : GetParam().after) {
      from = text.find(mark, from);
      EXPECT_NE(from, std::string::npos);
      from += mark.size();
    }
    const std::size_t to = GetParam().after.empty() ? text.size() : text.find('<', from);
    text.replace(from, to - from, GetParam().text);
    const fs::path models = folder / "models";
    fs::create_directory(models);
    std::ofstream(models / "hunter.dae") << text;
    return models;
  }
};

TEST_P(BrokenModel, IsRefusedInOneLineThatNamesTheFile) {
  const fs::path models = breakModel();
  fs::create_directory(folder / "work");
  for (const char* command : {"run", "compare"}) {
    const Outcome outcome = runProgram({.arguments = {command, "duel", "--frames", "5", "--out", "out"},
                                        .folder = folder / "work",
                                        .environment = {{"SCATTER_MODEL_PATH", models.string()}}});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(linesOf(outcome.errors).size(), 1U) << outcome.errors;
    EXPECT_THAT(outcome.errors, testing::StartsWith("scatter: "));
    EXPECT_THAT(outcome.errors, testing::HasSubstr((models / "hunter.dae").string()));
    EXPECT_THAT(outcome.errors, testing::ContainsRegex(GetParam().message));
    EXPECT_TRUE(fs::is_empty(folder / "work"));
  }
}

std::string breakageName(const testing::TestParamInfo<Breakage>& info) {
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Kinds, BrokenModel,
                         testing::Values(Breakage{"notXml", {}, "<COLLADA", "XML"},
                                         Breakage{"empty", {}, "", "XML"},
                                         Breakage{"tagNotClosed", {"<mass>"}, "1000</mas>", "XML"},
                                         Breakage{"negativeMass", {"<mass>"}, "-1", "<mass>: -1"},
                                         Breakage{"massNotANumber", {"<mass>"}, "nan", "<mass>: .*nan"},
                                         Breakage{"notNested",
                                                  {"<level index=\"1\">", "<half_extents>"},
                                                  "2 0.5 1",
                                                  "sticks out of level 1 by [0-9.]+ m"}),
                         breakageName);

}  // namespace
}  // namespace scatter::test
