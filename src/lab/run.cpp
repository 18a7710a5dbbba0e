#include <scatter/lab/run.h>

#include <scatter/lab/cpu_time.h>
#include <scatter/lab/frame_csv.h>
#include <scatter/lab/output_folder.h>
#include <scatter/lab/recorder.h>

#include "lab/fidelity_recorder.h"
#include "lab/names.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace scatter {

namespace {

// Components read this many frames back while a run goes on.
constexpr std::size_t kReadBackFrames = 600;

bool isLabel(const std::string& label) {
  constexpr const char* kAllowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_.";
  return !label.empty() && label.front() != '.' && label.find_first_not_of(kAllowed) == std::string::npos;
}

Result<std::unique_ptr<World>> buildWorld(const RunOptions& options, Scene& scene) {
  PhysicsDef definition = options.physics;
  scene.configure(definition);
  auto physics = options.engine(definition);
  if (!physics) {
    return tl::unexpected(physics.error());
  }
  auto world = std::make_unique<World>(std::move(*physics));
  if (auto built = scene.build(*world, {.seed = options.seed.value_or(1)}); !built) {
    return fail("scene '" + options.scene + "': " + built.error().message);
  }
  return world;
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

void takeEvents(const World& world, Run& run) {
  for (const LevelEvent& event : world.physics().levelEvents()) {
    const auto kind = static_cast<std::size_t>(event.kind);
    ++run.summary.levelEvents[kind];
    auto& byPolicy = run.summary.levelEventsByPolicy;
    const auto known = byPolicy.find(event.policy);
    ++(known != byPolicy.end() ? known->second : byPolicy[std::string(event.policy)])[kind];
    if (run.options.keepEvents) {
      run.events.push_back({.frame = world.frame(), .event = event});
    }
  }
}

// What no column holds.
void observe(const World& world, Run& run, std::uint32_t& mostChildPairs) {
  const Physics& physics = world.physics();
  takeEvents(world, run);
  const std::uint32_t childPairs = physics.counters().childPairs;
  if (childPairs > mostChildPairs) {
    mostChildPairs = childPairs;
    run.summary.collisionMemory = physics.collisionMemory();
  }
  if (run.options.physics.collision.verifyEvery > 0) {
    run.summary.contactCheck.follow(world.frame(), physics.contactReport());
  }
}

// One run under way: what every frame touches.
class Runner {
 public:
  Runner(const RunOptions& options, Scene& scene, World& world)
      : options_(options),
        scene_(scene),
        world_(world),
        data_(kReadBackFrames),
        recorder_(world, data_, options.budgetMs) {
    if (options.fidelityEvery > 0) {
      fidelity_.emplace(world, data_, options.fidelityEvery);
    }
  }

  Result<Run> run(const Progress& progress) {
    auto files = openFiles(options_, data_);
    if (!files) {
      return tl::unexpected(files.error());
    }
    Run run{.options = options_, .table = FrameTable(data_.channels()), .summary = {}};
    if (auto recorded = record(run, *files, progress); !recorded) {
      return tl::unexpected(recorded.error());
    }
    describe(run);
    if (options_.inspect) {
      options_.inspect(world_);
    }
    if (auto finished = finish(run, *files); !finished) {
      return tl::unexpected(finished.error());
    }
    if (!run.summary.stopped.empty()) {
      return fail(run.summary.stopped);
    }
    return run;
  }

 private:
  // A state that is no longer finite ends the loop without an error, so that what there is can be kept.
  Result<void> record(Run& run, std::optional<RunFiles>& files, const Progress& progress) {
    const double start = wallSeconds();
    std::uint32_t mostChildPairs = 0;
    for (int frame = 1; frame <= options_.frames && run.summary.stopped.empty(); ++frame) {
      step(run);
      observe(world_, run, mostChildPairs);
      run.table.append(data_);
      if (files) {
        if (auto written = write(*files); !written) {
          return written;
        }
      }
      if (progress) {
        progress({.frame = frame, .frames = options_.frames, .seconds = wallSeconds() - start});
      }
    }
    return {};
  }

  void step(Run& run) {
    scene_.update(world_);
    if (fidelity_) {
      fidelity_->beforeStep();
    }
    const auto stepped = recorder_.step();
    if (!stepped) {
      run.summary.stopped =
          "scene '" + options_.scene + "', " + options_.label + " world, " + stepped.error().message;
    }
    if (fidelity_) {
      // Where a body is no number says nothing about shapes.
      stepped ? fidelity_->afterStep() : fidelity_->skipStep();
    }
  }

  Result<void> write(RunFiles& files) {
    return files.frames.write(data_).and_then(
        [&] { return files.events.write(world_.frame(), world_.physics().levelEvents()); });
  }

  void describe(Run& run) const {
    Summary& summary = run.summary;
    summary.scene = options_.scene;
    summary.label = options_.label;
    summary.engine = world_.physics().engine();
    summary.physics = options_.physics;
    summary.seed = options_.seed.value_or(1);
    summary.budgetMs = options_.budgetMs;
    if (fidelity_) {
      summary.fidelity = fidelity_->statistics();
    }
    summarise(run.table, summary);
  }

  Result<void> finish(const Run& run, std::optional<RunFiles>& files) const {
    if (!files) {
      return {};
    }
    if (auto finished = files->frames.finish(); !finished) {
      return finished;
    }
    if (auto finished = files->events.finish(); !finished) {
      return finished;
    }
    return writeSummary(*options_.out / "summary.json", run.summary);
  }

  const RunOptions& options_;
  Scene& scene_;
  World& world_;
  FrameData data_;
  FrameRecorder recorder_;
  std::optional<lab::FidelityRecorder> fidelity_;
};

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
  const auto scene = resolved->makeScene();
  const auto world = buildWorld(*resolved, *scene);
  if (!world) {
    return tl::unexpected(world.error());
  }
  return Runner(*resolved, *scene, **world).run(progress);
}

}  // namespace scatter
