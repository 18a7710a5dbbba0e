#pragma once

#include <scatter/result.h>
#include <scatter/world/physics.h>

#include <memory>
#include <optional>

namespace scatter::bench {

/// What a measuring program can be asked for. An engine fails on a setting that it does not have.
struct EngineOptions {
  bool coarsest = false;              ///< Bodies at level 1 instead of the finest level.
  bool countContacts = false;         ///< Where counting costs time inside the step.
  std::optional<float> convexRadius;  ///< How far hulls are shrunk and rounded again, metres.
  std::optional<int> subSteps;        ///< Of one step of 1/60 s.
  std::optional<int> iterations;      ///< Of the velocity solver.
  int threads = 1;
  bool pairAlgorithm = false;  ///< The pair algorithm of a hybrid world, all at the finest level.
  bool lean = false;           ///< The same as the lab's world `lean` has it.
  bool boxes = false;          ///< The bounding boxes of hulls instead of the hulls.
};

struct EngineInfo {
  const char* program = "";  ///< The measuring program's name.

  /// Whether the solid of a hull reaches beyond its vertices by the margin of its levels.
  bool hasMargins = false;
};

/// Each program links one engine, which defines these. Of `def` an engine takes the gravity.
[[nodiscard]] EngineInfo engineInfo();
[[nodiscard]] Result<std::unique_ptr<Physics>> makeEngine(const EngineOptions& options,
                                                          const PhysicsDef& def);

}  // namespace scatter::bench
