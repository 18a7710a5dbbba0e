#include "run_arguments.h"

#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "number_checks.h"

namespace scatter::app {

namespace {

template <class Choice>
std::string namesOf(const std::vector<Choice>& choices) {
  std::string names;
  for (const Choice& choice : choices) {
    names += (names.empty() ? "" : ", ") + choice.name;
  }
  return names;
}

void addSwitchingArguments(CLI::App& command, RunArguments& arguments) {
  const SwitchingDef defaults;
  command.add_option("--switching", arguments.switching, "What has a level: " + namesOf(switchingChoices()))
      ->type_name("NAME")
      ->capture_default_str();
  command
      .add_option("--policy", arguments.policy,
                  fmt::format("What asks for levels in a hybrid world: {} [{}]", namesOf(policyChoices()),
                              policyChoices().front().name))
      ->type_name("NAME");
  command
      .add_option("--proximity-steps", arguments.proximitySteps,
                  fmt::format("Requests come this many steps before level-1 boxes can touch [{:g}]",
                              defaults.proximitySteps))
      ->check(numberAbove(1.0))
      ->type_name("STEPS");
  command
      .add_option(
          "--retry-interval", arguments.retryInterval,
          fmt::format("Steps between tries of a switch that was not safe [{}]", defaults.retryInterval))
      ->check(wholeNumber<int>(1))
      ->type_name("STEPS");
  command
      .add_option("--load-fine-pairs", arguments.loadFinePairs,
                  fmt::format("Nothing is switched while fewer narrowphase pairs are at work; 0: never [{}]",
                              defaults.loadFinePairs))
      ->check(wholeNumber<std::uint32_t>(0))
      ->type_name("PAIRS");
  command.add_flag("--unsafe-switching", arguments.unsafeSwitching,
                   "Switch without the safety conditions, to see what they prevent");
}

void addCollisionArguments(CLI::App& command, RunArguments& arguments) {
  command
      .add_option("--collision", arguments.collision,
                  fmt::format("How hybrid bodies meet in a hybrid world: {} [{}]",
                              namesOf(collisionChoices()), collisionChoices().front().name))
      ->type_name("NAME");
  command
      .add_option("--verify-contacts", arguments.verifyEvery,
                  "Compare the contacts of hybrid bodies with brute force every N frames; slow, and part of "
                  "those frames' times; status 1 if any is missed")
      ->check(wholeNumber<int>(1))
      ->type_name("N");
}

// Arguments that were given although only a hybrid world has a use for them.
std::string hybridArgumentOf(const RunArguments& arguments) {
  if (arguments.policy) {
    return "--policy";
  }
  if (arguments.collision) {
    return "--collision";
  }
  if (arguments.verifyEvery) {
    return "--verify-contacts";
  }
  if (arguments.proximitySteps) {
    return "--proximity-steps";
  }
  if (arguments.retryInterval) {
    return "--retry-interval";
  }
  if (arguments.loadFinePairs) {
    return "--load-fine-pairs";
  }
  return arguments.unsafeSwitching ? "--unsafe-switching" : "";
}

Result<void> checkMeaning(const RunArguments& arguments, const std::vector<WorldChoice>& worlds) {
  const std::string given = hybridArgumentOf(arguments);
  const auto isHybrid = [](const WorldChoice& world) { return world.kind == WorldKind::kHybrid; };
  if (!given.empty() && std::none_of(worlds.begin(), worlds.end(), isHybrid)) {
    return fail(given + " has no meaning in a standard world; leave it out or use the hybrid world");
  }
  const auto takesPolicy = [&](const WorldChoice& world) { return isHybrid(world) && !world.policy; };
  if (arguments.policy && std::none_of(worlds.begin(), worlds.end(), takesPolicy)) {
    return fail("the world " + worlds.back().name +
                " has its own policy; leave --policy out or use the hybrid world");
  }
  const auto takesCollision = [&](const WorldChoice& world) { return isHybrid(world) && !world.narrowphase; };
  if (arguments.collision && std::none_of(worlds.begin(), worlds.end(), takesCollision)) {
    return fail("the world " + worlds.back().name +
                " has its own collision; leave --collision out or use the hybrid world");
  }
  return {};
}

Result<SwitchingDef> makeSwitching(const RunArguments& arguments, const WorldChoice& world) {
  SwitchingDef switching;
  if (const auto mode = choose(switchingChoices(), "switching mode", arguments.switching); !mode) {
    return tl::unexpected(mode.error());
  }
  if (arguments.policy) {
    const auto policy = choose(policyChoices(), "policy", *arguments.policy);
    if (!policy) {
      return tl::unexpected(policy.error());
    }
    switching.policy = policy->policy;
  }
  switching.policy = world.policy.value_or(switching.policy);
  switching.proximitySteps = arguments.proximitySteps.value_or(switching.proximitySteps);
  switching.retryInterval = arguments.retryInterval.value_or(switching.retryInterval);
  switching.loadFinePairs = arguments.loadFinePairs.value_or(switching.loadFinePairs);
  switching.safetyConditions = !arguments.unsafeSwitching;
  return switching;
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
  collision.verifyEvery = arguments.verifyEvery.value_or(0);
  return collision;
}

Result<RunOptions> makeRun(const RunArguments& arguments, const EngineChoice& engine,
                           const WorldChoice& world) {
  const auto switching = makeSwitching(arguments, world);
  if (!switching) {
    return tl::unexpected(switching.error());
  }
  const auto collision = makeCollision(arguments, world);
  if (!collision) {
    return tl::unexpected(collision.error());
  }
  RunOptions options;
  options.scene = arguments.scene;
  options.engine = engine.make;
  options.physics.world = world.kind;
  options.physics.profiling = !arguments.noProfiling;
  if (world.kind == WorldKind::kHybrid) {
    options.physics.switching = *switching;
    options.physics.collision = *collision;
  }
  options.frames = arguments.frames.value_or(0);
  options.seed = arguments.seed;
  options.budgetMs = arguments.budgetMs;
  options.label = world.name;
  return resolveRun(std::move(options));
}

}  // namespace

void addRunArguments(CLI::App& command, RunArguments& arguments) {
  command.add_option("SCENE", arguments.scene, "The scene's name, as `scatter list` shows it")->required();
  command.add_option("--engine", arguments.engine, "The physics engine: " + namesOf(engineChoices()))
      ->type_name("NAME")
      ->capture_default_str();
  addSwitchingArguments(command, arguments);
  addCollisionArguments(command, arguments);
  command.add_option("--frames", arguments.frames, "Steps of 1/60 s [as many as the scene's story takes]")
      ->check(wholeNumber<int>(1))
      ->type_name("N");
  command.add_option("--seed", arguments.seed, "Of the scene's random numbers; the same seed, the same run")
      ->check(wholeNumber<std::uint64_t>(0))
      ->type_name("N")
      ->capture_default_str();
  command
      .add_option("--budget-ms", arguments.budgetMs,
                  "Milliseconds that a frame's physics should fit into; frames beyond are counted")
      ->check(numberAbove(0.0))
      ->type_name("MS")
      ->capture_default_str();
  command.add_flag("--no-profiling", arguments.noProfiling, "Do not time the stages of a step");
  command.add_flag("--quiet", arguments.quiet, "No progress on standard error");
}

Result<std::vector<RunOptions>> makeRuns(const RunArguments& arguments,
                                         const std::vector<std::string>& worlds) {
  const auto engine = choose(engineChoices(), "engine", arguments.engine);
  if (!engine) {
    return tl::unexpected(engine.error());
  }
  std::vector<WorldChoice> choices;
  std::vector<RunOptions> runs;
  for (const std::string& name : worlds) {
    const auto world = choose(worldChoices(), "world", name);
    if (!world) {
      return tl::unexpected(world.error());
    }
    auto run = makeRun(arguments, *engine, *world);
    if (!run) {
      return tl::unexpected(run.error());
    }
    choices.push_back(*world);
    runs.push_back(std::move(*run));
  }
  if (auto meaningful = checkMeaning(arguments, choices); !meaningful) {
    return tl::unexpected(meaningful.error());
  }
  return runs;
}

}  // namespace scatter::app
