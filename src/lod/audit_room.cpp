#include "lod/audit_room.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

namespace scatter::lod {

namespace {

/// Of a budget, for audits: a little in any step, so that looking does not cost the detail that it serves,
/// and a fifth at most.
constexpr double kLeast = 0.06;
constexpr double kMost = 0.2;

/// Of a budget that is exceeded, where more pairs are overdue than this has room for. Of 0.06, 0.08, 0.1 and
/// 0.14, a tenth is from where a pile whose budget falls to three quarters of its floor hardly overlaps any
/// more, and no more frames exceed it (`scatter run fleet --replay --fidelity`, 7500 units, from frame 1000
/// on 3200).
constexpr double kBacklog = 0.1;

}  // namespace

void AuditRoom::begin(double budget) {
  findFirst();
  budget_ = budget;
  units_ = 0.0;
  audits_ = 0;
  overdue_.clear();
}

void AuditRoom::take(double units) {
  units_ += units;
  ++audits_;
}

float AuditRoom::from(const Load& load) const {
  if (std::isinf(budget_)) return lateness::kDue;
  if (load.isOver) {
    const double most = first_ > lateness::kDue ? kBacklog : kLeast;
    return units_ < most * budget_ ? first_ : lateness::kNever;
  }
  const double share = load.isShort ? kLeast : kLeast + (kMost - kLeast) * load.admission;
  return units_ < share * budget_ ? lateness::kDue : lateness::kLate;
}

// There is room for as many as were made, at what they took. No more may come, or the first of them in the
// order of the pairs would have the room of those that have waited longer; but of many that are alike some
// do.
void AuditRoom::findFirst() {
  first_ = lateness::kDue;
  if (audits_ == 0 || std::isinf(budget_)) return;
  const auto room = static_cast<std::size_t>(kBacklog * budget_ * audits_ / units_);
  if (overdue_.size() <= room) return;
  const auto next = overdue_.begin() + static_cast<std::ptrdiff_t>(room);
  std::nth_element(overdue_.begin(), next, overdue_.end(), std::greater<>());
  const bool areAlike = *std::max_element(overdue_.begin(), next) <= *next;
  first_ = areAlike ? *next : std::nextafter(*next, lateness::kNever);
}

}  // namespace scatter::lod
