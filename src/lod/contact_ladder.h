#pragma once

#include <functional>

namespace scatter::lod {

/// How few contacts a solver is shown: of two bodies that have `leastContacts` or more, `mostAlike` of each
/// direction. The others stay where they are, and those that are shown stand for them.
struct ContactRung {
  int mostAlike = 0;
  int leastContacts = 0;
};

/// Contacts of the bodies that a rung concerns, and those of them that are not shown.
struct SpareContacts {
  int contacts = 0;
  int hidden = 0;
};

/// The first rungs of the ladder of what a budget takes: contacts that others stand for. They are decided on
/// when the contacts of a step are known, before they are solved; so they also save a step that turned out
/// dearer than it was planned. Deterministic.
class ContactLadder {
 public:
  using Find = std::function<SpareContacts(const ContactRung&)>;

  /// `each`: what a contact that is not shown saves, units.
  explicit ContactLadder(double each) : each_(each) {}

  /// Whether the rung concerns a pair with so many contacts, or the first one would.
  [[nodiscard]] bool concerns(int contacts) const;

  /// What so many contacts of pairs that it concerns are taken to save, as long as the rung stays.
  [[nodiscard]] double expected(int contacts) const;

  /// After the narrowphase: takes the rung that a step needs that would cost `full` units if all contacts
  /// were shown, and returns what that saves. `find` finds what there is to spare at a rung, and is called
  /// last with the one that is taken, unless that is none.
  double settle(double full, double budget, const Find& find);

  /// 0: all contacts are shown.
  [[nodiscard]] int rung() const { return rung_; }
  [[nodiscard]] int hidden() const { return rung_ > 0 ? spare_.hidden : 0; }

 private:
  [[nodiscard]] double take(int rung, const Find& find);

  double each_;
  int rung_ = 0;
  int looseSteps_ = 0;  ///< For so many steps a lower rung may have been enough.
  int stepsToTry_ = 0;  ///< Until it is looked again whether there is anything to spare.
  SpareContacts spare_{};
};

}  // namespace scatter::lod
