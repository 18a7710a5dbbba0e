#include "lod/policy_catalog.h"

#include <cassert>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>

#include "lod/policies_global.h"
#include "lod/policies_group.h"
#include "lod/policies_local.h"

namespace scatter::lod {
namespace {

constexpr double kMostLevel = 32.0;
constexpr double kMostSteps = 10000.0;
constexpr double kMostCount = 1e6;
constexpr double kMostSpeed = 1e6;

/// A parameter, and how it gets into a policy's definition.
template <class Def>
struct Field {
  ParameterInfo info;
  void (*set)(Def&, double);
};

template <class Member>
struct MemberTypes;

template <class Owner, class Type>
struct MemberTypes<Type Owner::*> {
  using Def = Owner;
  using Value = Type;
};

template <auto kMember>
auto field(std::string_view name, std::string_view unit, double least, double most,
           std::string_view meaning) {
  using Def = typename MemberTypes<decltype(kMember)>::Def;
  using Value = typename MemberTypes<decltype(kMember)>::Value;
  // The decimals that were meant, not those of the nearest float.
  const double standard = std::round(static_cast<double>(Def{}.*kMember) * 1e6) / 1e6;
  return Field<Def>{{name, unit, standard, least, most, std::is_integral_v<Value>, meaning},
                    [](Def& def, double value) { def.*kMember = static_cast<Value>(value); }};
}

using MakePolicy =
    std::function<Result<std::unique_ptr<Policy>>(std::span<const double>, const std::shared_ptr<Grouping>&)>;

class Catalog {
 public:
  static const Catalog& instance() {
    static const Catalog catalog;
    return catalog;
  }

  [[nodiscard]] std::span<const PolicyInfo> infos() const { return infos_; }
  [[nodiscard]] const MakePolicy& maker(std::size_t index) const { return makers_[index]; }

 private:
  Catalog() {
    addApproachPolicies();
    addImportancePolicies();
    addGroupPolicies();
    addGlobalPolicies();
    for (std::size_t i = 0; i < infos_.size(); ++i) infos_[i].parameters = parameters_[i];
  }

  void addApproachPolicies();
  void addImportancePolicies();
  void addGroupPolicies();
  void addGlobalPolicies();

  template <class P>
  void add(std::string_view summary, std::vector<Field<typename P::Def>> fields) {
    std::vector<ParameterInfo> parameters;
    for (const auto& one : fields) parameters.push_back(one.info);
    infos_.push_back({P::kName, P::kScope, summary, {}});
    parameters_.push_back(std::move(parameters));
    makers_.push_back([fields = std::move(fields)](std::span<const double> values,
                                                   const std::shared_ptr<Grouping>& grouping) {
      return make<P>(fields, values, grouping);
    });
  }

  template <class P>
  static Result<std::unique_ptr<Policy>> make(const std::vector<Field<typename P::Def>>& fields,
                                              std::span<const double> values,
                                              const std::shared_ptr<Grouping>& grouping) {
    assert(values.size() == fields.size());
    typename P::Def def{};
    for (std::size_t i = 0; i < fields.size(); ++i) fields[i].set(def, values[i]);
    if (const std::string_view mistake = def.mistake(); !mistake.empty()) return fail(std::string(mistake));
    if constexpr (std::is_constructible_v<P, typename P::Def, std::shared_ptr<Grouping>>) {
      return std::make_unique<P>(def, grouping);
    } else {
      return std::make_unique<P>(def);
    }
  }

  std::vector<PolicyInfo> infos_;
  std::vector<std::vector<ParameterInfo>> parameters_;
  std::vector<MakePolicy> makers_;
};

void Catalog::addApproachPolicies() {
  using Proximity = ProximityPolicy::Def;
  add<ProximityPolicy>(
      "coarse before contact: asks for a coarse level where bodies approach each other",
      {field<&Proximity::level>("level", "", 1, kMostLevel, "the level asked for, 1 the coarsest"),
       field<&Proximity::approach>("approach", "m/s", 0, kMostSpeed, "speed of approach that counts as one"),
       field<&Proximity::steps>("steps", "steps", 0, kMostSteps,
                                "how long the request stands once they touch")});

  using Speed = SpeedPolicy::Def;
  add<SpeedPolicy>(
      "fast collisions need less detail: importance falls with relative speed",
      {field<&Speed::from>("from", "m/s", 0, kMostSpeed, "relative speed from which importance falls"),
       field<&Speed::to>("to", "m/s", 0, kMostSpeed, "relative speed at which it is least"),
       field<&Speed::least>("least", "", 0.001, 1, "the least importance"),
       field<&Speed::coarse>("coarse", "m/s", 0, kMostSpeed,
                             "relative speed over which a level is asked for; 0: never"),
       field<&Speed::level>("level", "", 1, kMostLevel, "the level asked for, 1 the coarsest")});
}

void Catalog::addImportancePolicies() {
  using ContactTime = ContactTimePolicy::Def;
  add<ContactTimePolicy>("resting contacts deserve detail: importance grows with time in contact",
                         {field<&ContactTime::steps>("steps", "steps", 1, kMostSteps,
                                                     "time in contact at which importance is most"),
                          field<&ContactTime::most>("most", "", 1, 1000, "the most importance")});

  using Focus = FocusPolicy::Def;
  add<FocusPolicy>(
      "what is large on screen and near to where the viewer looks deserves detail; needs a camera",
      {field<&Focus::size>("size", "half heights", 0.001, 10, "radius on screen at which importance is 1"),
       field<&Focus::angle>("angle", "degrees", 0.1, 80,
                            "off the line of sight, from which importance falls"),
       field<&Focus::least>("least", "", 0.001, 1, "the least importance, and that of what is not seen"),
       field<&Focus::most>("most", "", 1, 1000, "the most importance")});

  add<HeldPolicy>("what the user holds is always at its finest level", {});

  using Mass = MassPolicy::Def;
  add<MassPolicy>("heavy bodies deserve detail: importance grows with the square root of mass",
                  {field<&Mass::reference>("reference", "kg", 0, 1e12,
                                           "mass at which importance is 1; 0: the median of all bodies"),
                   field<&Mass::heavier>("heavier", "", 0, 1,
                                         "1: looks at the heavier body of a pair, 0: at the lighter one"),
                   field<&Mass::most>("most", "", 1, 1000, "the most importance; the least is its inverse")});
}

void Catalog::addGroupPolicies() {
  using Range = GroupRangePolicy::Def;
  add<GroupRangePolicy>(
      "a group that is large for the space it occupies (group size to group range) can do with less detail",
      {field<&Range::packing>("packing", "", 0, 1000,
                              "threshold: volume of members' balls in the group's; 0: any"),
       field<&Range::objects>("objects", "1/m3", 0, kMostCount,
                              "threshold: members in a cubic metre; 0: any"),
       field<&Range::ahead>("ahead", "s", 0, 60, "how far ahead a group that contracts is judged"),
       field<&Range::members>("members", "", 2, kMostCount, "smaller groups are let be"),
       field<&Range::importance>("importance", "", 0.001, 1000, "of a group over a threshold"),
       field<&Range::level>("level", "", 0, kMostLevel, "asked for in such a group; 0: none")});

  using Share = GroupSharePolicy::Def;
  add<GroupSharePolicy>(
      "asks for a coarse level in a whole group when many members are over a local threshold",
      {field<&Share::share>("share", "", 0.01, 0.99, "threshold: share of the members"),
       field<&Share::speed>("speed", "m/s", 0, kMostSpeed, "local threshold: speed against the group's mean"),
       field<&Share::approach>("approach", "m/s", 0, kMostSpeed,
                               "local threshold: approach to a body in proximity"),
       field<&Share::members>("members", "", 2, kMostCount, "smaller groups are let be"),
       field<&Share::importance>("importance", "", 0.001, 1000, "of a group over the threshold"),
       field<&Share::level>("level", "", 0, kMostLevel, "asked for in such a group; 0: none")});

  using Density = GroupDensityPolicy::Def;
  add<GroupDensityPolicy>(
      "many alike neighbours hide errors: importance falls inside dense clusters",
      {field<&Density::from>("from", "", 0, kMostCount,
                             "alike bodies that both touch, from which importance falls"),
       field<&Density::to>("to", "", 1, kMostCount, "alike bodies that both touch, at which it is least"),
       field<&Density::alike>("alike", "", 1, 1000, "ratio of radii up to which neighbours are alike"),
       field<&Density::least>("least", "", 0.001, 1, "the least importance")});
}

void Catalog::addGlobalPolicies() {
  using LoadDef = LoadPolicy::Def;
  add<LoadPolicy>(
      "asks for a coarse level everywhere while steps cost too much; needs a budget",
      {field<&LoadDef::over>("over", "", 0.01, 100, "share of the budget over which it asks"),
       field<&LoadDef::fine>("fine", "", 0, 100, "share of the budget under which the load is fine"),
       field<&LoadDef::steps>("steps", "steps", 1, kMostSteps,
                              "of a fine load, after which it takes the request back"),
       field<&LoadDef::level>("level", "", 1, kMostLevel, "the level asked for, 1 the coarsest")});

  using Overlap = OverlapPolicy::Def;
  add<OverlapPolicy>(
      "asks for a coarse level everywhere while many groups overlap",
      {field<&Overlap::groups>("groups", "", 0, kMostCount, "overlaps of two groups over which it asks"),
       field<&Overlap::members>("members", "", 2, kMostCount, "smaller groups are not counted"),
       field<&Overlap::steps>("steps", "steps", 1, kMostSteps,
                              "of fewer overlaps, after which it takes it back"),
       field<&Overlap::level>("level", "", 1, kMostLevel, "the level asked for, 1 the coarsest")});

  add<FinestPolicy>("everything at its finest level, budget or not", {});
  add<CoarsestPolicy>("everything at level 1, as far as it is safe", {});
}

}  // namespace

std::span<const PolicyInfo> knownPolicies() {
  return Catalog::instance().infos();
}

Result<std::unique_ptr<Policy>> makeKnownPolicy(std::size_t index, std::span<const double> values,
                                                const std::shared_ptr<Grouping>& grouping) {
  assert(index < knownPolicies().size());
  return Catalog::instance().maker(index)(values, grouping);
}

}  // namespace scatter::lod
