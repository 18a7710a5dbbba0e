#include "viewer/policy_choice.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "lod/policy_catalog.h"

namespace scatter::viewer {
namespace {

struct NamedPolicy {
  Policy policy;
  std::string_view name;
  std::string_view summary;
};

/// Those that a world has without a list of names.
constexpr std::array<NamedPolicy, 4> kBase{{
    {Policy::kNone, "none", "only what is asked for by hand"},
    {Policy::kProximity, "proximity", "coarser when others come near, finer when free"},
    {Policy::kFinest, "finest", "everything at its finest level"},
    {Policy::kCoarsest, "coarsest", "everything at level 1, as far as it is safe"},
}};

/// Whether this is the policy, perhaps with parameters.
bool names(const std::string& given, std::string_view name) {
  return given.substr(0, given.find(':')) == name;
}

bool isBase(Policy policy, std::string_view name) {
  return policy != Policy::kNone && std::any_of(kBase.begin(), kBase.end(), [&](const NamedPolicy& base) {
           return base.policy == policy && base.name == name;
         });
}

}  // namespace

std::vector<PolicyChoice> policyChoices(const SwitchingDef& now) {
  std::vector<PolicyChoice> choices;
  if (now.switching == Switching::kBody) {
    for (const NamedPolicy& base : kBase)
      choices.push_back({std::string(base.name), std::string(base.summary), now.policy == base.policy});
    return choices;
  }
  for (const lod::PolicyInfo& policy : lod::knownPolicies()) {
    const bool named = std::any_of(now.policies.begin(), now.policies.end(),
                                   [&](const std::string& given) { return names(given, policy.name); });
    choices.push_back(
        {std::string(policy.name), std::string(policy.summary), named || isBase(now.policy, policy.name)});
  }
  return choices;
}

ChosenPolicies choosePolicy(const SwitchingDef& now, const std::string& name, bool chosen) {
  ChosenPolicies result{now.policy, now.policies};
  if (now.switching == Switching::kBody) {
    for (const NamedPolicy& base : kBase) {
      if (chosen && base.name == name) result.policy = base.policy;
    }
    return result;
  }
  if (isBase(result.policy, name)) result.policy = Policy::kNone;
  std::erase_if(result.named, [&](const std::string& given) { return names(given, name); });
  if (chosen) result.named.push_back(name);
  return result;
}

}  // namespace scatter::viewer
