#pragma once

#include <scatter/lab/run.h>
#include <scatter/result.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "choices.h"
#include "switching_arguments.h"

namespace CLI {
class App;
}

namespace scatter::app {

/// The arguments that say how a scene is run, as they stand on the command line.
struct RunArguments {
  std::string scene;
  std::string engine = engineChoices().front().name;
  SwitchingArguments switching;
  std::optional<std::string> collision;
  std::optional<std::string> solver;
  std::optional<int> contactsPerDirection;
  std::optional<float> recycling;  ///< Millimetres.
  std::optional<int> verifyEvery;
  std::optional<int> fidelityEvery;
  std::optional<int> frames;
  std::optional<std::uint64_t> seed;
  std::optional<int> threads;
  std::optional<std::string> script;  ///< A file.
  bool noProfiling = false;
  bool quiet = false;
};

/// `arguments` must outlive the parsing.
void addRunArguments(CLI::App& command, RunArguments& arguments);

/// --script FILE, of commands without a window.
void addScriptArgument(CLI::App& command, RunArguments& arguments);

/// Frames from one measurement of fidelity to the next, if it is asked for without a number.
inline constexpr int kFidelityEvery = 10;

/// --fidelity [N]. `every` must outlive the parsing.
void addFidelityArgument(CLI::App& command, std::optional<int>& every);

/// One run for each of the named worlds (see parseWorld()). Fails on an unknown name and on an argument that
/// has no meaning in any of the worlds. Prints the scene's warnings.
[[nodiscard]] Result<std::vector<RunOptions>> makeRuns(const RunArguments& arguments,
                                                       const std::vector<std::string>& worlds);

}  // namespace scatter::app
