#pragma once

#include <scatter/result.h>

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "lod/policy_catalog.h"
#include "lod/policy_list.h"

namespace scatter::lod {

/// Makes a policy from a specification: its name, then if need be a colon and parameters, such as "speed" or
/// "speed:from=5,to=20". Spaces around words do not matter. Parameters that are not named have their standard
/// values. Fails in one line on what is not known (naming what is, and the nearest), on values that are no
/// numbers, out of range, given twice, or that do not go together.
/// `grouping`: shared by the policies that look at groups; null: the policy makes its own if it needs one.
[[nodiscard]] Result<std::unique_ptr<Policy>> makePolicy(std::string_view spec,
                                                         const std::shared_ptr<Grouping>& grouping = nullptr);

/// Makes a list of policies, in order, that share what they know of groups. Fails like makePolicy().
[[nodiscard]] Result<std::unique_ptr<PolicyList>> makePolicyList(std::span<const std::string> specs);

}  // namespace scatter::lod
