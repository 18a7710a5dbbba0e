#pragma once

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace scatter::app {

enum class ExitStatus : int {
  kOk = 0,
  kFailed = 1,       ///< A run or a check failed, or a result could not be written because the disk is full.
  kBadInput = 2,     ///< Wrong usage, a file that cannot be read, a folder that cannot be written.
  kSignalled = 128,  ///< Plus the signal that ended it.
};

/// A subcommand of the program.
struct Command {
  CLI::App* arguments = nullptr;  ///< Owned by the program's CLI::App.
  std::function<ExitStatus()> execute;

  /// Its words are not understood here: execute() hands them to the program that understands them.
  bool isAnotherProgram = false;
};

Command addListCommand(CLI::App& program);
Command addRunCommand(CLI::App& program);
Command addConvertCommand(CLI::App& program);
Command addFamiliesCommand(CLI::App& program);
Command addReplayCommand(CLI::App& program);
Command addDiffCommand(CLI::App& program);
Command addExportCommand(CLI::App& program);
Command addReportTestCommand(CLI::App& program);

/// The window, which is the program scatter-view beside this one. `words` are those after "view".
Command addViewLauncher(CLI::App& program, std::vector<std::string> words);

/// The window itself, in scatter-view.
Command addViewCommand(CLI::App& program);

/// `commandLine` is for the report.
Command addCompareCommand(CLI::App& program, std::string commandLine);

/// `levels` and the commands below it.
Command addLevelsCommand(CLI::App& program);
Command addLevelsBuildCommand(CLI::App& levels);
Command addLevelsCheckCommand(CLI::App& levels);
Command addLevelsExportCommand(CLI::App& levels);
Command addLevelsShowCommand(CLI::App& levels);

/// `bench` and the commands below it.
Command addBenchCommand(CLI::App& program);
Command addBenchBudgetCommand(CLI::App& bench);
Command addBenchCollisionCommand(CLI::App& bench);
Command addBenchContactsCommand(CLI::App& bench);
Command addBenchLevelsCommand(CLI::App& bench);
Command addBenchSpreadCommand(CLI::App& bench);
Command addBenchWorldsCommand(CLI::App& bench);
Command addBenchFidelityCommand(CLI::App& bench);
Command addBenchMemoryCommand(CLI::App& bench);

}  // namespace scatter::app
