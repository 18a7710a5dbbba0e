#include <scatter/lab/run.h>

#include <scatter/lab/cpu_time.h>
#include <scatter/lab/frame_csv.h>
#include <scatter/lab/output_folder.h>

#include "lab/names.h"
#include "lab/scene_run.h"

#include <system_error>
#include <utility>

namespace scatter {

namespace {

bool isLabel(const std::string& label) {
  constexpr const char* kAllowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_.";
  return !label.empty() && label.front() != '.' && label.find_first_not_of(kAllowed) == std::string::npos;
}

// The files of a run that grow frame by frame.
struct RunFiles {
  FrameCsv frames;
  EventCsv events;
};

Result<std::optional<RunFiles>> openFiles(const RunOptions& options, const FrameData& data) {
  if (!options.out) {
    return std::nullopt;
  }
  if (auto prepared = prepareOutputFolder(*options.out); !prepared) {
    return tl::unexpected(prepared.error());
  }
  std::error_code error;
  std::filesystem::create_directories(*options.out, error);
  auto frames = FrameCsv::create(*options.out / "frames.csv", data);
  if (!frames) {
    return tl::unexpected(frames.error());
  }
  auto events = EventCsv::create(*options.out / "events.csv");
  if (!events) {
    return tl::unexpected(events.error());
  }
  return std::optional(RunFiles{std::move(*frames), std::move(*events)});
}

Result<void> writeFrame(RunFiles& files, const lab::SceneRun& run) {
  const World& world = run.world();
  return files.frames.write(run.data()).and_then([&] {
    return files.events.write(world.frame(), world.physics().levelEvents());
  });
}

// A state that is no longer finite ends the loop without an error, so that what there is can be kept.
Result<void> record(lab::SceneRun& run, std::optional<RunFiles>& files, const Progress& progress) {
  const int frames = run.options().frames;
  const double start = wallSeconds();
  for (int frame = 1; frame <= frames && run.stopped().empty(); ++frame) {
    run.step();
    if (files) {
      if (auto written = writeFrame(*files, run); !written) {
        return written;
      }
    }
    if (progress) {
      progress({.frame = frame, .frames = frames, .seconds = wallSeconds() - start});
    }
  }
  return {};
}

Result<void> finishFiles(RunFiles& files, const Run& run) {
  return files.frames.finish().and_then([&] { return files.events.finish(); }).and_then([&] {
    return writeSummary(*run.options.out / "summary.json", run.summary);
  });
}

}  // namespace

bool isClockGoverned(const PhysicsDef& physics) {
  const SwitchingDef& switching = physics.switching;
  return physics.world == WorldKind::kHybrid && switching.switching == Switching::kPair &&
         switching.budget.milliseconds > 0.0;
}

Result<RunOptions> resolveRun(RunOptions options) {
  if (!options.engine) {
    return fail("no physics engine was given for scene '" + options.scene + "'; name one");
  }
  if (!options.makeScene) {
    const auto info = SceneRegistry::instance().find(options.scene);
    if (!info) {
      return tl::unexpected(info.error());
    }
    options.scene = (*info)->name;
    options.makeScene = (*info)->make;
    options.seed = options.seed.value_or((*info)->seed);
    options.warnings = (*info)->warnings;
    options.frames = options.frames == 0 ? (*info)->frames : options.frames;
    options.summary = options.summary.empty() ? (*info)->summary : options.summary;
  }
  options.seed = options.seed.value_or(1);
  if (options.frames < 1) {
    return fail("a run of scene '" + options.scene + "' needs at least one frame, not " +
                std::to_string(options.frames) + "; give a larger number of frames");
  }
  if (!(options.budgetMs > 0.0)) {
    return fail("the budget of scene '" + options.scene + "' must be more than 0 ms; give a larger one");
  }
  if (options.fidelityEvery < 0) {
    return fail("fidelity of scene '" + options.scene + "' cannot be measured every " +
                std::to_string(options.fidelityEvery) + " frames; give a number from 0");
  }
  if (options.label.empty()) {
    options.label = lab::nameOf(options.physics.world);
  }
  if (!isLabel(options.label)) {
    return fail("the world's label '" + options.label +
                "' cannot name a folder; use letters, digits, '-', '_' and '.'");
  }
  return options;
}

Result<Run> runScene(const RunOptions& options, const Progress& progress) {
  const auto resolved = resolveRun(options);
  if (!resolved) {
    return tl::unexpected(resolved.error());
  }
  auto run = lab::SceneRun::create(*resolved);
  if (!run) {
    return tl::unexpected(run.error());
  }
  auto files = openFiles(*resolved, (*run)->data());
  if (!files) {
    return tl::unexpected(files.error());
  }
  if (auto recorded = record(**run, *files, progress); !recorded) {
    return tl::unexpected(recorded.error());
  }
  Run done = (*run)->takeRun();
  if (resolved->inspect) {
    resolved->inspect((*run)->world());
  }
  if (*files) {
    if (auto finished = finishFiles(**files, done); !finished) {
      return tl::unexpected(finished.error());
    }
  }
  if (!done.summary.stopped.empty()) {
    return fail(done.summary.stopped);
  }
  return done;
}

}  // namespace scatter
