#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "lod/grouping.h"
#include "lod/latch.h"
#include "lod/policy.h"

namespace scatter::lod {

/// "When system performance has dropped below a threshold" (report, section 3.4.4): asks for a coarse level
/// in all pairs once a step's cost is over a share of the budget, and takes it back when the load has been
/// fine for a while. Looks at the last step's units; says nothing without a budget. The governor does the
/// same for the pairs that matter least: this is the report's simple trigger.
class LoadPolicy final : public NamedPolicy<LoadPolicy> {
 public:
  static constexpr std::string_view kName = "load";
  static constexpr Scope kScope = Scope::kGlobal;

  struct Def {
    float over = 1.0F;  ///< Of the budget.
    float fine = 0.7F;  ///< Of the budget.
    int steps = 30;
    int level = 1;

    [[nodiscard]] std::string_view mistake() const {
      return fine < over ? "" : R"("fine" must be below "over")";
    }
  };

  explicit LoadPolicy(const Def& def) : def_(def), latch_(def.steps) {}

  void observe(const Situation& situation) override;
  void advise(const Situation& situation, const PairView& pair, Wish& wish) const override;

 private:
  Def def_;
  Latch latch_;
};

/// "When the number of overlapping groups exceeds a threshold" (report, section 3.4.4): groups that are about
/// to run into each other make many pairs at once, so a coarse level is asked for in all pairs. Looks at the
/// balls around groups.
class OverlapPolicy final : public NamedPolicy<OverlapPolicy> {
 public:
  static constexpr std::string_view kName = "overlap";
  static constexpr Scope kScope = Scope::kGlobal;

  struct Def {
    int groups = 4;   ///< Overlaps of two groups.
    int members = 4;  ///< Smaller groups are not counted.
    int steps = 30;
    int level = 1;

    [[nodiscard]] static std::string_view mistake() { return {}; }
  };

  OverlapPolicy(const Def& def, std::shared_ptr<Grouping> grouping);

  void observe(const Situation& situation) override;
  void advise(const Situation& situation, const PairView& pair, Wish& wish) const override;

 private:
  Def def_;
  Latch latch_;
  std::shared_ptr<Grouping> grouping_;
  std::uint64_t generation_ = 0;
  int overlaps_ = 0;
};

/// How many pairs of groups with at least so many members have balls that overlap.
[[nodiscard]] int countOverlaps(std::span<const Group> groups, int members);

/// Everything at level n, budget or not.
class FinestPolicy final : public NamedPolicy<FinestPolicy> {
 public:
  static constexpr std::string_view kName = "finest";
  static constexpr Scope kScope = Scope::kGlobal;

  struct Def {
    [[nodiscard]] static std::string_view mistake() { return {}; }
  };

  explicit FinestPolicy(const Def& /*def*/) {}

  void advise(const Situation& /*situation*/, const PairView& pair, Wish& wish) const override {
    wish.promise(pair.finest);
  }
};

/// Everything at level 1, as far as it is safe.
class CoarsestPolicy final : public NamedPolicy<CoarsestPolicy> {
 public:
  static constexpr std::string_view kName = "coarsest";
  static constexpr Scope kScope = Scope::kGlobal;

  struct Def {
    [[nodiscard]] static std::string_view mistake() { return {}; }
  };

  explicit CoarsestPolicy(const Def& /*def*/) {}

  void advise(const Situation& /*situation*/, const PairView& /*pair*/, Wish& wish) const override {
    wish.request(1);
  }
};

}  // namespace scatter::lod
