#include <scatter/lab/output_folder.h>
#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "command.h"
#include "interrupt.h"
#include "messages.h"
#include "progress_line.h"
#include "record_arguments.h"
#include "run_arguments.h"
#include "run_report.h"

namespace scatter::app {

namespace {

struct RunCommandArguments {
  RunArguments run;
  std::string world = worldChoices().front().name;
  std::optional<std::string> out;
  RecordArguments record;
};

ExitStatus run(const RunCommandArguments& arguments) {
  auto runs = makeRuns(arguments.run, {arguments.world});
  if (!runs) {
    return refuse(runs.error());
  }
  if (auto applied = applyRecordArguments(arguments.record, /*several=*/false, *runs); !applied) {
    return refuse(applied.error());
  }
  RunOptions& options = runs->front();
  options.stop = [] { return interruptingSignal() != 0; };
  if (arguments.out) {
    options.out = *arguments.out;
    if (auto prepared = prepareOutputFolder(*options.out); !prepared) {
      return refuse(prepared.error());
    }
  }
  bool started = false;
  auto result = [&] {
    ProgressLine line(arguments.run.quiet);
    return runScene(options, [&](const RunProgress& progress) {
      started = true;
      line.update(fmt::format("{}, {} world", options.scene, options.label), progress);
    });
  }();
  if (!result) {
    return endedBy(result.error(), started);
  }
  const Summary& summary = result->summary;
  fmt::print("{}", formatSummary(summary));
  fmt::print("{}", formatBudget(*result));
  if (summary.fidelity.every > 0) {
    fmt::print("\n{}", formatFidelity(summary.fidelity));
  }
  if (summary.contactCheck.steps > 0) {
    fmt::print("{}", formatContactCheck(summary));
  }
  if (arguments.out) {
    fmt::print("\nevery frame: {0}/frames.csv\nlevel events: {0}/events.csv\nthe summary: {0}/summary.json\n",
               *arguments.out);
  }
  if (result->recording) {
    fmt::print("\n{}", formatRecording(*result));
  }
  if (!summary.stopped.empty()) {
    printError("this run is not whole: " + summary.stopped);
    return signalStatus();
  }
  return checkRecording(*result, summary.contactCheck.missed > 0 ? ExitStatus::kFailed : ExitStatus::kOk);
}

}  // namespace

Command addRunCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand("run", "Run a scene in one world");
  auto arguments = std::make_shared<RunCommandArguments>();
  addRunArguments(*command, arguments->run);
  addScriptArgument(*command, arguments->run);
  command
      ->add_option("--world", arguments->world,
                   "hybrid, standard, finest, coarsest and more; see `scatter list`")
      ->type_name("NAME")
      ->capture_default_str();
  command
      ->add_option("--out", arguments->out,
                   "Write frames.csv, events.csv and summary.json into this folder, frame by frame")
      ->type_name("DIR");
  addRecordArguments(*command, arguments->record, /*several=*/false);
  return {command, [arguments] { return run(*arguments); }};
}

}  // namespace scatter::app
