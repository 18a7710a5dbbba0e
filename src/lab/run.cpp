#include <scatter/lab/run.h>

#include <scatter/lab/cpu_time.h>

#include "lab/names.h"
#include "lab/run_folder.h"
#include "lab/run_recorder.h"
#include "lab/scene_run.h"
#include "lab/scripted_hands.h"

#include <utility>

namespace scatter {

namespace {

bool isLabel(const std::string& label) {
  constexpr const char* kAllowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_.";
  return !label.empty() && label.front() != '.' && label.find_first_not_of(kAllowed) == std::string::npos;
}

Result<std::optional<lab::RunFolder>> openFolder(const RunOptions& options, const FrameData& data) {
  if (!options.out) {
    return std::nullopt;
  }
  auto folder = lab::RunFolder::open(*options.out, data);
  if (!folder) {
    return tl::unexpected(folder.error());
  }
  return std::optional(std::move(*folder));
}

Result<std::unique_ptr<lab::RunRecorder>> openRecorder(const RunOptions& options, const lab::SceneRun& run) {
  if (!options.record) {
    return nullptr;
  }
  return lab::RunRecorder::create(*options.record, run);
}

std::string afterFrame(int frame, int frames) {
  return "after frame " + std::to_string(frame) + " of " + std::to_string(frames);
}

// What there is can be kept whether or not this fails.
Result<void> record(lab::SceneRun& run, std::optional<lab::RunFolder>& folder, lab::RunRecorder* recorder,
                    const Progress& progress) {
  const RunOptions& options = run.options();
  const double start = wallSeconds();
  lab::ScriptedHands hands(run, {}, options.hands);
  for (int frame = 1; frame <= options.frames; ++frame) {
    hands.step();
    if (recorder != nullptr) {
      recorder->add(run);
    }
    if (folder) {
      if (auto written = folder->addFrame(run); !written) {
        run.stop("its files could not be written " + afterFrame(frame - 1, options.frames) + ": " +
                 written.error().message);
        return written;
      }
    }
    if (progress) {
      progress({.frame = frame, .frames = options.frames, .seconds = wallSeconds() - start});
    }
    if (run.stopped().empty() && !hands.error().empty()) {
      run.stop("what hands were to do cannot be done, " + hands.error());
    }
    if (!run.stopped().empty()) {
      return fail(run.stopped());
    }
    if (frame < options.frames && options.stop && options.stop()) {
      run.stop("it was interrupted " + afterFrame(frame, options.frames));
      break;
    }
  }
  return {};
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
  if (options.memoryEvery < 0) {
    return fail("memory of scene '" + options.scene + "' cannot be counted every " +
                std::to_string(options.memoryEvery) + " frames; give a number from 0");
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
  auto folder = openFolder(*resolved, (*run)->data());
  if (!folder) {
    return tl::unexpected(folder.error());
  }
  auto recorder = openRecorder(*resolved, **run);
  if (!recorder) {
    return tl::unexpected(recorder.error());
  }
  const auto recorded = record(**run, *folder, recorder->get(), progress);
  Run done = (*run)->takeRun();
  if (*recorder) {
    (*recorder)->finish(done.summary.stopped);
    done.recording = (*recorder)->cost();
  }
  if (resolved->inspect) {
    resolved->inspect((*run)->world());
  }
  if (*folder) {
    const auto finished = (*folder)->finish(done.summary);
    if (recorded && !finished) {
      return tl::unexpected(finished.error());
    }
  }
  if (!recorded) {
    return tl::unexpected(recorded.error());
  }
  return done;
}

}  // namespace scatter
