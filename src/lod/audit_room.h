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

  /// Begins a step. `budget`: its units; infinite for none. `last`: what the step before took.
  void begin(double budget, double last);

  /// From which lateness on an audit is made now; lateness::kNever for none.
  [[nodiscard]] float from(const Load& load) const;

  /// An audit was made that was so late, of so many units.
  void take(double units, float late);

  /// A pair was not audited that is later than may be; it is going to be so late in the next step.
  void takeOverdue(float next) { late_.push_back(next); }

 private:
  void findFirst();

  double budget_ = std::numeric_limits<double>::infinity();
  double room_ = 0.0;   ///< For audits, if the step exceeds its budget.
  double units_ = 0.0;  ///< Of the audits of this step.
  int audits_ = 0;
  std::vector<float> late_;        ///< Of this step: how late those were that were made, or are going to be.
  float first_ = lateness::kLate;  ///< From how late on there is room in a step that exceeds its budget.
};

}  // namespace scatter::lod
