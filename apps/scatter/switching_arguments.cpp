#include "switching_arguments.h"

#include <scatter/lab/frame_csv.h>
#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <utility>

#include "lod/make_policy.h"
#include "number_checks.h"

namespace scatter::app {

namespace {

void addBudgetArguments(CLI::App& command, SwitchingArguments& arguments) {
  command
      .add_option("--budget-ms", arguments.budgetMs,
                  "Milliseconds that a frame's physics should fit into: frames beyond are counted, and if "
                  "given, pair switching takes detail away to keep it [16.67, counted only]")
      ->check(numberAbove(0.0))
      ->type_name("MS");
  command
      .add_option("--budget-units", arguments.budgetUnits,
                  "Units of predicted work that a step may cost, with pair switching: the same run after run")
      ->check(numberAbove(0.0))
      ->type_name("UNITS");
  command
      .add_option("--replay", arguments.replay,
                  "Repeat the budgets of an earlier run, from its frames.csv, with pair switching")
      ->type_name("FRAMES_CSV");
}

void addCreditArguments(CLI::App& command, SwitchingArguments& arguments) {
  const SwitchingDef defaults;
  command
      .add_option("--credit-level", arguments.creditLevel,
                  fmt::format("The coarsest level that a pair in contact takes, with pair switching [{}]",
                              defaults.creditLevel))
      ->check(wholeNumber<int>(1))
      ->type_name("LEVEL");
  command.add_flag("--no-credit", arguments.noCredit,
                   "A pair in contact goes coarser only when it is apart, with pair switching");
}

void addBodyArguments(CLI::App& command, SwitchingArguments& arguments) {
  const SwitchingDef defaults;
  command
      .add_option("--proximity-steps", arguments.proximitySteps,
                  fmt::format("Requests come this many steps before level-1 boxes can touch, with body "
                              "switching; 0: once they overlap [{:g}]",
                              defaults.proximitySteps))
      ->check(numberFrom(0.0))
      ->type_name("STEPS");
  command
      .add_option("--quiet-steps", arguments.quietSteps,
                  fmt::format("Steps without a neighbour before a body asks for its finest level, with body "
                              "switching [{}]",
                              defaults.quietSteps))
      ->check(wholeNumber<int>(1))
      ->type_name("STEPS");
  command
      .add_option("--load-fine-pairs", arguments.loadFinePairs,
                  fmt::format("Nothing is switched while fewer narrowphase pairs are at work, with body "
                              "switching; 0: never [{}]",
                              defaults.loadFinePairs))
      ->check(wholeNumber<std::uint32_t>(0))
      ->type_name("PAIRS");
}

// "speed:from=5" and "to=20" are one policy.
std::vector<std::string> joinParameters(const std::vector<std::string>& pieces) {
  std::vector<std::string> specs;
  for (const std::string& piece : pieces) {
    const bool isParameter = piece.find('=') < piece.find(':');
    if (isParameter && !specs.empty()) {
      specs.back() += ',' + piece;
    } else {
      specs.push_back(piece);
    }
  }
  return specs;
}

Result<void> choosePolicies(const std::vector<std::string>& pieces, SwitchingChoices& choices) {
  for (const std::string& spec : joinParameters(pieces)) {
    const auto simple = std::find_if(policyChoices().begin(), policyChoices().end(),
                                     [&spec](const PolicyChoice& choice) { return choice.name == spec; });
    if (simple == policyChoices().end()) {
      if (const auto made = lod::makePolicy(spec); !made) {
        return fail("--policy: " + made.error().message);
      }
      choices.policies.push_back(spec);
    } else if (choices.policy) {
      return fail("--policy takes one of " + namesOf(policyChoices()) + "; leave out " + spec);
    } else {
      choices.policy = simple->policy;
    }
  }
  return {};
}

Result<std::vector<double>> unitsIn(const FrameFile& frames, const std::string& file,
                                    const std::string& column) {
  auto units = frames.column(column);
  if (!units) {
    return fail("--replay: " + units.error().message);
  }
  if (std::any_of(units->begin(), units->end(), [](double value) { return value < 0.0; })) {
    return fail("--replay: " + file + " has a " + column + " below 0; give the frames.csv of a run");
  }
  return units;
}

// What the clock had left of a budget is not in files that somebody else has made.
Result<BudgetDef> readRecording(const std::string& file) {
  const auto frames = FrameFile::read(file);
  if (!frames) {
    return fail("--replay: " + frames.error().message);
  }
  BudgetDef budget;
  const auto units = unitsIn(*frames, file, "budget_units");
  if (!units) {
    return tl::unexpected(units.error());
  }
  if (std::ranges::all_of(*units, [](double value) { return value == 0.0; })) {
    return fail("--replay: the run in " + file +
                " had no budget, so there is nothing to replay; record one with --budget-ms");
  }
  for (const double given : *units) {
    budget.recorded.push_back({.given = given});
  }
  for (const auto& [column, left] : {std::pair{"revised_units", &BudgetUnits::revised},
                                     std::pair{"settled_units", &BudgetUnits::settled}}) {
    if (!frames->has(column)) {
      continue;
    }
    const auto read = unitsIn(*frames, file, column);
    if (!read) {
      return tl::unexpected(read.error());
    }
    for (std::size_t i = 0; i < read->size(); ++i) {
      budget.recorded[i].*left = (*read)[i];
    }
  }
  return budget;
}

Result<BudgetDef> chooseBudget(const SwitchingArguments& arguments) {
  const int given =
      (arguments.budgetMs ? 1 : 0) + (arguments.budgetUnits ? 1 : 0) + (arguments.replay ? 1 : 0);
  if (given > 1) {
    return fail("--budget-ms, --budget-units and --replay each say what a step may cost; give one of them");
  }
  if (arguments.replay) {
    return readRecording(*arguments.replay);
  }
  BudgetDef budget;
  budget.milliseconds = arguments.budgetMs.value_or(0.0);
  budget.units = arguments.budgetUnits.value_or(0.0);
  return budget;
}

bool takesBudget(const PhysicsDef& physics) {
  const SwitchingDef& switching = physics.switching;
  return physics.world == WorldKind::kHybrid && switching.switching == Switching::kPair &&
         (switching.policy == Policy::kNone || switching.policy == Policy::kProximity);
}

bool isPair(const PhysicsDef& physics) {
  return physics.world == WorldKind::kHybrid && physics.switching.switching == Switching::kPair;
}

bool isBody(const PhysicsDef& physics) {
  return physics.world == WorldKind::kHybrid && physics.switching.switching == Switching::kBody;
}

// An argument that was given, and which worlds have a use for it.
struct Use {
  const char* argument;
  bool given;
  bool (*by)(const PhysicsDef&);
  const char* advice;
};

}  // namespace

void addSwitchingArguments(CLI::App& command, SwitchingArguments& arguments) {
  const SwitchingDef defaults;
  command
      .add_option("--switching", arguments.switching,
                  fmt::format("What has a level in a hybrid world: {} [{}; bodies with Bullet's collision]",
                              namesOf(switchingChoices()), switchingChoices().front().name))
      ->type_name("NAME");
  command
      .add_option(
          "--policy", arguments.policies,
          fmt::format("What asks for levels in a hybrid world: one of {}, and with pair switching any "
                      "of `scatter list`, with parameters: speed:from=5,to=20 [{} for pairs, {} for "
                      "bodies]",
                      namesOf(policyChoices()), policyChoices().front().name, policyChoices()[1].name))
      ->type_name("NAME,NAME")
      ->delimiter(',');
  addBudgetArguments(command, arguments);
  addCreditArguments(command, arguments);
  addBodyArguments(command, arguments);
  command
      .add_option(
          "--retry-interval", arguments.retryInterval,
          fmt::format("Steps between tries of a switch that was not safe [{}]", defaults.retryInterval))
      ->check(wholeNumber<int>(1))
      ->type_name("STEPS");
  command.add_flag("--unsafe-switching", arguments.unsafeSwitching,
                   "Switch without the safety conditions, to see what they prevent");
}

Result<SwitchingChoices> chooseSwitching(const SwitchingArguments& arguments) {
  SwitchingChoices choices;
  if (arguments.switching) {
    const auto mode = choose(switchingChoices(), "switching mode", *arguments.switching);
    if (!mode) {
      return tl::unexpected(mode.error());
    }
    choices.switching = mode->switching;
  }
  if (auto chosen = choosePolicies(arguments.policies, choices); !chosen) {
    return tl::unexpected(chosen.error());
  }
  auto budget = chooseBudget(arguments);
  if (!budget) {
    return tl::unexpected(budget.error());
  }
  choices.budget = std::move(*budget);
  return choices;
}

SwitchingDef makeSwitching(const SwitchingArguments& arguments, const SwitchingChoices& choices,
                           const WorldSpec& world, Narrowphase narrowphase) {
  SwitchingDef switching;
  // Only the pair algorithm knows levels of pairs.
  const Switching usual = narrowphase == Narrowphase::kScatter ? Switching::kPair : Switching::kBody;
  switching.switching = world.world.switching.value_or(choices.switching.value_or(usual));
  const bool pair = switching.switching == Switching::kPair;
  const Policy standard = switchingChoices()[pair ? 0 : 1].policy;
  switching.policy = world.world.policy.value_or(choices.policy.value_or(standard));
  switching.proximitySteps = arguments.proximitySteps.value_or(switching.proximitySteps);
  switching.retryInterval = arguments.retryInterval.value_or(switching.retryInterval);
  switching.quietSteps = arguments.quietSteps.value_or(switching.quietSteps);
  switching.loadFinePairs = arguments.loadFinePairs.value_or(switching.loadFinePairs);
  switching.safetyConditions = !arguments.unsafeSwitching;
  if (!pair) {
    return switching;
  }
  switching.credit = !arguments.noCredit;
  switching.creditLevel = arguments.creditLevel.value_or(switching.creditLevel);
  if (!world.world.policy) {
    switching.policies = choices.policies;
  }
  if (takesBudget({.world = WorldKind::kHybrid, .switching = switching})) {
    switching.budget = world.budget.value_or(choices.budget);
  }
  return switching;
}

Result<void> checkSwitching(const SwitchingArguments& arguments, const SwitchingChoices& choices,
                            const std::vector<WorldSpec>& worlds, const std::vector<PhysicsDef>& physics) {
  const auto any = [&physics](const auto& use) { return std::any_of(physics.begin(), physics.end(), use); };
  for (const WorldSpec& spec : worlds) {
    const auto index = static_cast<std::size_t>(&spec - worlds.data());
    if (isPair(physics[index]) && physics[index].collision.narrowphase == Narrowphase::kEngine) {
      return fail("--switching pair needs Scatter's pair algorithm; leave --collision out or switch bodies");
    }
    if (spec.budget && !takesBudget(physics[index])) {
      return fail("the world " + spec.label +
                  " takes no budget with this --switching or --policy; leave it out");
    }
  }
  const bool ownSwitching = std::all_of(worlds.begin(), worlds.end(), [](const WorldSpec& spec) {
    return spec.world.kind == WorldKind::kStandard || spec.world.switching.has_value();
  });
  if (choices.switching && ownSwitching) {
    return fail("the world " + worlds.back().world.name +
                " has its own switching mode; leave --switching out or use the hybrid world");
  }
  constexpr const char* kForBudgets =
      "use the hybrid world and pairs, without the --policy finest or coarsest";
  const Use uses[] = {
      {"--budget-units", arguments.budgetUnits.has_value(), takesBudget, kForBudgets},
      {"--replay", arguments.replay.has_value(), takesBudget, kForBudgets},
      {"--credit-level", arguments.creditLevel.has_value(), isPair, "use --switching pair"},
      {"--no-credit", arguments.noCredit, isPair, "use --switching pair"},
      {"this --policy", !choices.policies.empty(), isPair, "use --switching pair"},
      {"--proximity-steps", arguments.proximitySteps.has_value(), isBody, "use --switching body"},
      {"--quiet-steps", arguments.quietSteps.has_value(), isBody, "use --switching body"},
      {"--load-fine-pairs", arguments.loadFinePairs.has_value(), isBody, "use --switching body"},
  };
  for (const Use& use : uses) {
    if (use.given && !any(use.by)) {
      return fail(std::string(use.argument) + " has no meaning here; leave it out or " + use.advice);
    }
  }
  return {};
}

}  // namespace scatter::app
