#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "apps/program.h"

namespace scatter::test {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;

class View : public ProgramTest {
 protected:
  [[nodiscard]] std::string mistake(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "view");
    const Outcome outcome = scatter(std::move(arguments));
    EXPECT_EQ(outcome.status, 2) << outcome.output << outcome.errors;
    return outcome.errors;
  }
};

void writeText(const fs::path& file, const std::string& text) {
  std::ofstream(file) << text;
}

/// The last word of the line that has the key.
std::string lastWord(const std::string& text, const std::string& key) {
  const std::size_t line = text.find(key);
  const std::size_t end = text.find('\n', line);
  const std::string found = text.substr(line, end - line);
  return found.substr(found.find_last_of(' ') + 1);
}

TEST_F(View, WithoutADisplayGivesTheStateThatRunGives) {
  const Outcome seen =
      scatter({"view", "duel", "--renderer", "null", "--loops", "241", "--views", "levels,contacts"});
  ASSERT_EQ(seen.status, 0) << seen.errors;
  EXPECT_THAT(seen.output, HasSubstr("hybrid: 240 frames"));
  const Outcome alone = scatter({"run", "duel", "--frames", "240", "--quiet"});
  EXPECT_EQ(lastWord(seen.output, "hybrid: 240"), lastWord(alone.output, "state hash of the last frame"));
}

TEST_F(View, HelpIsThatOfTheWindow) {
  const Outcome outcome = scatter({"view", "--help"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.errors, "");
  EXPECT_THAT(outcome.output,
              testing::AllOf(HasSubstr("scatter view"), HasSubstr("--renderer"), HasSubstr("--budget-ms")));
}

TEST_F(View, DoesWhatItsScriptSaysInTwoWorlds) {
  writeText(folder / "s.txt", "10 do pause\n20 do write\n21 close\n");
  const Outcome seen = scatter({"view", "tower", "--renderer", "null", "--worlds", "standard,hybrid",
                                "--script", "s.txt", "--out", "seen"});
  ASSERT_EQ(seen.status, 0) << seen.errors;
  EXPECT_THAT(seen.output, HasSubstr("standard: 10 frames"));
  EXPECT_TRUE(fs::exists(folder / "seen" / "hybrid" / "frames.csv"));
  EXPECT_TRUE(fs::exists(folder / "seen" / "standard" / "summary.json"));
}

TEST_F(View, SaysWhatFailedWhateverIsWrittenLater) {
  writeText(folder / "s.txt", "1 do write\n5 do screenshot\n9 close\n");
  const Outcome seen = scatter({"view", "duel", "--renderer", "null", "--script", "s.txt"});
  EXPECT_EQ(seen.status, 1);
  EXPECT_THAT(seen.errors, HasSubstr("no frame yet"));
  EXPECT_TRUE(fs::exists(folder / "out" / "view" / "screenshot-1.png"));
}

TEST_F(View, ShowsTheLevelsOfAModelUnlessTheSceneIsAskedFor) {
  const std::string mug = std::string(SCATTER_MODELS) + "/mug.dae";
  const Outcome levels = scatter({"view", mug, "--renderer", "null", "--loops", "4"});
  ASSERT_EQ(levels.status, 0) << levels.errors;
  EXPECT_EQ(levels.output, "4 loops\n");
  const Outcome scene = scatter({"view", mug, "--renderer", "null", "--loops", "4", "--show", "scene"});
  ASSERT_EQ(scene.status, 0) << scene.errors;
  EXPECT_THAT(scene.output, HasSubstr("hybrid: 3 frames"));
  EXPECT_THAT(mistake({"duel", "--renderer", "null", "--show", "levels"}), HasSubstr("duel"));
  EXPECT_THAT(mistake({"none.dae", "--renderer", "null"}), HasSubstr("none.dae"));
  EXPECT_THAT(mistake({mug, "--renderer", "null", "--show", "all"}), HasSubstr("--show"));
}

TEST_F(View, RefusesWhatIsWrongInOneLine) {
  EXPECT_THAT(mistake({"duel", "--renderer", "crayon"}), HasSubstr("crayon"));
  EXPECT_THAT(mistake({"duel", "--renderer", "null", "--size", "big"}), HasSubstr("such as 1280x720"));
  EXPECT_THAT(mistake({"duel", "--renderer", "null", "--worlds", "standard,hybrid,finest"}),
              HasSubstr("two side by side"));
  EXPECT_THAT(mistake({"duel", "--renderer", "null", "--samples", "3"}), HasSubstr("--samples"));
  EXPECT_THAT(mistake({"duel", "--renderer", "null", "--screenshot", "a.png"}), HasSubstr("--loops"));
  EXPECT_THAT(mistake({"duel", "--renderer", "null", "--script", "none.txt"}), HasSubstr("none.txt"));
  EXPECT_THAT(mistake({"dule", "--renderer", "null"}), HasSubstr("did you mean \"duel\"?"));
  writeText(folder / "s.txt", "1 jump\n");
  EXPECT_THAT(mistake({"duel", "--renderer", "null", "--script", "s.txt"}), HasSubstr("s.txt: line 1"));
}

}  // namespace
}  // namespace scatter::test
