#pragma once

#include <scatter/lab/comparison.h>
#include <scatter/lod/budget_state.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace scatter {

/// A scene, and its worlds.
struct BudgetScene {
  std::string name;     ///< In tables.
  RunOptions governed;  ///< The world that is given budgets.
  RunOptions coarsest;  ///< The same with everything at level 1: what it takes is the reachable floor.
  std::string drawn{};  ///< The scene that several seeds were given to, this being one of them; or empty.
};

struct BudgetStudyOptions {
  std::vector<BudgetScene> scenes{};
  std::vector<double> floors{};  ///< Budgets, as multiples of the scene's reachable floor.
  bool byClock = false;          ///< In milliseconds of processor time; otherwise in units, clock-free.

  /// With `byClock`: in the place of the clock, as BudgetDef::machine. Floors are what the dearest frame
  /// takes in a step that is slower than nine of ten.
  std::vector<double> machine{};

  /// Above 0: from the middle of the run on the budget is divided by this,
  double cut = 0.0;
  /// for so many frames; 0: to the end. After that it is what it was, and it is measured when detail is back.
  int cutFrames = 0;
};

/// A frame that took more than 1.02 of its budget.
struct BudgetOverrun {
  int frame = 0;                                 ///< From 0.
  double taken = 0.0;                            ///< In budgets.
  double units = 0.0;                            ///< That it took,
  double planned = 0.0;                          ///< and was planned to take.
  double floor = 0.0;                            ///< Units that could not be given up in it, about.
  double before = 0.0;                           ///< Units of the frame before; 0 of the first one.
  BudgetVerdict verdict = BudgetVerdict::kNone;  ///< What the world said of it.
};

/// How one budget was kept in one scene.
struct BudgetTrial {
  std::string scene;
  double floors = 0.0;  ///< The budget as a multiple of the reachable floor.
  double budget = 0.0;  ///< Units or milliseconds a step; after the cut, if there is one.
  int frames = 0;
  int over2 = 0;       ///< Frames that took more than 1.02 of the budget. With a cut: later than
                       ///< kBudgetWayDown frames after it.
  int over5 = 0;       ///< More than 1.05.
  double worst = 0.0;  ///< The dearest frame, in budgets; with a cut, of the same frames.
  /// Of the same frames, those that took more than the budget in the run without one, and that lacked detail
  /// or contacts with it, or took more all the same.
  int overloaded = 0;
  double use = 0.0;  ///< What the median of them took, in budgets; 0 if there were none.
  double finest =
      0.0;  ///< Of touching pairs with a hybrid, over all frames, at their finest level; 1 for none.
  int impossible = 0;  ///< Frames over the budget in which what could not be given up was over it as well.
  std::vector<BudgetOverrun> overruns{};  ///< The frames of over2.

  /// After a cut that ends: frames until the share of touching pairs that are at their finest level is again,
  /// over kDetailWindow frames, at most kDetailBack below that of the same run without a cut. Absent: not in
  /// this run.
  std::optional<int> back{};
};

/// Frames that a world has to come down to a budget that was cut.
inline constexpr int kBudgetWayDown = 30;

/// When detail counts as back after a cut.
inline constexpr int kDetailWindow = 10;
inline constexpr double kDetailBack = 0.05;

struct BudgetStudy {
  bool byClock = false;  ///< By the clock, or on a machine that was given.
  bool cutEnds = false;
  std::vector<BudgetTrial> trials;  ///< Scene by scene, in the order of the floors.
  std::vector<std::string> idle{};  ///< Scenes in which there is nothing to govern: no trials.
};

/// Runs each scene once in its coarsest world, by the clock three times, once in its governed world without a
/// budget, and once there for each budget. The reachable floor is what the dearest frame of the coarsest
/// world takes (by the clock: of the medians of a frame's three times one dearer than 99 % of them, as odd
/// frames are the machine's). Scenes whose coarsest world costs nothing are left out. Fails as runScene does,
/// and without a scene or a floor, or if there is nothing to govern in any.
[[nodiscard]] Result<BudgetStudy> studyBudgets(
    const BudgetStudyOptions& options, const std::function<void(const CompareProgress&)>& progress = {});

/// A line for each trial, and what came out of all; ends with a new line.
[[nodiscard]] std::string formatBudgets(const BudgetStudy& study);

/// One line for each trial.
[[nodiscard]] std::string budgetsCsv(const BudgetStudy& study);

/// One line for each frame that took more than 1.02 of its budget.
[[nodiscard]] std::string budgetOverrunsCsv(const BudgetStudy& study);

}  // namespace scatter
