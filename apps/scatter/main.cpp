#include <string>
#include <utility>
#include <vector>

#include "program.h"

namespace scatter::app {

namespace {

std::vector<std::string> wordsFrom(int first, int argc, char** argv) {
  return argc > first ? std::vector<std::string>(argv + first, argv + argc) : std::vector<std::string>();
}

std::vector<Command> addCommands(CLI::App& program, const std::string& commandLine,
                                 std::vector<std::string> wordsForView) {
  return {addListCommand(program),
          addRunCommand(program),
          addCompareCommand(program, commandLine),
          addReplayCommand(program),
          addDiffCommand(program),
          addExportCommand(program),
          addReportTestCommand(program),
          addLevelsCommand(program),
          addConvertCommand(program),
          addFamiliesCommand(program),
          addBenchCommand(program),
          addViewLauncher(program, std::move(wordsForView))};
}

}  // namespace

}  // namespace scatter::app

int main(int argc, char** argv) {
  using namespace scatter::app;
  return runProgram(argc, argv, [&](CLI::App& program, const std::string& commandLine) {
    return addCommands(program, commandLine, wordsFrom(2, argc, argv));
  });
}
