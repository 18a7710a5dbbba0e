#pragma once

#include <scatter/lab/comparison.h>
#include <scatter/result.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "command.h"
#include "messages.h"

namespace scatter::app {

/// The arguments that all commands of `bench` take.
struct BenchArguments {
  std::optional<int> frames;
  std::optional<std::string> csv;
  bool quiet = false;
};

/// `arguments` must outlive the parsing.
void addBenchArguments(CLI::App& command, BenchArguments& arguments);
void addRepeatArgument(CLI::App& command, int& repeat);
void addSceneArgument(CLI::App& command, std::string& scene);

/// A run of the scene in the named world (see worldChoices()) as the arguments say. Fails on an unknown
/// scene.
[[nodiscard]] Result<RunOptions> makeBenchRun(const BenchArguments& arguments, const std::string& scene,
                                              const std::string& world);

/// 1 to `count`.
[[nodiscard]] std::vector<std::uint64_t> seedsUpTo(int count);

/// Proves, before the long run, that the CSV file can be written; nothing to do without one.
[[nodiscard]] Result<void> prepareCsv(const BenchArguments& arguments);

/// The same of a file that the option `name` names.
[[nodiscard]] Result<void> prepareCsv(const std::string& name, const std::optional<std::string>& csv);

/// Writes `text` into the file if there is one.
[[nodiscard]] Result<void> putCsv(const std::optional<std::string>& csv, const std::string& text);

/// The same, and says so: `what`: where. Status 2 if it cannot be written.
[[nodiscard]] ExitStatus writeCsv(const std::optional<std::string>& csv, const std::string& what,
                                  const std::string& text);

/// Prints `table`, and writes `csv` if the arguments name a file. Status 2 if it cannot be written.
[[nodiscard]] ExitStatus report(const BenchArguments& arguments, const std::string& table,
                                const std::string& csv);

/// Says on standard error how far the runs are, and ends them on an interrupt. `work` names the work.
[[nodiscard]] std::function<void(const CompareProgress&)> benchProgress(const BenchArguments& arguments,
                                                                        std::string work);

}  // namespace scatter::app
