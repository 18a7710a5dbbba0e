#include <scatter/lab/experiment.h>

#include <scatter/io/file.h>
#include <scatter/lab/output_folder.h>

#include "lab/frame_sampler.h"
#include "lab/names.h"
#include "lab/run_files.h"
#include "lab/run_recorder.h"
#include "lab/scene_run.h"
#include "lab/scripted_hands.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace scatter {

namespace {

Result<RunOptions> resolveExperiment(RunOptions options) {
  options.frames = std::max(options.frames, options.makeScene ? 1 : 0);
  options.out.reset();
  options.inspect = nullptr;
  options.keepEvents = true;
  return resolveRun(std::move(options));
}

Result<void> writeFigures(const std::filesystem::path& folder, const RunOptions& options,
                          const FrameTable& table) {
  std::error_code error;
  std::filesystem::create_directory(folder, error);
  if (error) {
    return fail("cannot make folder " + folder.string() + ": " + error.message() +
                "; choose another output folder");
  }
  const auto figures = drawFigures({lab::figureWorld(options, table)},
                                   {.scene = options.scene, .budgetMs = options.budgetMs, .folder = folder});
  return figures ? Result<void>() : tl::unexpected(figures.error());
}

}  // namespace

Result<std::unique_ptr<Experiment>> Experiment::create(const ExperimentDef& def) {
  const auto options = resolveExperiment(def.run);
  if (!options) {
    return tl::unexpected(options.error());
  }
  auto run = lab::SceneRun::create(*options);
  if (!run) {
    return tl::unexpected(run.error());
  }
  ExperimentDef resolved = def;
  resolved.run = *options;
  return std::unique_ptr<Experiment>(new Experiment(std::move(resolved), std::move(*run)));
}

Experiment::Experiment(ExperimentDef def, std::unique_ptr<lab::SceneRun> run)
    : def_(std::move(def)), history_(def_.history) {
  adopt(std::move(run), def_.run.hands);
}

Experiment::~Experiment() = default;

void Experiment::adopt(std::unique_ptr<lab::SceneRun> run, HandScript script) {
  hands_.reset();
  run_ = std::move(run);
  hands_ = std::make_unique<lab::ScriptedHands>(*run_, def_.hands, std::move(script));
  switches_ = {};
  // What fails is that a file is not whole, whose frames are there all the same.
  [[maybe_unused]] const auto ended = history_.stopRecording("its scene was started again");
  history_.clear();
  keepHistory();
}

Result<void> Experiment::restart(HandScript script) {
  return restart(def_.run.physics, std::move(script));
}

Result<void> Experiment::restart(const PhysicsDef& physics, HandScript script) {
  RunOptions options = def_.run;
  if (options.label == lab::nameOf(options.physics.world)) {
    options.label = lab::nameOf(physics.world);
  }
  options.physics = physics;
  return begin(std::move(options), std::move(script));
}

Result<void> Experiment::open(const std::string& scene) {
  RunOptions options = def_.run;
  options.scene = scene;
  options.makeScene = {};
  options.summary.clear();
  options.hands = {};
  options.frames = 0;
  options.seed.reset();
  const auto resolved = resolveExperiment(std::move(options));
  return resolved ? begin(*resolved, {}) : tl::unexpected(resolved.error());
}

Result<void> Experiment::begin(RunOptions options, HandScript script) {
  auto run = lab::SceneRun::create(options);
  if (!run) {
    return tl::unexpected(run.error());
  }
  def_.run = std::move(options);
  adopt(std::move(*run), std::move(script));
  ++restarts_;
  return {};
}

Result<void> Experiment::step() {
  if (!stopped().empty()) {
    return fail(stopped());
  }
  hands_->step();
  const StepCounters& counters = world().physics().counters();
  switches_.coarser += counters.switchesCoarser;
  switches_.finer += counters.switchesFiner;
  keepHistory();
  return stopped().empty() ? Result<void>() : fail(stopped());
}

void Experiment::keepHistory() {
  pairs_.clear();
  if (history_.def().pairLevels) {
    world().physics().diagnostics().observe({.bodies = false, .pairs = true, .contacts = false},
                                            observation_);
    lab::addPairLevels(observation_, pairs_);
  }
  history_.record(world(), pairs_, &run_->data());
}

Result<void> Experiment::startRecording(const std::filesystem::path& file) {
  return history_.startRecording(file, lab::recordingInfo(*run_, /*contacts=*/false));
}

bool Experiment::setBudget(const BudgetDef& budget) {
  if (!world().physics().switching().setBudget(budget)) {
    return false;
  }
  def_.run.physics.switching.budget = budget;
  run_->setPhysics(def_.run.physics);
  return true;
}

Result<void> Experiment::setPolicies(Policy policy, const std::vector<std::string>& policies) {
  auto changed = world().physics().switching().setPolicies(policy, policies);
  if (changed) {
    def_.run.physics.switching.policy = policy;
    def_.run.physics.switching.policies = policies;
    run_->setPhysics(def_.run.physics);
  }
  return changed;
}

Result<void> Experiment::setSwitching(Switching switching) {
  auto changed = world().physics().switching().setSwitching(switching);
  if (changed) {
    def_.run.physics.switching.switching = switching;
    run_->setPhysics(def_.run.physics);
  }
  return changed;
}

const std::string& Experiment::stopped() const {
  return run_->stopped();
}

Hands& Experiment::hands() {
  return hands_->hands();
}

const Hands& Experiment::hands() const {
  return hands_->hands();
}

const std::string& Experiment::scriptError() const {
  return hands_->error();
}

World& Experiment::world() {
  return run_->world();
}

const World& Experiment::world() const {
  return run_->world();
}

const RunOptions& Experiment::options() const {
  return def_.run;
}

const FrameData& Experiment::data() const {
  return run_->data();
}

const FrameTable& Experiment::table() const {
  return run_->table();
}

const std::vector<FrameEvent>& Experiment::events() const {
  return run_->events();
}

const LevelEventCounts& Experiment::levelEvents() const {
  return run_->levelEvents();
}

Summary Experiment::summary() const {
  return run_->summary();
}

Result<void> Experiment::write(const std::filesystem::path& folder, bool figures) const {
  if (table().frames() == 0) {
    return fail("scene '" + options().scene + "' has no frame yet; step it before its run is written");
  }
  auto staged = StagedFolder::create(folder);
  if (!staged) {
    return tl::unexpected(staged.error());
  }
  if (auto written = lab::writeRunFiles(staged->path(), table(), &events(), summary()); !written) {
    return written;
  }
  if (!hands().script().empty()) {
    if (auto written = writeFile(staged->path() / "hands.txt", hands().script().text()); !written) {
      return written;
    }
  }
  if (figures) {
    if (auto drawn = writeFigures(staged->path() / "figures", options(), table()); !drawn) {
      return drawn;
    }
  }
  return staged->commit();
}

}  // namespace scatter
