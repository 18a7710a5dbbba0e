#include <scatter/lab/comparison.h>

#include "lab/comparison_folder.h"
#include "lab/repeats.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <utility>

namespace scatter {

namespace {

Result<CompareOptions> resolve(CompareOptions options) {
  if (options.runs.empty()) {
    return fail("there is no world to compare; name at least one");
  }
  if (options.repeat < 1) {
    return fail("a comparison needs at least one repeat, not " + std::to_string(options.repeat) +
                "; give a larger number");
  }
  std::set<std::string> labels;
  for (RunOptions& run : options.runs) {
    auto resolved = resolveRun(std::move(run));
    if (!resolved) {
      return tl::unexpected(resolved.error());
    }
    run = std::move(*resolved);
    run.out.reset();
    if (!labels.insert(run.label).second) {
      return fail("two worlds are labelled '" + run.label + "'; give each a label of its own");
    }
  }
  return options;
}

std::optional<std::size_t> firstDifference(const std::vector<std::uint64_t>& a,
                                           const std::vector<std::uint64_t>& b) {
  const auto [left, right] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  if (left == a.end() && right == b.end()) {
    return std::nullopt;
  }
  return static_cast<std::size_t>(left - a.begin());
}

Result<void> checkSameHashes(const ComparedWorld& world) {
  const Run& first = world.repeats.front();
  const Run& last = world.repeats.back();
  if (isClockGoverned(first.options.physics)) {
    return {};
  }
  const auto differs = firstDifference(first.table.hashes("state_hash"), last.table.hashes("state_hash"));
  if (!differs) {
    return {};
  }
  return fail("the " + first.options.label + " world of scene '" + first.options.scene +
              "' is not the same run after run: repeat " + std::to_string(world.repeats.size()) +
              " differs from repeat 1 from frame " + std::to_string(*differs + 1) +
              " on, so its times cannot be compared; look for chance or a clock in the scene or the engine");
}

Spread ratio(const ComparedWorld& world, const ComparedWorld& first, TimeStatistics Summary::*channel,
             double TimeStatistics::*figure) {
  return lab::ratioOver(world, first,
                        [channel, figure](const Run& run) { return run.summary.*channel.*figure; });
}

TimeRatios ratios(const ComparedWorld& world, const ComparedWorld& first, TimeStatistics Summary::*channel) {
  return {.peak = ratio(world, first, channel, &TimeStatistics::peak),
          .p99 = ratio(world, first, channel, &TimeStatistics::p99),
          .median = ratio(world, first, channel, &TimeStatistics::median),
          .total = ratio(world, first, channel, &TimeStatistics::total),
          .lastHundred = ratio(world, first, channel, &TimeStatistics::lastHundred)};
}

std::size_t typicalRepeat(const std::vector<Run>& repeats) {
  std::vector<std::size_t> order(repeats.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&repeats](std::size_t a, std::size_t b) {
    return repeats[a].summary.physicsCpuMs.total < repeats[b].summary.physicsCpuMs.total;
  });
  return order[(order.size() - 1) / 2];
}

bool isMeasured(const Channel& channel) {
  return channel.unit == "ms" || channel.name == "cpu_load";
}

FrameTable medianTable(const ComparedWorld& world) {
  FrameTable median = world.run().table;
  for (const FrameColumn& column : world.run().table.columns()) {
    if (!isMeasured(column.channel)) {
      continue;
    }
    std::vector<double> values(median.frames());
    for (std::size_t frame = 0; frame < values.size(); ++frame) {
      std::vector<double> repeats;
      for (const Run& run : world.repeats) {
        repeats.push_back(run.table.values(column.channel.name)[frame]);
      }
      // Interruptions only add: of an even number the lower one is nearer the truth.
      values[frame] = nearestRank(std::move(repeats), 0.5);
    }
    median.setValues(column.channel.name, std::move(values));
  }
  return median;
}

// A B, then B A, and so on.
std::vector<std::size_t> orderOf(int repeat, std::size_t worlds) {
  std::vector<std::size_t> order(worlds);
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (repeat % 2 == 1) {
    std::reverse(order.begin(), order.end());
  }
  return order;
}

// Of a run that was made before, only what lies in its folder is known to be its own.
std::optional<std::filesystem::path> recordingOf(const ComparedWorld& world,
                                                 const std::optional<std::filesystem::path>& inFolder) {
  const Run& first = world.repeats.front();
  if (first.recording) {
    return first.recording->frames > 0 ? std::optional(first.recording->file) : std::nullopt;
  }
  std::error_code ignored;
  return inFolder && std::filesystem::exists(*inFolder, ignored) ? inFolder : std::nullopt;
}

Result<std::optional<lab::ComparisonFolder>> openComparisonFolder(const CompareOptions& options) {
  if (!options.out) {
    return std::nullopt;
  }
  auto folder = lab::ComparisonFolder::open(options);
  if (!folder) {
    return tl::unexpected(folder.error());
  }
  return std::optional(std::move(*folder));
}

using CompareListener = std::function<void(const CompareProgress&)>;

// The runs of a comparison, one after the other.
class ComparisonRunner {
 public:
  ComparisonRunner(Comparison& comparison, std::optional<lab::ComparisonFolder>& folder,
                   const CompareListener& listener)
      : comparison_(comparison), folder_(folder), listener_(listener) {
    report_.runs = comparison.options.repeat * static_cast<int>(comparison.options.runs.size());
  }

  Result<void> runAll() {
    const std::size_t worlds = comparison_.worlds.size();
    for (int repeat = 0; repeat < comparison_.options.repeat; ++repeat) {
      for (const std::size_t world : orderOf(repeat, worlds)) {
        if (auto added = add(world, repeat); !added) {
          return added;
        }
        ++report_.run;
      }
    }
    return {};
  }

 private:
  Result<void> add(std::size_t world, int repeat) {
    auto run = finishedRun(world, repeat);
    if (run && !*run) {
      run = makeRun(world, repeat).map([](Run made) { return std::optional(std::move(made)); });
    }
    if (!run) {
      return tl::unexpected(run.error());
    }
    comparison_.worlds[world].repeats.push_back(std::move(**run));
    return checkSameHashes(comparison_.worlds[world]);
  }

  [[nodiscard]] Result<std::optional<Run>> finishedRun(std::size_t world, int repeat) const {
    return folder_ ? folder_->finishedRun(world, repeat) : std::optional<Run>();
  }

  Result<Run> makeRun(std::size_t world, int repeat) {
    RunOptions options = comparison_.options.runs[world];
    if (folder_) {
      options.out = folder_->runFolder(world, repeat);
    }
    // Repeats are the same run: one of them speaks for all.
    if (repeat > 0) {
      options.record.reset();
    } else if (folder_ && !options.record && comparison_.options.recordRuns) {
      options.record = RecordOptions{.file = folder_->recordingFile(world)};
    }
    report_.label = options.label;
    Result<void> begun;
    auto run = runScene(options, [&](const RunProgress& inside) {
      if (folder_ && begun) {
        begun = folder_->begin(*options.out);
      }
      report_.inside = inside;
      if (listener_) {
        listener_(report_);
      }
    });
    if (!run) {
      return tl::unexpected(Error{.message = run.error().message + keptRuns(), .kind = run.error().kind});
    }
    if (!begun) {
      return tl::unexpected(begun.error());
    }
    if (!run->summary.stopped.empty()) {
      return fail("run " + std::to_string(report_.run + 1) + " of " + std::to_string(report_.runs) + ", " +
                  options.label + " world, is not whole: " + run->summary.stopped + keptRuns());
    }
    if (folder_ && repeat == 0) {
      removeEarlierRecording(world, options);
    }
    return run;
  }

  // What an earlier run has left there must not be taken for this one's.
  void removeEarlierRecording(std::size_t world, const RunOptions& options) const {
    const std::filesystem::path file = folder_->recordingFile(world);
    std::error_code ignored;
    if (!options.record || options.record->file != file) {
      std::filesystem::remove(file, ignored);
    }
  }

  [[nodiscard]] std::string keptRuns() const {
    if (!folder_ || report_.run == 0) {
      return {};
    }
    return "; the runs before it are kept in " + comparison_.options.out->string() + ": go on with --resume";
  }

  Comparison& comparison_;
  std::optional<lab::ComparisonFolder>& folder_;
  const CompareListener& listener_;
  CompareProgress report_;
};

}  // namespace

Result<Comparison> compareWorlds(const CompareOptions& options,
                                 const std::function<void(const CompareProgress&)>& progress) {
  auto resolved = resolve(options);
  if (!resolved) {
    return tl::unexpected(resolved.error());
  }
  auto folder = openComparisonFolder(*resolved);
  if (!folder) {
    return tl::unexpected(folder.error());
  }
  Comparison comparison{.options = std::move(*resolved), .worlds = {}};
  comparison.worlds.resize(comparison.options.runs.size());
  if (auto ran = ComparisonRunner(comparison, *folder, progress).runAll(); !ran) {
    return tl::unexpected(ran.error());
  }
  const ComparedWorld& first = comparison.worlds.front();
  for (std::size_t i = 0; i < comparison.worlds.size(); ++i) {
    ComparedWorld& world = comparison.worlds[i];
    world.recording = recordingOf(
        world, *folder ? std::optional((*folder)->recordingFile(i)) : std::optional<std::filesystem::path>());
    world.typical = typicalRepeat(world.repeats);
    world.median = medianTable(world);
    world.physicsMs = ratios(world, first, &Summary::physicsMs);
    world.physicsCpuMs = ratios(world, first, &Summary::physicsCpuMs);
  }
  return comparison;
}

}  // namespace scatter
