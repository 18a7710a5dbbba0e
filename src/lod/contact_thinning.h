#pragma once

#include <functional>

#include "lod/recent_quantile.h"

namespace scatter::lod {

/// How few contacts a solver is shown: of two bodies that have `leastContacts` or more, `mostAlike` of each
/// direction. The others stay where they are, and those that are shown stand for them.
struct ThinningRule {
  int mostAlike = 0;
  int leastContacts = 0;
};

/// Contacts of the bodies that the rule concerns, and those of them that need not be shown.
struct SpareContacts {
  int contacts = 0;
  int spare = 0;
};

/// The first thing that a budget takes: contacts that others stand for, as many as it needs. That is decided
/// when the contacts of a step are known, before they are solved; so it also saves a step that turned out
/// dearer than it was planned. Deterministic.
class ContactThinning {
 public:
  using Find = std::function<SpareContacts(const ThinningRule&)>;

  /// `each`: what a contact that is not shown saves, units.
  explicit ContactThinning(double each) : each_(each) {}

  /// Whether a pair with so many contacts may have some to spare.
  [[nodiscard]] static bool concerns(int contacts);

  /// What so many contacts of such pairs may save: as much as in the step before.
  [[nodiscard]] double expected(int contacts) const;

  /// After the narrowphase of a step that would cost `full` units if all contacts were shown: decides how
  /// many are not. `find` is called only if it is needed.
  void settle(double full, double budget, const Find& find);

  /// Of the last settle(): contacts that are not to be shown, of the spare ones in an order that lasts.
  [[nodiscard]] int hidden() const { return hidden_; }

  /// Of the last settle(), units: what these save, and what all that are spare would.
  [[nodiscard]] double saved() const { return each_ * hidden_; }
  [[nodiscard]] double mostSaved() const { return each_ * spare_.spare; }

 private:
  /// Steps whose needs are met before fewer are hidden. With 12 a tower whose budget comes and goes trembles
  /// as with 20, with 8 more (`tower_bench`); 20 leave 0.01 to 0.03 more of a budget unused where bodies fall
  /// asleep (`scatter bench budget --families sleepers,wheels_box,wheels_mesh,wheels_plane --seeds 1,2,3
  /// --scale 0.5`).
  static constexpr int kPatience = 12;

  void adjustShare(double needed);

  double each_;
  double share_ = 0.0;  ///< Of the spare contacts, those that are not shown.
  int hidden_ = 0;
  RecentQuantile<kPatience> needs_;  ///< Likewise, those that would have done.
  int stepsToTry_ = 0;               ///< Until it is looked again whether there is anything to spare.
  SpareContacts spare_{};
};

}  // namespace scatter::lod
