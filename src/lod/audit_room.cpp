#include "lod/audit_room.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

namespace scatter::lod {

namespace {

/// Of a budget, for audits: a little in any step, so that looking does not cost the detail that it serves,
/// and a fifth at most. Of what a step takes that exceeds its budget, the same fifth: without audits bodies
/// sink into each other, and their coarse shapes collide, which take two thirds of an audit. With a tenth of
/// the budget, this, and no bound, 428, 298 and 291 of 600 steps of `fleet` are over 1.02 of 2700 units, and
/// ships that begin in each other take 1.21, 1.11 and 1.17 of the units of their finest shapes with 300 (both
/// in docs/budget-figures.md); but with no bound bodies of many parts took 2.4 times what they do without a
/// budget of a sixteenth of that.
constexpr double kLeast = 0.06;
constexpr double kMost = 0.2;

}  // namespace

void AuditRoom::begin(double budget, double last) {
  if (!std::isinf(budget_)) findFirst();
  budget_ = budget;
  room_ = kMost * std::max(budget, last);
  units_ = 0.0;
  audits_ = 0;
  late_.clear();
}

void AuditRoom::take(double units, float late) {
  units_ += units;
  ++audits_;
  if (late >= lateness::kLate) late_.push_back(late);
}

float AuditRoom::from(const Load& load) const {
  if (std::isinf(budget_)) return lateness::kDue;
  if (load.isOver) return units_ < room_ ? first_ : lateness::kNever;
  const double share = load.isShort ? kLeast : kLeast + (kMost - kLeast) * load.admission;
  return units_ < share * budget_ ? lateness::kDue : lateness::kLate;
}

// Of those that were late, made or not, there is room for as many as were made, at what they took. No more
// may come, or the first of them in the order of the pairs would have the room of those that have waited
// longer; but of many that are alike some do.
void AuditRoom::findFirst() {
  first_ = lateness::kLate;
  if (audits_ == 0) return;
  const auto room = static_cast<std::size_t>(room_ * audits_ / units_);
  if (late_.size() <= room) return;
  const auto next = late_.begin() + static_cast<std::ptrdiff_t>(room);
  std::nth_element(late_.begin(), next, late_.end(), std::greater<>());
  const bool areAlike = *std::max_element(late_.begin(), next) <= *next;
  first_ = areAlike ? *next : std::nextafter(*next, lateness::kNever);
}

}  // namespace scatter::lod
