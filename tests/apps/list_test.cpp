#include <gmock/gmock.h>

#include <filesystem>

#include "apps/program.h"

namespace scatter::test {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;

TEST_F(ProgramTest, ListShowsEverythingThatCanBeNamed) {
  const Outcome outcome = scatter({"list"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.errors, "");
  for (const char* name : {"armada",        "convergence", "duel",          "fleet",        "fleet_boxes",
                           "pile",          "quiet_apart", "quiet_hybrids", "quiet_stacks", "tower",
                           "standard",      "hybrid",      "finest-bullet", "proximity",    "finest",
                           "coarsest",      "none",        "body",          "pair",         "hybrid-body",
                           "coarsest-body", "speed",       "from=",         "bullet 3",     "--collision"}) {
    EXPECT_THAT(outcome.output, HasSubstr(name));
  }
}

TEST_F(ProgramTest, ListShowsHowLongAScenesStoryIs) {
  EXPECT_THAT(scatter({"list"}).output, testing::ContainsRegex("tower .*\\([0-9]+ frames\\)"));
}

TEST_F(ProgramTest, EveryCommandHasHelp) {
  for (const char* command : {"list", "run", "compare", "convert", "bench"}) {
    const Outcome outcome = scatter({command, "--help"});
    EXPECT_EQ(outcome.status, 0) << command;
    EXPECT_EQ(outcome.errors, "");
    EXPECT_THAT(outcome.output, HasSubstr(std::string("scatter ") + command));
  }
  const Outcome outcome = scatter({"--help"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.output,
              testing::AllOf(HasSubstr("list"), HasSubstr("run"), HasSubstr("compare"), HasSubstr("bench")));
}

TEST_F(ProgramTest, WhatIsReadFitsATerminal) {
  const std::vector<std::vector<std::string>> calls{{"list"},
                                                    {"--help"},
                                                    {"run", "--help"},
                                                    {"compare", "--help"},
                                                    {"convert", "--help"},
                                                    {"levels", "build", "--help"},
                                                    {"levels", "show", "--help"},
                                                    {"bench", "--help"},
                                                    {"replay", "--help"},
                                                    {"diff", "--help"},
                                                    {"export", "--help"},
                                                    {"bench", "fidelity", "--help"}};
  for (const auto& call : calls) {
    for (const std::string& line : linesOf(scatter(call).output)) {
      EXPECT_LE(line.size(), 80U) << testing::PrintToString(call) << '\n' << line;
    }
  }
}

TEST_F(ProgramTest, TheWindowIsListedWhereverItIsBuilt) {
  EXPECT_THAT(scatter({"--help"}).output, testing::ContainsRegex("\n  view +Open a scene"));
  EXPECT_EQ(scatter({"--help", "view"}).status, 0);
}

TEST_F(ProgramTest, WithoutTheWindowsProgramViewSaysHowToBuildIt) {
  const fs::path alone = fs::temp_directory_path() / (folder.filename().string() + "-alone");
  fs::create_directory(alone);
  fs::copy_file(SCATTER_PROGRAM, alone / "scatter");
  const Outcome outcome =
      runProgram({.arguments = {"view", "duel"}, .folder = folder, .program = alone / "scatter"});
  expectRefused(outcome, "./run view builds it");
  fs::remove_all(alone);
}

TEST_F(ProgramTest, VersionIsOneLine) {
  const Outcome outcome = scatter({"--version"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.output, testing::MatchesRegex("scatter [0-9]+\\.[0-9]+\\.[0-9]+ .*\n"));
}

TEST_F(ProgramTest, AFullDiskBehindStandardOutputIsNotASuccess) {
  const Outcome outcome = runProgram({.arguments = {"list"}, .folder = folder, .outputTo = "/dev/full"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.errors, "scatter: cannot write to standard output; is the disk full?\n");
}

}  // namespace
}  // namespace scatter::test
