#include <scatter/lab/comparison.h>
#include <scatter/lab/figures.h>
#include <scatter/lab/output_folder.h>
#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "command.h"
#include "interrupt.h"
#include "messages.h"
#include "progress_line.h"
#include "record_arguments.h"
#include "run_arguments.h"
#include "run_report.h"

namespace scatter::app {

namespace {

struct CompareArguments {
  RunArguments run;
  std::vector<std::string> worlds{"standard", "hybrid"};
  int repeat = 1;
  std::optional<std::string> out;
  bool resume = false;
  bool anew = false;
  bool without3d = false;
  RecordArguments record;
  std::string commandLine;
};

Result<Comparison> compareWithProgress(const CompareOptions& options, bool quiet, bool& started) {
  ProgressLine line(quiet);
  return compareWorlds(options, [&](const CompareProgress& progress) {
    started = true;
    line.update(fmt::format("{}, {} world, run {} of {}", options.runs.front().scene, progress.label,
                            progress.run + 1, progress.runs),
                progress.inside);
  });
}

// What can be known before the long run is checked before it.
Result<void> checkOutput(const std::filesystem::path& folder) {
  return checkGnuplot().and_then([&folder] { return prepareOutputFolder(folder); });
}

// Repeats are the same run: one of them speaks for all.
ExitStatus reportContactChecks(const Comparison& comparison) {
  ExitStatus status = ExitStatus::kOk;
  for (const ComparedWorld& world : comparison.worlds) {
    const Summary& summary = world.run().summary;
    if (summary.contactCheck.steps > 0) {
      fmt::print("{}", formatContactCheck(summary));
    }
    if (summary.contactCheck.missed > 0) {
      status = ExitStatus::kFailed;
    }
  }
  return status;
}

// Those of runs that were finished before, and are taken as they are, have been told of then.
ExitStatus reportRecordings(const Comparison& comparison, bool asked, ExitStatus status) {
  for (const ComparedWorld& world : comparison.worlds) {
    for (const Run& run : world.repeats) {
      if (!run.recording) {
        continue;
      }
      // The report's own are its matter, unless they failed.
      if (asked) {
        fmt::print("{}", formatRecording(run));
      }
      status = checkRecording(run, status);
    }
  }
  return status;
}

ExitStatus compare(const CompareArguments& arguments) {
  auto runs = makeRuns(arguments.run, arguments.worlds);
  if (!runs) {
    return refuse(runs.error());
  }
  if (auto applied = applyRecordArguments(arguments.record, /*several=*/true, *runs); !applied) {
    return refuse(applied.error());
  }
  for (RunOptions& run : *runs) {
    run.stop = [] { return interruptingSignal() != 0; };
  }
  const std::string out = arguments.out.value_or("out/" + runs->front().scene);
  if (auto writable = checkOutput(out); !writable) {
    return refuse(writable.error());
  }
  bool started = false;
  const auto comparison = compareWithProgress({.runs = std::move(*runs),
                                               .repeat = arguments.repeat,
                                               .commandLine = arguments.commandLine,
                                               .out = out,
                                               .recordRuns = !arguments.without3d && hasReportPage(),
                                               .resume = arguments.resume,
                                               .anew = arguments.anew},
                                              arguments.run.quiet, started);
  if (!comparison) {
    return endedBy(comparison.error(), started);
  }
  if (auto written = writeComparison(*comparison, out); !written) {
    return refuse(written.error());
  }
  fmt::print("{}\nthe report:  {}/report.html\nthe figures: {}/figures\n", formatTable(*comparison), out,
             out);
  for (const ComparedWorld& world : comparison->worlds) {
    fmt::print("every frame: {}/{}/frames.csv\n", out, world.label());
  }
  return reportRecordings(*comparison, arguments.record.file.has_value(), reportContactChecks(*comparison));
}

}  // namespace

Command addCompareCommand(CLI::App& program, std::string commandLine) {
  CLI::App* command = program.add_subcommand(
      "compare", "Run a scene in several worlds and show what differs, in a table and figures");
  auto arguments = std::make_shared<CompareArguments>();
  arguments->commandLine = std::move(commandLine);
  addRunArguments(*command, arguments->run);
  addScriptArgument(*command, arguments->run);
  command
      ->add_option("--worlds", arguments->worlds,
                   "What to compare, the first being what the others are compared to; see `scatter list`")
      ->type_name("NAME,NAME")
      ->delimiter(',')
      ->capture_default_str();
  command
      ->add_option("--repeat", arguments->repeat,
                   "Runs of each world, interleaved; ratios are medians over them")
      ->check(CLI::Range(1, 1000))
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--out", arguments->out, "The folder for data, figures and report [out/SCENE]")
      ->type_name("DIR");
  CLI::Option* resume = command->add_flag(
      "--resume", arguments->resume,
      "Go on with the same comparison that was cut short in that folder: runs that are whole are kept");
  command
      ->add_flag("--anew", arguments->anew,
                 "Give up the runs of a comparison that was cut short in that folder")
      ->excludes(resume);
  command->add_flag("--no-3d", arguments->without3d,
                    "Record nothing for the report: it is smaller, and plays nothing");
  addRecordArguments(*command, arguments->record, /*several=*/true);
  return {command, [arguments] { return compare(*arguments); }};
}

}  // namespace scatter::app
