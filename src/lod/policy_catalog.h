#pragma once

#include <scatter/result.h>

#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "lod/grouping.h"
#include "lod/policy.h"

namespace scatter::lod {

/// A parameter of a policy, as people set and read it.
struct ParameterInfo {
  std::string_view name{};
  std::string_view unit{};  ///< Empty if it has none.
  double standard = 0.0;    ///< If it is not set.
  double least = 0.0;
  double most = 0.0;
  bool whole = false;          ///< Whole numbers only.
  std::string_view meaning{};  ///< One line.
};

/// A policy, as people choose it.
struct PolicyInfo {
  std::string_view name{};
  Scope scope = Scope::kLocal;
  std::string_view summary{};  ///< One line.
  std::span<const ParameterInfo> parameters{};
};

/// All policies that come with Scatter: local ones, group ones, global ones. Lives as long as the program.
[[nodiscard]] std::span<const PolicyInfo> knownPolicies();

/// Makes a known policy. `values`: of its parameters, in their order and range. `grouping`: for policies that
/// look at groups. Fails if the values do not go together, with a few words.
[[nodiscard]] Result<std::unique_ptr<Policy>> makeKnownPolicy(std::size_t index,
                                                              std::span<const double> values,
                                                              const std::shared_ptr<Grouping>& grouping);

}  // namespace scatter::lod
