#pragma once

#include <limits>
#include <vector>

namespace scatter::lod {

/// How late an audit of a pair on credit is: 0 when it is due, 1 when it has been put off as long as may be.
namespace lateness {
inline constexpr float kDue = 0.0F;
inline constexpr float kLate = 1.0F;
inline constexpr float kNever = std::numeric_limits<float>::max();
}  // namespace lateness

/// Which audits of pairs on credit a step has room for. A pair that nobody looks at sinks into its neighbour,
/// so that a budget that is not enough must not starve one: those that have waited longest come first.
class AuditRoom {
 public:
  /// What the step under way has left.
  struct Load {
    bool isShort = false;    ///< It is about to exceed its budget.
    bool isOver = false;     ///< It comes to more than its budget.
    double admission = 1.0;  ///< From 0 to 1: the share of the pairs that are apart that may have their wish.
  };

  /// Begins a step. `budget`: its units; infinite for none.
  void begin(double budget);

  /// From which lateness on an audit is made now; lateness::kNever for none.
  [[nodiscard]] float from(const Load& load) const;

  /// An audit was made, of so many units.
  void take(double units);

  /// A pair was not audited that is later than may be; it is going to be so late in the next step.
  void takeOverdue(float next) { overdue_.push_back(next); }

 private:
  void findFirst();

  double budget_ = std::numeric_limits<double>::infinity();
  double units_ = 0.0;  ///< Of the audits of this step.
  int audits_ = 0;
  std::vector<float> overdue_;  ///< How late those pairs are going to be.
  float first_ =
      lateness::kDue;  ///< Over a budget: from how late on there is room, of those that were overdue.
};

}  // namespace scatter::lod
