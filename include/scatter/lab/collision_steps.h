#pragma once

#include <scatter/lab/comparison.h>

#include <string>
#include <vector>

namespace scatter {

/// A world that shows what one step of the pair algorithm is worth.
struct CollisionStep {
  std::string label;
  std::string what;  ///< A few words.
  PhysicsDef physics;
};

/// The standard world first, then the pair algorithm with its steps added one by one, everything at its
/// finest level; last everything at level 1, for scale.
[[nodiscard]] const std::vector<CollisionStep>& collisionSteps();

/// A run of each step: `base` says the scene, the engine, frames, seed and whether stages are timed.
[[nodiscard]] std::vector<RunOptions> collisionStepRuns(const RunOptions& base);

/// Ratios of processor time to the standard world with their extremes over the repeats, the peaks of exact
/// counts, and bytes for each pair and child pair; ends with a new line. The comparison is of
/// collisionStepRuns().
[[nodiscard]] std::string formatCollisionSteps(const Comparison& comparison);

/// The same as CSV, one line a step.
[[nodiscard]] std::string collisionStepsCsv(const Comparison& comparison);

}  // namespace scatter
