#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <vector>

#include "command.h"
#include "messages.h"

namespace scatter::app {

namespace {

struct Bench {
  std::vector<Command> commands;
  bool list = false;
};

ExitStatus execute(const Bench& bench) {
  const auto given = std::find_if(bench.commands.begin(), bench.commands.end(),
                                  [](const Command& command) { return command.arguments->parsed(); });
  if (given != bench.commands.end()) {
    return given->execute();
  }
  if (!bench.list) {
    printError("a bench command is needed; see scatter bench --list");
    return ExitStatus::kBadInput;
  }
  for (const Command& command : bench.commands) {
    fmt::print("{:<10}  {}\n", command.arguments->get_name(), command.arguments->get_description());
  }
  return ExitStatus::kOk;
}

}  // namespace

Command addBenchCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand("bench", "Measure what the parts of the technique are worth");
  auto bench = std::make_shared<Bench>();
  command->add_flag("--list", bench->list, "Show what can be measured");
  bench->commands = {addBenchCollisionCommand(*command), addBenchContactsCommand(*command),
                     addBenchSpreadCommand(*command),    addBenchWorldsCommand(*command),
                     addBenchFidelityCommand(*command),  addBenchMemoryCommand(*command),
                     addBenchBudgetCommand(*command),    addBenchLevelsCommand(*command)};
  return {command, [bench] { return execute(*bench); }};
}

}  // namespace scatter::app
