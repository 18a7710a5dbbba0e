#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <vector>

#include "command.h"
#include "messages.h"

namespace scatter::app {

namespace {

ExitStatus executeGiven(const std::vector<Command>& commands) {
  const auto given = std::find_if(commands.begin(), commands.end(),
                                  [](const Command& command) { return command.arguments->parsed(); });
  if (given == commands.end()) {
    printError("a levels command is needed: build, check, show or export; see scatter levels --help");
    return ExitStatus::kBadInput;
  }
  return given->execute();
}

}  // namespace

Command addLevelsCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "levels",
      "Make nested levels from a mesh, prove them, measure them, and write them for other programs");
  const std::vector<Command> commands{addLevelsBuildCommand(*command), addLevelsCheckCommand(*command),
                                      addLevelsShowCommand(*command), addLevelsExportCommand(*command)};
  return {command, [commands] { return executeGiven(commands); }};
}

}  // namespace scatter::app
