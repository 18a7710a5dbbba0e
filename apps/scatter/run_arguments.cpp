#include "run_arguments.h"

#include <scatter/io/file.h>
#include <scatter/lab/hand_script.h>
#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <utility>

#include "messages.h"
#include "number_checks.h"

namespace scatter::app {

namespace {

/// Half of the distance at which the engine drops contacts, millimetres.
constexpr double kMostRecycling = 10.0;

void addCollisionArguments(CLI::App& command, RunArguments& arguments) {
  command
      .add_option("--collision", arguments.collision,
                  fmt::format("How hybrid bodies meet in a hybrid world: {} [{}]",
                              namesOf(collisionChoices()), collisionChoices().front().name))
      ->type_name("NAME");
  command
      .add_option(
          "--recycle", arguments.recycling,
          "Contacts of hybrid bodies move along with them until they have slid MM millimetres, and are "
          "found anew only then; 0: they are found anew in every step [0]")
      ->check(CLI::Range(0.0, kMostRecycling))
      ->type_name("MM");
  command
      .add_option("--solver", arguments.solver,
                  fmt::format("Who solves contacts, in any world that does not bring its own: {} [{}]",
                              namesOf(solverChoices()), solverChoices().front().name))
      ->type_name("NAME");
  command
      .add_option("--reduce", arguments.contactsPerDirection,
                  "Show the solver no more than N contacts of each direction of two bodies that have many "
                  "[8 if N is left out]; 0: all of them [0]")
      ->expected(0, 1)
      ->default_str(std::to_string(kUsualContactsPerDirection))
      ->check(wholeNumber<int>(0))
      ->type_name("[N]");
  command
      .add_option("--verify-contacts", arguments.verifyEvery,
                  "Compare the contacts of hybrid bodies with the engine's every N frames; slow, and part of "
                  "those frames' times; status 1 if any is missed")
      ->check(wholeNumber<int>(1))
      ->type_name("N");
}

// Arguments that were given although only a hybrid world has a use for them.
std::string hybridArgumentOf(const RunArguments& arguments) {
  const SwitchingArguments& switching = arguments.switching;
  const std::pair<const char*, bool> given[] = {
      {"--switching", switching.switching.has_value()},
      {"--policy", !switching.policies.empty()},
      {"--budget-units", switching.budgetUnits.has_value()},
      {"--replay", switching.replay.has_value()},
      {"--credit-level", switching.creditLevel.has_value()},
      {"--no-credit", switching.noCredit},
      {"--collision", arguments.collision.has_value()},
      {"--recycle", arguments.recycling.has_value()},
      {"--threads", arguments.threads.has_value()},
      {"--verify-contacts", arguments.verifyEvery.has_value()},
      {"--proximity-steps", switching.proximitySteps.has_value()},
      {"--retry-interval", switching.retryInterval.has_value()},
      {"--quiet-steps", switching.quietSteps.has_value()},
      {"--load-fine-pairs", switching.loadFinePairs.has_value()},
      {"--unsafe-switching", switching.unsafeSwitching},
  };
  for (const auto& [argument, isGiven] : given) {
    if (isGiven) {
      return argument;
    }
  }
  return {};
}

Result<void> checkMeaning(const RunArguments& arguments, const std::vector<WorldSpec>& worlds) {
  const std::string given = hybridArgumentOf(arguments);
  const auto isHybrid = [](const WorldSpec& spec) { return spec.world.kind == WorldKind::kHybrid; };
  if (!given.empty() && std::none_of(worlds.begin(), worlds.end(), isHybrid)) {
    return fail(given + " has no meaning in a standard world; leave it out or use the hybrid world");
  }
  const auto takesPolicy = [&](const WorldSpec& spec) { return isHybrid(spec) && !spec.world.policy; };
  if (!arguments.switching.policies.empty() && std::none_of(worlds.begin(), worlds.end(), takesPolicy)) {
    return fail("the world " + worlds.back().world.name +
                " has its own policy; leave --policy out or use the hybrid world");
  }
  const auto takesSolver = [](const WorldSpec& spec) { return !spec.world.solver; };
  if (arguments.solver && std::none_of(worlds.begin(), worlds.end(), takesSolver)) {
    return fail("the world " + worlds.back().world.name +
                " has its own solver; leave --solver out or use another world");
  }
  const auto takesCollision = [&](const WorldSpec& spec) {
    return isHybrid(spec) && !spec.world.narrowphase;
  };
  if (arguments.collision && std::none_of(worlds.begin(), worlds.end(), takesCollision)) {
    return fail("the world " + worlds.back().world.name +
                " has its own collision; leave --collision out or use the hybrid world");
  }
  return {};
}

Result<CollisionDef> makeCollision(const RunArguments& arguments, const WorldChoice& world) {
  CollisionDef collision;
  if (arguments.collision) {
    const auto choice = choose(collisionChoices(), "collision", *arguments.collision);
    if (!choice) {
      return tl::unexpected(choice.error());
    }
    collision.narrowphase = choice->narrowphase;
  }
  collision.narrowphase = world.narrowphase.value_or(collision.narrowphase);
  collision.pairAlgorithm.recycling = arguments.recycling ? *arguments.recycling / 1000.0F : world.recycling;
  collision.verifyEvery = arguments.verifyEvery.value_or(0);
  return collision;
}

Result<ContactSolver> chooseSolver(const RunArguments& arguments, const WorldChoice& world) {
  ContactSolver solver = solverChoices().front().solver;
  if (arguments.solver) {
    const auto choice = choose(solverChoices(), "solver", *arguments.solver);
    if (!choice) return tl::unexpected(choice.error());
    solver = choice->solver;
  }
  return world.solver.value_or(solver);
}

Result<RunOptions> makeRun(const RunArguments& arguments, const EngineChoice& engine,
                           const SwitchingChoices& switching, const WorldSpec& spec) {
  const auto collision = makeCollision(arguments, spec.world);
  if (!collision) {
    return tl::unexpected(collision.error());
  }
  const auto solver = chooseSolver(arguments, spec.world);
  if (!solver) {
    return tl::unexpected(solver.error());
  }
  RunOptions options;
  options.scene = arguments.scene;
  options.physics.solver = *solver;
  options.physics.contactsPerDirection =
      arguments.contactsPerDirection.value_or(spec.world.contactsPerDirection);
  options.engine = engine.make;
  options.physics.world = spec.world.kind;
  options.physics.profiling = !arguments.noProfiling;
  options.physics.threads = spec.threads.value_or(arguments.threads.value_or(1));
  if (spec.world.kind == WorldKind::kHybrid) {
    options.physics.switching = makeSwitching(arguments.switching, switching, spec, collision->narrowphase);
    options.physics.collision = *collision;
  }
  options.frames = arguments.frames.value_or(0);
  options.seed = arguments.seed;
  options.fidelityEvery = arguments.fidelityEvery.value_or(0);
  options.budgetMs = arguments.switching.budgetMs.value_or(options.budgetMs);
  if (spec.budget && spec.budget->milliseconds > 0.0) {
    options.budgetMs = spec.budget->milliseconds;
  }
  options.label = spec.label;
  return resolveRun(std::move(options));
}

Result<HandScript> readScript(const std::optional<std::string>& file) {
  if (!file) {
    return HandScript();
  }
  const auto text = readFile(*file);
  return text ? HandScript::parse(*text, *file) : tl::unexpected(text.error());
}

}  // namespace

void addFidelityArgument(CLI::App& command, std::optional<int>& every) {
  command
      .add_option(
          "--fidelity", every,
          "Measure every N frames how true contacts are to the finest shapes, outside of what is timed "
          "[10 if N is left out]")
      ->expected(0, 1)
      ->default_str(std::to_string(kFidelityEvery))
      ->check(wholeNumber<int>(1))
      ->type_name("[N]");
}

void addRunArguments(CLI::App& command, RunArguments& arguments) {
  command
      .add_option("SCENE", arguments.scene,
                  "The scene's name, as `scatter list` shows it, or a file: .toml, .dae, .gltf, .glb")
      ->required();
  command.add_option("--engine", arguments.engine, "The physics engine: " + namesOf(engineChoices()))
      ->type_name("NAME")
      ->capture_default_str();
  addSwitchingArguments(command, arguments.switching);
  addCollisionArguments(command, arguments);
  command.add_option("--frames", arguments.frames, "Steps of 1/60 s [as many as the scene's story takes]")
      ->check(wholeNumber<int>(1))
      ->type_name("N");
  command
      .add_option("--seed", arguments.seed,
                  "Of the scene's random numbers; the same seed, the same run [the scene's own, or 1]")
      ->check(wholeNumber<std::uint64_t>(0))
      ->type_name("N");
  addFidelityArgument(command, arguments.fidelityEvery);
  command
      .add_option(
          "--threads", arguments.threads,
          "Threads that a hybrid world works on, for the same results; processor times are of the main "
          "thread alone [1]")
      ->check(CLI::Range(1, kMostThreads))
      ->type_name("N");
  command.add_flag("--no-profiling", arguments.noProfiling, "Do not time the stages of a step");
  command.add_flag("--quiet", arguments.quiet, "No progress on standard error");
}

void addScriptArgument(CLI::App& command, RunArguments& arguments) {
  command
      .add_option(
          "--script", arguments.script,
          "Do by hand what FILE says, in every world, such as the hands.txt of a run in a window; see "
          "docs/window.md")
      ->type_name("FILE");
}

Result<std::vector<RunOptions>> makeRuns(const RunArguments& arguments,
                                         const std::vector<std::string>& worlds) {
  const auto engine = choose(engineChoices(), "engine", arguments.engine);
  if (!engine) {
    return tl::unexpected(engine.error());
  }
  const auto script = readScript(arguments.script);
  if (!script) {
    return tl::unexpected(script.error());
  }
  const auto switching = chooseSwitching(arguments.switching);
  std::vector<WorldSpec> specs;
  std::vector<RunOptions> runs;
  std::vector<PhysicsDef> physics;
  for (const std::string& name : worlds) {
    auto spec = parseWorld(name);
    if (!spec) {
      return tl::unexpected(spec.error());
    }
    if (!switching) {
      return tl::unexpected(switching.error());
    }
    auto run = makeRun(arguments, *engine, *switching, *spec);
    if (!run) {
      return tl::unexpected(run.error());
    }
    run->hands = *script;
    specs.push_back(std::move(*spec));
    physics.push_back(run->physics);
    runs.push_back(std::move(*run));
  }
  if (auto meaningful = checkMeaning(arguments, specs); !meaningful) {
    return tl::unexpected(meaningful.error());
  }
  if (auto meaningful = checkSwitching(arguments.switching, *switching, specs, physics); !meaningful) {
    return tl::unexpected(meaningful.error());
  }
  for (const std::string& warning : runs.front().warnings) {
    printNote("warning: " + warning);
  }
  return runs;
}

}  // namespace scatter::app
