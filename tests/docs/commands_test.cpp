#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "docs/command_table.h"
#include "docs/page.h"

namespace scatter::test {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string>& pages() {
  static const std::vector<std::string> names{"README.md", "docs/report-map.md", "docs/report-tests.md"};
  return names;
}

std::set<std::string> commandsOfAllPages() {
  std::set<std::string> commands;
  for (const std::string& name : pages()) {
    const auto ofPage = commandsOf(readPage(name));
    commands.insert(ofPage.begin(), ofPage.end());
  }
  return commands;
}

std::set<std::string> commandsOfTheTable() {
  std::set<std::string> commands;
  for (const PageCommand& command : pageCommands()) {
    commands.insert(command.command);
  }
  return commands;
}

TEST(PageCommands, AreFoundInBackticksAndCode) {
  EXPECT_THAT(
      commandsOf("Call `scatter run x --out d` or `scatter`, not `make`.\n"
                 "```\n./run     # all\nscatter list   what there is\n  ./test --lint\nsudo x\n```\n"
                 "`scatter list` again, `./run ARGS`"),
      testing::ElementsAre("scatter run x --out d", "./run", "scatter list", "./test --lint", "./run ARGS"));
}

TEST(PageCommands, AreAllInTheTable) {
  std::vector<std::string> unknown;
  const auto onPages = commandsOfAllPages();
  const auto known = commandsOfTheTable();
  std::set_difference(onPages.begin(), onPages.end(), known.begin(), known.end(),
                      std::back_inserter(unknown));
  EXPECT_THAT(unknown, testing::IsEmpty()) << "give them a call and a check in tests/docs/command_table.cpp";
}

TEST(PageCommands, TheTableHasNoOthers) {
  EXPECT_EQ(commandsOfTheTable().size(), pageCommands().size()) << "a command has two entries";
  std::vector<std::string> stale;
  const auto onPages = commandsOfAllPages();
  const auto known = commandsOfTheTable();
  std::set_difference(known.begin(), known.end(), onPages.begin(), onPages.end(), std::back_inserter(stale));
  EXPECT_THAT(stale, testing::IsEmpty()) << "no page has them: take them out of tests/docs/command_table.cpp";
}

class CalledCommand : public ProgramTest, public testing::WithParamInterface<PageCommand> {
 protected:
  // What the pages' examples begin with: the models, a mesh, a file of levels, a scene.
  void prepare(const std::string& call) const {
    const fs::path source(SCATTER_SOURCE_DIR);
    fs::create_directory_symlink(source / "models", folder / "models");
    fs::copy_file(source / "scenes/tower.toml", folder / "my.toml");
    std::ofstream(folder / "ship.obj") << "v 0 0 0\nv 2 0 0\nv 0 1 0\nv 0 0 1\n"
                                          "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    if (call.find("build") == std::string::npos) {
      fs::copy_file(source / "models/hunter.dae", folder / "ship.dae");
    }
  }

  [[nodiscard]] Outcome call(const std::string& text) const {
    std::vector<std::string> words = wordsOf(text);
    Start start{.arguments = {}, .folder = folder};
    if (words.front() == "./test") {
      start.program = fs::path(SCATTER_SOURCE_DIR) / "test";
    }
    if (words.front() == "./test" || words.front() == "scatter") {
      words.erase(words.begin());
    }
    start.arguments = std::move(words);
    return runProgram(start);
  }
};

TEST_P(CalledCommand, ShowsWhatThePageSays) {
  const PageCommand& command = GetParam();
  if (command.needsWindow() && !SCATTER_TEST_VIEWER) {
    GTEST_SKIP() << "this build has no window";
  }
  const std::string text = command.call.empty() ? command.command : command.call;
  prepare(text);
  const Called called{.outcome = call(text), .folder = folder};
  ASSERT_EQ(called.outcome.status, 0) << text << '\n' << called.outcome.output << called.outcome.errors;
  ASSERT_TRUE(command.check) << "nothing is checked";
  command.check(called);
}

std::string nameOfCase(const testing::TestParamInfo<PageCommand>& info) {
  std::string name = std::to_string(info.index) + "_";
  for (const char c : info.param.command) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      name += c;
    }
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(Pages, CalledCommand, testing::ValuesIn(pageCommands()), nameOfCase);

}  // namespace
}  // namespace scatter::test
