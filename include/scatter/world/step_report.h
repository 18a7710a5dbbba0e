#pragma once

#include <scatter/collision/pair_algorithm.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace scatter {

/// The stages of a physics step (report, section 5.1.3), in the order in which they run.
enum class Stage : std::uint8_t {
  kUpdateAabbs,
  kPredictMotion,
  kCollisionDetection,  ///< Broadphase pairs and narrowphase, without the AABB update and the plan.
  kIslands,
  kNoncontactConstraints,
  kContactConstraints,
  kIntegrate,
  kVehicles,
  kActivation,
  kPlan,  ///< Requests, safety queries and switches.
};
inline constexpr std::size_t kStageCount = 10;

/// The stage's column in frames.csv, such as "update_aabbs_ms".
[[nodiscard]] std::string_view stageColumn(Stage stage);

/// Wall milliseconds that each stage of the last step took, by Stage; zero while profiling is off.
using StageTimes = std::array<double, kStageCount>;

/// Exact counts of the last step (report, section 5.1.3); the same run after run.
struct StepCounters {
  std::uint32_t objects = 0;
  std::uint32_t hybrids = 0;
  std::uint32_t joints = 0;
  std::uint32_t overlappingPairs = 0;  ///< Broadphase pairs.
  std::uint32_t narrowphasePairs = 0;  ///< Pairs that went through the narrowphase.
  std::uint32_t pairsWithHybrid = 0;   ///< Of those, with at least one hybrid.
  std::uint32_t pairsWithoutHybrid = 0;
  std::uint32_t manifolds = 0;
  std::uint32_t contacts = 0;     ///< Contact points in all manifolds.
  std::uint32_t newContacts = 0;  ///< Contact points added in this step.
  std::uint32_t requests = 0;     ///< Requests standing after the step.
  std::uint32_t switchesCoarser = 0;
  std::uint32_t switchesFiner = 0;
  std::uint32_t retractions = 0;
  std::uint32_t creditedPairs = 0;
  std::uint32_t finestPairs = 0;  ///< Narrowphase pairs whose bodies are both at their finest level.

  // Pair switching; zero without it.
  std::uint32_t touchingPairs = 0;        ///< Pairs with a hybrid that are closer than 1 cm.
  std::uint32_t touchingFinestPairs = 0;  ///< Of those, at the pair's finest level.
  std::uint32_t reusedPairs = 0;          ///< Pairs in contact that kept their contacts for want of budget.
  std::uint32_t hiddenContacts = 0;       ///< Contacts that the solver was not shown for want of budget.
  std::uint32_t restingBodies = 0;        ///< Bodies that fall asleep sooner for want of budget.
  std::uint32_t wokenBodies = 0;          ///< Bodies that a budget wakes to give detail back.
  std::uint32_t iterationsLeftOut = 0;    ///< Of the solver, for want of budget.
  std::uint32_t blockedTries = 0;         ///< Switches that were not safe.
  std::uint32_t separationQueries = 0;    ///< Direct queries, for switches and for audits of credit.
  std::uint32_t costUnits = 0;            ///< What the step cost in the governor's units.
  std::uint32_t plannedUnits = 0;         ///< What it was planned to cost.
  std::uint32_t floorUnits = 0;  ///< What of it could not be given up, about; 0 where the budget was kept.
  std::uint32_t reachableUnits = 0;  ///< What it would have cost with every pair at its coarsest level,
                                     ///< about; 0 without a budget.
  std::uint32_t budgetVerdict = 0;   ///< BudgetVerdict, as a number.
  std::uint32_t withheldPairs = 0;   ///< Pairs that the budget kept below the level that they would have.
  std::uint32_t overduePairs = 0;    ///< Pairs on credit that it did not let look at their finest shapes in
                                     ///< time: they may overlap.

  PairWork pairWork{};  ///< Zero without the pair algorithm.
};

}  // namespace scatter
