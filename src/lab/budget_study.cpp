#include <scatter/lab/budget_study.h>

#include "lab/run_series.h"
#include "lab/text.h"
#include "lab/text_table.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

namespace scatter {

namespace {

using Cells = std::vector<std::string>;

constexpr double kOver2 = 1.02;
constexpr double kOver5 = 1.05;

const std::vector<double>& costsOf(const Run& run, bool byClock) {
  return run.table.values(byClock ? "physics_cpu_ms" : "cost_units");
}

double floorOf(const Run& run, bool byClock) {
  constexpr double kUsual = 0.99;
  return nearestRank(costsOf(run, byClock), byClock ? kUsual : 1.0);
}

BudgetDef constantBudget(double budget, bool byClock) {
  BudgetDef def;
  (byClock ? def.milliseconds : def.units) = budget;
  return def;
}

/// A budget that is cut in the middle of the run.
BudgetDef cutBudget(double before, double after, int frames) {
  BudgetDef def;
  def.recorded.assign(static_cast<std::size_t>(frames / 2), before);
  def.recorded.push_back(after);
  return def;
}

/// From where on the frames of a run are held to its budget.
std::size_t firstJudged(const BudgetStudyOptions& options, std::size_t frames) {
  return options.cut > 0.0 ? std::min(frames / 2 + kBudgetWayDown, frames) : 0;
}

double shareOf(const Run& run, const char* part, const char* whole) {
  const auto sum = [&](const char* column) {
    const auto& values = run.table.values(column);
    return std::accumulate(values.begin(), values.end(), 0.0);
  };
  const double all = sum(whole);
  return all > 0.0 ? sum(part) / all : 1.0;
}

void judge(const Run& run, const BudgetStudyOptions& options, BudgetTrial& trial) {
  const auto& costs = costsOf(run, options.byClock);
  const auto& units = run.table.values("cost_units");
  const auto& floors = run.table.values("floor_units");
  const auto& pairs = run.table.values("narrowphase_pairs");
  const auto& finest = run.table.values("finest_pairs");
  std::vector<double> withheld;
  trial.frames = static_cast<int>(costs.size());
  for (std::size_t i = firstJudged(options, costs.size()); i < costs.size(); ++i) {
    const double taken = costs[i] / trial.budget;
    trial.over2 += taken > kOver2 ? 1 : 0;
    trial.over5 += taken > kOver5 ? 1 : 0;
    trial.worst = std::max(trial.worst, taken);
    trial.impossible += taken > kOver2 && units[i] > 0.0 && floors[i] / units[i] * taken > 1.0 ? 1 : 0;
    if (finest[i] < pairs[i]) {
      withheld.push_back(taken);
    }
  }
  trial.withheld = static_cast<int>(withheld.size());
  trial.use = nearestRank(std::move(withheld), 0.5);
  trial.finest = shareOf(run, "touching_finest_pairs", "touching_pairs");
}

/// The runs of one study.
class Runner {
 public:
  Runner(const BudgetStudyOptions& options, const std::function<void(const CompareProgress&)>& progress)
      : options_(options), series_(options.scenes.size() * (1 + options.floors.size()), progress) {}

  Result<void> addScene(const BudgetScene& scene, BudgetStudy& study) {
    const auto coarsest = series_.run(scene.coarsest, scene.name + ", coarsest");
    if (!coarsest) {
      return tl::unexpected(coarsest.error());
    }
    const double floor = floorOf(*coarsest, options_.byClock);
    if (!(floor > 0.0)) {
      return fail("the scene " + scene.name + " has nothing to govern: its coarsest world costs nothing");
    }
    for (const double floors : options_.floors) {
      if (auto added = addTrial(scene, floors, floor * floors, study); !added) {
        return added;
      }
    }
    return {};
  }

 private:
  Result<void> addTrial(const BudgetScene& scene, double floors, double budget, BudgetStudy& study) {
    RunOptions governed = scene.governed;
    const double cut = options_.cut > 0.0 ? budget / options_.cut : budget;
    governed.physics.switching.budget = options_.cut > 0.0 ? cutBudget(budget, cut, governed.frames)
                                                           : constantBudget(budget, options_.byClock);
    const auto done = series_.run(governed, scene.name + ", " + lab::readableNumber(floors) + " floors");
    if (!done) {
      return tl::unexpected(done.error());
    }
    BudgetTrial trial{.scene = scene.name, .floors = floors, .budget = cut};
    judge(*done, options_, trial);
    study.trials.push_back(std::move(trial));
    return {};
  }

  const BudgetStudyOptions& options_;
  lab::RunSeries series_;
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

}  // namespace

Result<BudgetStudy> studyBudgets(const BudgetStudyOptions& options,
                                 const std::function<void(const CompareProgress&)>& progress) {
  if (options.scenes.empty() || options.floors.empty()) {
    return fail("a study of budgets needs at least one scene and one budget; name some");
  }
  BudgetStudy study{.byClock = options.byClock, .trials = {}};
  Runner runner(options, progress);
  for (const BudgetScene& scene : options.scenes) {
    if (auto added = runner.addScene(scene, study); !added) {
      return tl::unexpected(added.error());
    }
  }
  return study;
}

std::string formatBudgets(const BudgetStudy& study) {
  std::vector<Cells> lines{{"", "floors", study.byClock ? "ms" : "units", "> 1.02 %", "> 1.05 %", "worst",
                            "use", "finest", "impossible"}};
  for (const BudgetTrial& trial : study.trials) {
    lines.push_back({trial.scene, lab::readableNumber(trial.floors), lab::readableNumber(trial.budget),
                     percent(trial.over2, trial.frames), percent(trial.over5, trial.frames),
                     lab::fixedNumber(trial.worst, 2),
                     trial.withheld > 0 ? lab::fixedNumber(trial.use, 2) : "-",
                     lab::fixedNumber(trial.finest, 2), std::to_string(trial.impossible)});
  }
  return lab::textTable(lines) +
         lab::fitTerminal(
             "Floors: the budget in what the dearest frame takes with everything at level 1. Use: the median "
             "frame in which some detail was withheld, in budgets. Finest: of touching pairs. Impossible: "
             "frames over the budget in which what could not be given up was over it as well.\n" +
             verdictOf(study));
}

std::string budgetsCsv(const BudgetStudy& study) {
  std::vector<Cells> lines{{"scene", "floors", study.byClock ? "budget_ms" : "budget_units", "frames",
                            "over_2", "over_5", "worst", "withheld", "use", "finest", "impossible"}};
  for (const BudgetTrial& trial : study.trials) {
    lines.push_back({trial.scene, lab::shortestNumber(trial.floors), lab::shortestNumber(trial.budget),
                     std::to_string(trial.frames), std::to_string(trial.over2), std::to_string(trial.over5),
                     lab::shortestNumber(trial.worst), std::to_string(trial.withheld),
                     lab::shortestNumber(trial.use), lab::shortestNumber(trial.finest),
                     std::to_string(trial.impossible)});
  }
  return lab::csvText(lines);
}

}  // namespace scatter
