#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "lod/grouping.h"
#include "lod/policy.h"

namespace scatter::lod {

/// What becomes of a group that a policy finds over its threshold.
struct GroupEffect {
  int members = 1;          ///< Smaller groups are let be.
  float importance = 1.0F;  ///< Of its pairs' detail.
  int level = 0;            ///< That is asked for; 0: none.
};

/// Judges whole groups, whenever groups are made anew. A group whose members were mostly over the threshold
/// before stays so until it is a fifth below.
class GroupPolicy : public Policy {
 public:
  [[nodiscard]] Scope scope() const final { return Scope::kGroup; }
  void observe(const Situation& situation) final;
  void advise(const Situation& situation, const PairView& pair, Wish& wish) const final;

 protected:
  GroupPolicy(const GroupEffect& effect, std::shared_ptr<Grouping> grouping);

  /// Before the groups are measured.
  virtual void prepare(const Situation& /*situation*/) {}

  /// What is looked at, in thresholds: over 1 is over the threshold.
  [[nodiscard]] virtual float measure(const Situation& situation, const Group& group) const = 0;

  [[nodiscard]] const Grouping& grouping() const { return *grouping_; }

 private:
  [[nodiscard]] bool wasMostlyOver(const Group& group) const;

  GroupEffect effect_;
  std::shared_ptr<Grouping> grouping_;
  std::uint64_t generation_ = 0;
  std::vector<std::uint8_t> groupIsOver_;
  std::vector<std::uint8_t> bodyWasOver_;
};

/// The report's "group size to group range ratio" (section 3.4.4): the number of objects in a group, or their
/// volume, against the space that they occupy, which is the ball around the group. Looks ahead by the speed
/// at which the group contracts.
class GroupRangePolicy final : public GroupPolicy {
 public:
  static constexpr std::string_view kName = "group-range";
  static constexpr Scope kScope = Scope::kGroup;

  struct Def {
    float packing = 0.3F;  ///< Volume of the members' balls in the volume of the group's; 0: not looked at.
    float objects = 0.0F;  ///< Members in a cubic metre; 0: not looked at.
    float ahead = 0.5F;    ///< Seconds.
    int members = 8;
    float importance = 0.5F;
    int level = 0;

    [[nodiscard]] std::string_view mistake() const {
      return packing > 0.0F || objects > 0.0F ? "" : R"("packing" and "objects" can not both be 0)";
    }
  };

  GroupRangePolicy(const Def& def, std::shared_ptr<Grouping> grouping)
      : GroupPolicy({def.members, def.importance, def.level}, std::move(grouping)), def_(def) {}

  [[nodiscard]] std::string_view name() const override { return kName; }

 private:
  [[nodiscard]] float measure(const Situation& situation, const Group& group) const override;

  Def def_;
};

/// "When the number of objects exceeding local thresholds is high" (report, section 3.4.4): looks at the
/// share of a group's members that are faster than a threshold, against the group's mean velocity, or are in
/// proximity to something that they approach faster than another.
class GroupSharePolicy final : public GroupPolicy {
 public:
  static constexpr std::string_view kName = "group-share";
  static constexpr Scope kScope = Scope::kGroup;

  struct Def {
    float share = 0.5F;     ///< Of the members.
    float speed = 5.0F;     ///< Metres a second.
    float approach = 5.0F;  ///< Metres a second.
    int members = 8;
    float importance = 1.0F;
    int level = 1;

    [[nodiscard]] static std::string_view mistake() { return {}; }
  };

  GroupSharePolicy(const Def& def, std::shared_ptr<Grouping> grouping)
      : GroupPolicy({def.members, def.importance, def.level}, std::move(grouping)), def_(def) {}

  [[nodiscard]] std::string_view name() const override { return kName; }

 private:
  void prepare(const Situation& situation) override;
  [[nodiscard]] float measure(const Situation& situation, const Group& group) const override;

  Def def_;
  std::vector<std::uint8_t> approaches_;  ///< By body.
};

/// "Anomalies that occur between homogeneous distractors are less obvious" (O'Sullivan and Dingliana; report,
/// section 3.4.1): importance falls with the number of neighbours of about the same size that the two bodies
/// of a pair touch, the smaller number of the two. Balls around long bodies would find neighbours far away.
class GroupDensityPolicy final : public NamedPolicy<GroupDensityPolicy> {
 public:
  static constexpr std::string_view kName = "group-density";
  static constexpr Scope kScope = Scope::kGroup;

  struct Def {
    int from = 3;
    int to = 9;
    float alike = 1.5F;  ///< Larger radius over smaller one.
    float least = 0.3F;  ///< Importance.

    [[nodiscard]] std::string_view mistake() const { return to > from ? "" : R"("to" must be above "from")"; }
  };

  explicit GroupDensityPolicy(const Def& def) : def_(def) {}

  void observe(const Situation& situation) override;
  void advise(const Situation& situation, const PairView& pair, Wish& wish) const override;

 private:
  [[nodiscard]] int neighboursOf(std::uint32_t body) const;

  Def def_;
  std::uint64_t step_ = 0;                 ///< When neighbours were last counted.
  std::vector<std::uint16_t> neighbours_;  ///< Alike ones, by body.
};

}  // namespace scatter::lod
