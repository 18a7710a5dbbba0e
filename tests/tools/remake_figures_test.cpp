#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "apps/program.h"

namespace scatter::test {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;
using testing::IsEmpty;

const fs::path kSource = SCATTER_SOURCE_DIR;

void writeText(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

void writeScript(const fs::path& file, const std::string& text) {
  writeText(file, "#!/bin/bash\n" + text);
  fs::permissions(file, fs::perms::owner_all);
}

std::vector<fs::path> filesIn(const fs::path& folder, const std::string& extension) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == extension) files.push_back(entry.path());
  }
  return files;
}

std::vector<fs::path> pages() {
  std::vector<fs::path> all = filesIn(kSource / "docs", ".md");
  all.push_back(kSource / "README.md");
  return all;
}

/// The commands of the tables that are marked in a page.
std::vector<std::string> commandsIn(const fs::path& page) {
  const std::string begin = "<!-- made by: ";
  std::vector<std::string> commands;
  for (const std::string& line : linesOf(readText(page))) {
    if (line.rfind(begin, 0) == 0)
      commands.push_back(line.substr(begin.size(), line.find(" -->") - begin.size()));
  }
  return commands;
}

/// The files that parts make.
std::set<std::string> madeFiles() {
  const Outcome outcome = runProgram({.arguments = {"--files"}, .folder = "/"});
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  std::set<std::string> files;
  for (const std::string& line : linesOf(outcome.output)) files.insert(line.substr(line.find('\t') + 1));
  return files;
}

TEST(RemakeFigures, HasAPartForEveryPictureAndResult) {
  const std::set<std::string> made = madeFiles();
  for (const fs::path& picture : filesIn(kSource / "docs/images", ".png")) {
    EXPECT_EQ(made.count("docs/images/" + picture.filename().string()), 1U) << picture;
  }
  for (const fs::path& result : filesIn(kSource / "bench/results", ".csv")) {
    EXPECT_EQ(made.count("bench/results/" + result.filename().string()), 1U) << result;
  }
}

TEST(RemakeFigures, HasAPartForTheResultsOfEveryMarkedTable) {
  const std::set<std::string> made = madeFiles();
  std::size_t tables = 0;
  for (const fs::path& page : pages()) {
    for (const std::string& command : commandsIn(page)) {
      const std::size_t at = command.find("bench/results/");
      ASSERT_NE(at, std::string::npos) << page << ": " << command;
      EXPECT_EQ(made.count(command.substr(at, command.find(' ', at) - at)), 1U) << page << ": " << command;
      ++tables;
    }
  }
  EXPECT_GE(tables, 5U);
}

TEST(RemakeFigures, RefusesAnUnknownPart) {
  const Outcome outcome = runProgram({.arguments = {"flet"}, .folder = "/"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.errors, HasSubstr("unknown part \"flet\"; known are: overview"));
}

/// The program in a tree of its own, with a program `scatter` that a test writes.
class RemakeFiguresInATree : public ProgramTest {
 protected:
  void SetUp() override {
    fs::create_directories(folder / "bench");
    fs::create_directories(folder / "docs/images");
    for (const char* part : {"tools", "bench/tables", "bench/results", "bench/levels"}) {
      fs::copy(kSource / part, folder / part, fs::copy_options::recursive);
    }
    writeText(folder / "README.md", "# Readme\n");
    writeText(page_, "# Page\n");
    writeScript(folder / "tools/build.sh", "exit 0\n");
  }

  [[nodiscard]] Outcome remake(const std::string& what) const {
    return runProgram({.arguments = {what}, .folder = "/", .program = folder / "tools/remake_figures"});
  }

  void writeScatter(const std::string& script) const {
    writeScript(folder / "build/release/apps/scatter/scatter", script);
  }

  const fs::path page_ = folder / "docs/page.md";
};

TEST_F(RemakeFiguresInATree, FindsThePagesAsTheirResultsMakeThem) {
  for (const fs::path& page : pages()) {
    const fs::path copy = folder / fs::relative(page, kSource);
    fs::copy_file(page, copy, fs::copy_options::overwrite_existing);
  }
  const Outcome outcome = remake("--tables");
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  for (const fs::path& page : pages()) {
    EXPECT_EQ(readText(folder / fs::relative(page, kSource)), readText(page))
        << "call tools/remake_figures --tables";
  }
}

TEST_F(RemakeFiguresInATree, ReplacesATableByWhatItsCommandPrints) {
  writeScript(folder / "tools/count", "echo \"| $1 |\"\n");
  writeText(page_, "a\n<!-- made by: tools/count 7 -->\nold\nrows\n<!-- end -->\nb");
  EXPECT_EQ(remake("--tables").status, 0);
  EXPECT_EQ(readText(page_), "a\n<!-- made by: tools/count 7 -->\n| 7 |\n<!-- end -->\nb\n");
}

TEST_F(RemakeFiguresInATree, KeepsATableWhoseCommandFails) {
  writeScript(folder / "tools/broken", "echo '| half |'\nexit 1\n");
  const std::string text = "<!-- made by: tools/broken -->\nold\n<!-- end -->\n";
  writeText(page_, text);
  const Outcome outcome = remake("--tables");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.errors, HasSubstr("docs/page.md: \"tools/broken\" failed"));
  EXPECT_EQ(readText(page_), text);
}

TEST_F(RemakeFiguresInATree, KeepsATableWithoutResults) {
  const std::string text =
      "<!-- made by: bench/tables/worlds bench/results/none.csv finest -->\nold\n<!-- end -->\n";
  writeText(page_, text);
  const Outcome outcome = remake("--tables");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.errors, HasSubstr("there are no results"));
  EXPECT_EQ(readText(page_), text);
}

TEST_F(RemakeFiguresInATree, RunsNothingButProgramsOfTheTree) {
  const std::string text = "<!-- made by: touch ran -->\nold\n<!-- end -->\n";
  writeText(page_, text);
  EXPECT_EQ(remake("--tables").status, 1);
  EXPECT_EQ(readText(page_), text);
  EXPECT_FALSE(fs::exists(folder / "ran"));
}

TEST_F(RemakeFiguresInATree, KeepsAPageWhoseTableDoesNotEnd) {
  const std::string text = "<!-- made by: tools/remake_figures --files -->\nold\n";
  writeText(page_, text);
  const Outcome outcome = remake("--tables");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.errors, HasSubstr("has no line <!-- end -->"));
  EXPECT_EQ(readText(page_), text);
}

TEST_F(RemakeFiguresInATree, PutsWhatAPartMakesInItsPlace) {
  writeScatter("[[ $2 != show ]] || echo new > \"${@: -1}\"\n");
  writeText(folder / "docs/images/levels_hunter.png", "old\n");
  const Outcome outcome = remake("levels_picture");
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_EQ(readText(folder / "docs/images/levels_hunter.png"), "new\n");
}

TEST_F(RemakeFiguresInATree, KeepsTheFilesOfAPartThatFails) {
  writeText(folder / "docs/images/levels_hunter.png", "old\n");
  writeScatter("echo 'no such mesh' >&2\nexit 2\n");
  Outcome outcome = remake("levels_picture");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.errors, HasSubstr("no such mesh"));
  EXPECT_THAT(outcome.errors, HasSubstr("levels_picture could not be made"));
  EXPECT_EQ(readText(folder / "docs/images/levels_hunter.png"), "old\n");
  writeScatter("exit 0\n");
  outcome = remake("levels_picture");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.errors, HasSubstr("has not made levels_hunter.png"));
  EXPECT_EQ(readText(folder / "docs/images/levels_hunter.png"), "old\n");
}

TEST_F(RemakeFiguresInATree, LeavesNothingElseBehind) {
  writeScatter("exit 2\n");
  EXPECT_EQ(remake("levels_picture").status, 1);
  EXPECT_THAT(filesIn(folder / "docs/images", ".new"), IsEmpty());
  EXPECT_THAT(filesIn(folder / "docs", ".new"), IsEmpty());
}

}  // namespace
}  // namespace scatter::test
