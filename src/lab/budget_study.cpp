#include <scatter/lab/budget_study.h>
#include <scatter/lab/recorded_machine.h>

#include "lab/repeats.h"
#include "lab/run_series.h"
#include "lab/text.h"
#include "lab/text_table.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <string>
#include <utility>

namespace scatter {

namespace {

using Cells = std::vector<std::string>;

constexpr double kOver2 = 1.02;
constexpr double kOver5 = 1.05;

bool asksTheClock(const BudgetStudyOptions& options) {
  return options.byClock && options.machine.empty();
}

const char* measured(const BudgetStudyOptions& options) {
  return asksTheClock(options) ? "physics_cpu_ms" : "cost_units";
}

/// What a frame takes: units, or milliseconds by the clock or on the machine.
std::vector<double> costsOf(const Run& run, const BudgetStudyOptions& options) {
  const std::vector<double>& values = run.table.values(measured(options));
  return options.machine.empty() ? values : timeOnMachine(values, options.machine);
}

/// Of runs of the coarsest world. Odd frames are the clock's. On a machine that becomes slower and quicker
/// budgets are to be such that they can be kept while it is slow.
double floorOf(const std::vector<std::vector<double>>& runs, const BudgetStudyOptions& options) {
  constexpr double kUsual = 0.99;
  constexpr double kSlow = 0.9;
  const double share = asksTheClock(options) ? kUsual : 1.0;
  const double dearest = nearestRank(lab::framewiseMedian(runs), share);
  return options.machine.empty() ? dearest : dearest * nearestRank(options.machine, kSlow);
}

/// Runs of the coarsest world; by the clock several, as all budgets depend on what is measured in it.
std::size_t countFloorRuns(const BudgetStudyOptions& options) {
  return asksTheClock(options) ? 3 : 1;
}

BudgetDef constantBudget(double budget, const BudgetStudyOptions& options) {
  BudgetDef def;
  (options.byClock ? def.milliseconds : def.units) = budget;
  def.machine = options.machine;
  return def;
}

/// The frames of a run, and which of them have a budget that was cut.
struct Cut {
  Cut(const BudgetStudyOptions& options, std::size_t count) : frames(count) {
    if (!(options.cut > 0.0)) return;
    first = count / 2;
    end =
        options.cutFrames > 0 ? std::min(first + static_cast<std::size_t>(options.cutFrames), count) : count;
  }

  [[nodiscard]] bool exists() const { return end > 0; }

  /// The frames that are held to the budget.
  [[nodiscard]] std::size_t firstJudged() const {
    return exists() ? std::min(first + kBudgetWayDown, end) : 0;
  }
  [[nodiscard]] std::size_t endJudged() const { return exists() ? end : frames; }

  std::size_t frames;
  std::size_t first = 0;
  std::size_t end = 0;
};

/// A budget that is cut in the middle of the run.
BudgetDef cutBudget(double before, double after, const Cut& cut) {
  BudgetDef def;
  def.recorded.assign(cut.first, {.given = before});
  // The last one stays.
  def.recorded.resize(cut.end < cut.frames ? cut.end : cut.first + 1, {.given = after});
  if (cut.end < cut.frames) def.recorded.push_back({.given = before});
  return def;
}

double shareOf(const Run& run, const char* part, const char* whole) {
  const auto sum = [&](const char* column) {
    const auto& values = run.table.values(column);
    return std::accumulate(values.begin(), values.end(), 0.0);
  };
  const double all = sum(whole);
  return all > 0.0 ? sum(part) / all : 1.0;
}

/// In each frame, of touching pairs that could be coarser those at their finest level.
std::vector<double> finestShares(const Run& run) {
  const auto& touching = run.table.values("touching_pairs");
  const auto& finest = run.table.values("touching_finest_pairs");
  std::vector<double> shares;
  for (std::size_t i = 0; i < touching.size(); ++i) {
    shares.push_back(touching[i] > 0.0 ? finest[i] / touching[i] : 1.0);
  }
  return shares;
}

/// As BudgetTrial::back, after a cut that ended before the frame `end`.
std::optional<int> framesUntilBack(const Run& cut, const Run& uncut, std::size_t end) {
  const std::vector<double> has = finestShares(cut);
  const std::vector<double> wanted = finestShares(uncut);
  const std::size_t frames = std::min(has.size(), wanted.size());
  for (std::size_t first = end; first + kDetailWindow <= frames; ++first) {
    double missing = 0.0;
    for (std::size_t i = first; i < first + kDetailWindow; ++i) missing += wanted[i] - has[i];
    if (missing <= kDetailBack * kDetailWindow) return static_cast<int>(first - end);
  }
  return std::nullopt;
}

BudgetOverrun overrunOf(const Run& run, std::size_t frame, double taken) {
  const auto of = [&](const char* column) { return run.table.values(column)[frame]; };
  return {.frame = static_cast<int>(frame),
          .taken = taken,
          .units = of("cost_units"),
          .planned = of("planned_units"),
          .floor = of("floor_units"),
          .before = frame > 0 ? run.table.values("cost_units")[frame - 1] : 0.0,
          .verdict = static_cast<BudgetVerdict>(static_cast<int>(of("budget_verdict")))};
}

/// `unlimited`: what the frames take without a budget.
void judge(const Run& run, const std::vector<double>& unlimited, const BudgetStudyOptions& options,
           BudgetTrial& trial) {
  const std::vector<double> costs = costsOf(run, options);
  const auto& units = run.table.values("cost_units");
  const auto& floors = run.table.values("floor_units");
  const auto& touching = run.table.values("touching_pairs");
  const auto& finest = run.table.values("touching_finest_pairs");
  const auto& hidden = run.table.values("hidden_contacts");
  std::vector<double> overloaded;
  trial.frames = static_cast<int>(costs.size());
  const Cut cut(options, costs.size());
  for (std::size_t i = cut.firstJudged(); i < cut.endJudged(); ++i) {
    const double taken = costs[i] / trial.budget;
    if (taken > kOver2) trial.overruns.push_back(overrunOf(run, i, taken));
    trial.over5 += taken > kOver5 ? 1 : 0;
    trial.worst = std::max(trial.worst, taken);
    trial.impossible += taken > kOver2 && units[i] > 0.0 && floors[i] / units[i] * taken > 1.0 ? 1 : 0;
    // Bodies that have fallen asleep sooner take nothing, and lack nothing either.
    const bool isShort = touching[i] > finest[i] || hidden[i] > 0.0 || taken > 1.0;
    if (unlimited[i] > trial.budget && isShort) overloaded.push_back(taken);
  }
  trial.over2 = static_cast<int>(trial.overruns.size());
  trial.overloaded = static_cast<int>(overloaded.size());
  trial.use = nearestRank(std::move(overloaded), 0.5);
  trial.finest = shareOf(run, "touching_finest_pairs", "touching_pairs");
}

/// The runs of one study.
class Runner {
 public:
  Runner(const BudgetStudyOptions& options, const std::function<void(const CompareProgress&)>& progress)
      : options_(options),
        series_(options.scenes.size() *
                    (1 + countFloorRuns(options) + (options.cutFrames > 0 ? 2 : 1) * options.floors.size()),
                progress) {}

  Result<void> addScene(const BudgetScene& scene, BudgetStudy& study) {
    std::vector<std::vector<double>> coarsest;
    for (std::size_t i = 0; i < countFloorRuns(options_); ++i) {
      const auto run = series_.run(scene.coarsest, scene.name + ", coarsest");
      if (!run) {
        return tl::unexpected(run.error());
      }
      if (auto drawn = i == 0 ? checkDrawn(scene, run->summary.stateHash) : Result<void>(); !drawn) {
        return drawn;
      }
      coarsest.push_back(run->table.values(measured(options_)));
    }
    const double floor = floorOf(coarsest, options_);
    if (!(floor > 0.0)) {
      study.idle.push_back(scene.name);
      return {};
    }
    const auto unlimited = runWith(scene, BudgetDef(), scene.name + ", no budget");
    if (!unlimited) {
      return tl::unexpected(unlimited.error());
    }
    const std::vector<double> wanted = costsOf(*unlimited, options_);
    for (const double floors : options_.floors) {
      if (auto added = addTrial(scene, floors, floor * floors, wanted, study); !added) {
        return added;
      }
    }
    return {};
  }

 private:
  Result<void> addTrial(const BudgetScene& scene, double floors, double budget,
                        const std::vector<double>& unlimited, BudgetStudy& study) {
    const Cut cut(options_, static_cast<std::size_t>(scene.governed.frames));
    const double held = cut.exists() ? budget / options_.cut : budget;
    const std::string name = scene.name + ", " + lab::readableNumber(floors) + " floors";
    const BudgetDef constant = constantBudget(budget, options_);
    const auto done = runWith(scene, cut.exists() ? cutBudget(budget, held, cut) : constant, name);
    if (!done) {
      return tl::unexpected(done.error());
    }
    BudgetTrial trial{.scene = scene.name, .floors = floors, .budget = held};
    judge(*done, unlimited, options_, trial);
    if (options_.cutFrames > 0) {
      const auto uncut = runWith(scene, constant, name + ", no cut");
      if (!uncut) {
        return tl::unexpected(uncut.error());
      }
      trial.back = framesUntilBack(*done, *uncut, cut.end);
    }
    study.trials.push_back(std::move(trial));
    return {};
  }

  // Runs that are the same with another seed would be counted as if there were several.
  Result<void> checkDrawn(const BudgetScene& scene, std::uint64_t lastState) {
    if (scene.drawn.empty()) {
      return {};
    }
    const auto [before, isFirst] = drawn_.try_emplace({scene.drawn, lastState}, scene.name);
    if (!isFirst && before->second != scene.name) {
      return fail(scene.name + " is the same run as " + before->second + ": its seed changes nothing in " +
                  scene.drawn + "; give it one seed");
    }
    return {};
  }

  Result<Run> runWith(const BudgetScene& scene, const BudgetDef& budget, const std::string& name) {
    RunOptions governed = scene.governed;
    governed.physics.switching.budget = budget;
    return series_.run(governed, name);
  }

  const BudgetStudyOptions& options_;
  lab::RunSeries series_;

  /// Names of runs, by the scene that was given several seeds and its last state.
  std::map<std::pair<std::string, std::uint64_t>, std::string> drawn_;
};

/// A share of the frames, such as "0.30".
std::string percent(int count, int frames) {
  return lab::fixedNumber(frames > 0 ? 100.0 * count / frames : 0.0, 2);
}

std::string verdictOf(const BudgetStudy& study) {
  int frames = 0;
  int over2 = 0;
  int over5 = 0;
  int impossible = 0;
  double worst = 0.0;
  for (const BudgetTrial& trial : study.trials) {
    frames += trial.frames;
    over2 += trial.over2;
    over5 += trial.over5;
    impossible += trial.impossible;
    worst = std::max(worst, trial.worst);
  }
  return std::to_string(study.trials.size()) + " runs, " + std::to_string(frames) +
         " frames: " + percent(over2, frames) + " % took more than 1.02 of the budget, " +
         percent(over5, frames) + " % more than 1.05, the worst " + lab::fixedNumber(worst, 2) + "; in " +
         std::to_string(impossible) + " frames what could not be given up was more than the budget.";
}

std::string idleScenes(const BudgetStudy& study) {
  std::string names;
  for (const std::string& name : study.idle) names += (names.empty() ? "" : ", ") + name;
  return "nothing to govern, as the coarsest world costs nothing, in " + names;
}

}  // namespace

Result<BudgetStudy> studyBudgets(const BudgetStudyOptions& options,
                                 const std::function<void(const CompareProgress&)>& progress) {
  if (options.scenes.empty() || options.floors.empty()) {
    return fail("a study of budgets needs at least one scene and one budget; name some");
  }
  BudgetStudy study{.byClock = options.byClock, .cutEnds = options.cutFrames > 0, .trials = {}};
  Runner runner(options, progress);
  for (const BudgetScene& scene : options.scenes) {
    if (auto added = runner.addScene(scene, study); !added) {
      return tl::unexpected(added.error());
    }
  }
  if (study.trials.empty()) {
    return fail(idleScenes(study) + "; name scenes with hybrids");
  }
  return study;
}

std::string formatBudgets(const BudgetStudy& study) {
  std::vector<Cells> lines{{"", "floors", study.byClock ? "ms" : "units", "> 1.02 %", "> 1.05 %", "worst",
                            "use", "finest", "impossible"}};
  if (study.cutEnds) lines.front().emplace_back("back");
  for (const BudgetTrial& trial : study.trials) {
    lines.push_back({trial.scene, lab::readableNumber(trial.floors), lab::readableNumber(trial.budget),
                     percent(trial.over2, trial.frames), percent(trial.over5, trial.frames),
                     lab::fixedNumber(trial.worst, 2),
                     trial.overloaded > 0 ? lab::fixedNumber(trial.use, 2) : "-",
                     lab::fixedNumber(trial.finest, 2), std::to_string(trial.impossible)});
    if (study.cutEnds) lines.back().push_back(trial.back ? std::to_string(*trial.back) : "not");
  }
  return lab::textTable(lines) +
         lab::fitTerminal(
             "Floors: the budget in what the dearest frame takes with everything at level 1. Use: the median "
             "of the frames that take more than the budget without one and lack detail or contacts with it, "
             "in budgets. Finest: of touching pairs. Impossible: frames over the budget in which what could "
             "not be given up was over it as well." +
             (study.cutEnds
                  ? std::string(" Back: frames after the cut until as many touching pairs are at their "
                                "finest level as without one.")
                  : std::string()) +
             "\n" + verdictOf(study) +
             (study.idle.empty() ? std::string() : "\nLeft out: " + idleScenes(study) + "."));
}

std::string budgetsCsv(const BudgetStudy& study) {
  std::vector<Cells> lines{{"scene", "floors", study.byClock ? "budget_ms" : "budget_units", "frames",
                            "over_2", "over_5", "worst", "overloaded", "use", "finest", "impossible"}};
  if (study.cutEnds) lines.front().emplace_back("back");
  for (const BudgetTrial& trial : study.trials) {
    lines.push_back({trial.scene, lab::shortestNumber(trial.floors), lab::shortestNumber(trial.budget),
                     std::to_string(trial.frames), std::to_string(trial.over2), std::to_string(trial.over5),
                     lab::shortestNumber(trial.worst), std::to_string(trial.overloaded),
                     lab::shortestNumber(trial.use), lab::shortestNumber(trial.finest),
                     std::to_string(trial.impossible)});
    if (study.cutEnds) lines.back().push_back(trial.back ? std::to_string(*trial.back) : "");
  }
  return lab::csvText(lines);
}

std::string budgetOverrunsCsv(const BudgetStudy& study) {
  std::vector<Cells> lines{{"scene", "floors", "frame", "taken", "units", "planned_units", "floor_units",
                            "units_before", "verdict"}};
  for (const BudgetTrial& trial : study.trials) {
    for (const BudgetOverrun& overrun : trial.overruns) {
      lines.push_back({trial.scene, lab::shortestNumber(trial.floors), std::to_string(overrun.frame),
                       lab::shortestNumber(overrun.taken), lab::shortestNumber(overrun.units),
                       lab::shortestNumber(overrun.planned), lab::shortestNumber(overrun.floor),
                       lab::shortestNumber(overrun.before),
                       std::to_string(static_cast<int>(overrun.verdict))});
    }
  }
  return lab::csvText(lines);
}

}  // namespace scatter
