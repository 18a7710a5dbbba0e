#pragma once

#include <scatter/lab/run.h>
#include <scatter/result.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "choices.h"

namespace CLI {
class App;
}

namespace scatter::app {

/// The arguments that say how a scene is run, as they stand on the command line.
struct RunArguments {
  std::string scene;
  std::string engine = engineChoices().front().name;
  std::string switching = switchingChoices().front().name;
  std::optional<std::string> policy;
  std::optional<std::string> collision;
  std::optional<int> verifyEvery;
  std::optional<int> frames;
  std::uint64_t seed = 1;
  double budgetMs = 1000.0 / 60.0;
  std::optional<int> retryInterval;
  std::optional<float> proximitySteps;
  std::optional<std::uint32_t> loadFinePairs;
  bool noProfiling = false;
  bool unsafeSwitching = false;
  bool quiet = false;
};

/// `arguments` must outlive the parsing.
void addRunArguments(CLI::App& command, RunArguments& arguments);

/// One run for each of the named worlds. Fails on an unknown name and on an argument that has no meaning in
/// any of the worlds.
[[nodiscard]] Result<std::vector<RunOptions>> makeRuns(const RunArguments& arguments,
                                                       const std::vector<std::string>& worlds);

}  // namespace scatter::app
