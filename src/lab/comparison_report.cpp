#include <scatter/io/file.h>
#include <scatter/lab/comparison.h>
#include <scatter/lab/figures.h>
#include <scatter/lab/output_folder.h>
#include <scatter/lab/world_figures.h>

#include "io/atomic_file.h"
#include "lab/comparison_folder.h"
#include "lab/page/page_bundle.h"
#include "lab/report_html.h"
#include "lab/run_files.h"
#include "lab/summary_json.h"

#include <system_error>

namespace scatter {

namespace fs = std::filesystem;

namespace {

lab::Json spreadJson(const Spread& spread) {
  return {{"median", spread.median}, {"min", spread.min}, {"max", spread.max}};
}

lab::Json ratiosJson(const TimeRatios& ratios) {
  return {{"peak", spreadJson(ratios.peak)},
          {"p99", spreadJson(ratios.p99)},
          {"median", spreadJson(ratios.median)},
          {"total", spreadJson(ratios.total)},
          {"last_100_mean", spreadJson(ratios.lastHundred)}};
}

lab::Json worldJson(const ComparedWorld& world) {
  lab::Json repeats = lab::Json::array();
  for (const Run& run : world.repeats) {
    const lab::Json summary = lab::summaryJson(run.summary);
    lab::Json repeat{{"physics_ms", summary["physics_ms"]}, {"physics_cpu_ms", summary["physics_cpu_ms"]}};
    if (summary.contains("fidelity")) {
      repeat["fidelity"] = summary["fidelity"];
    }
    repeats.push_back(std::move(repeat));
  }
  lab::Json summary = lab::summaryJson(world.run().summary);
  for (const char* shared : {"scene", "build", "machine"}) {
    summary.erase(shared);
  }
  return {{"label", world.label()},
          {"written_repeat", world.typical + 1},
          {"written_repeat_is", "the repeat with the median total of physics_cpu_ms"},
          {"governed_by_clock", isClockGoverned(world.run().options.physics)},
          {"ratios_to_first_world",
           {{"physics_ms", ratiosJson(world.physicsMs)}, {"physics_cpu_ms", ratiosJson(world.physicsCpuMs)}}},
          {"summary", std::move(summary)},
          {"repeats", std::move(repeats)}};
}

lab::Json comparisonJson(const Comparison& comparison) {
  const Summary& first = comparison.worlds.front().run().summary;
  lab::Json worlds = lab::Json::array();
  for (const ComparedWorld& world : comparison.worlds) {
    worlds.push_back(worldJson(world));
  }
  return {{"complete", true},
          {"scene", first.scene},
          {"command_line", comparison.options.commandLine},
          {"repeat", comparison.options.repeat},
          {"build", lab::buildJson(first.build)},
          {"machine", lab::machineJson(first.machine)},
          {lab::kComparedKey, lab::comparisonIdentity(comparison.options)},
          {"worlds", std::move(worlds)}};
}

Result<void> writeFiguresAndReport(const Comparison& comparison, const fs::path& folder) {
  const RunOptions& first = comparison.options.runs.front();
  std::vector<FigureWorld> worlds;
  for (const ComparedWorld& world : comparison.worlds) {
    worlds.push_back(lab::figureWorld(world.run().options, world.median));
  }
  const fs::path figureFolder = folder / "figures";
  const auto figures = drawFigures(worlds, {.scene = first.scene,
                                            .budgetMs = first.budgetMs,
                                            .folder = figureFolder,
                                            .repeats = comparison.options.repeat});
  if (!figures) {
    return tl::unexpected(figures.error());
  }
  return writeFile(folder / "report.html", lab::reportHtml(comparison, *figures, lab::pageBundle()));
}

// What was written while it ran is copied, as that has the events; with one repeat it is in its place.
Result<void> placeTypicalRun(const ComparedWorld& world, const fs::path& staged, const fs::path& folder) {
  const Run& run = world.run();
  if (!run.options.out) {
    return lab::writeRunFiles(staged / world.label(), run.table,
                              run.options.keepEvents ? &run.events : nullptr, run.summary);
  }
  if (*run.options.out == folder / world.label()) {
    return {};
  }
  std::error_code error;
  fs::create_directory(staged / world.label(), error);
  for (const char* name : {"frames.csv", "events.csv", "summary.json"}) {
    if (!error) {
      fs::copy_file(*run.options.out / name, staged / world.label() / name, error);
    }
  }
  return error ? cannotWrite(folder / world.label(), error.value()) : Result<void>();
}

}  // namespace

Result<void> writeComparison(const Comparison& comparison, const fs::path& folder) {
  auto staged = StagedFolder::create(folder);
  if (!staged) {
    return tl::unexpected(staged.error());
  }
  for (const ComparedWorld& world : comparison.worlds) {
    if (auto placed = placeTypicalRun(world, staged->path(), folder); !placed) {
      return placed;
    }
  }
  const std::string json =
      comparisonJson(comparison).dump(2, ' ', false, lab::Json::error_handler_t::replace) + '\n';
  if (auto written = writeFile(staged->path() / "comparison.json", json); !written) {
    return written;
  }
  const std::string table = worldFiguresCsv(worldFigures(comparison));
  if (auto written = writeFile(staged->path() / "worlds.csv", table); !written) {
    return written;
  }
  if (auto written = writeFiguresAndReport(comparison, staged->path()); !written) {
    return written;
  }
  return staged->commit();
}

bool hasReportPage() {
  return lab::pageBundle().exists();
}

}  // namespace scatter
