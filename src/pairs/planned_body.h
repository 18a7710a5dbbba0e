#pragma once

#include <cstdint>

namespace scatter::pairs {

/// One of the two bodies of a planned pair: what the planner asks of it. The engine's.
class PlannedBody {
 public:
  PlannedBody() = default;
  PlannedBody(const PlannedBody&) = delete;
  PlannedBody& operator=(const PlannedBody&) = delete;
  virtual ~PlannedBody() = default;

  /// The engine's own object, which tells bodies apart.
  [[nodiscard]] virtual const void* object() const = 0;

  /// Its place in the table of bodies that a plan is made with.
  [[nodiscard]] virtual std::uint32_t index() const = 0;

  /// The level that the program asks for in all its pairs; 0: none.
  [[nodiscard]] virtual int askedLevel() const = 0;

  /// Whether contacts act on it. They do not on a sensor.
  [[nodiscard]] virtual bool hasResponse() const = 0;

  /// Whether contacts of it can be told to leave an overlap as it is. Springs, in their place, cannot.
  [[nodiscard]] virtual bool easesContacts() const = 0;

  /// Whether contacts can move it, and wake it with others.
  [[nodiscard]] virtual bool isMovable() const = 0;

 private:
  friend class Planner;
  static constexpr int kNowhere = -1;

  int coarser_ = kNowhere;  ///< Inside Planner::findCoarser(): its place in what is found.
  int wakefulStep_ = -1;    ///< The last step in which a pair of its was not to fall asleep for a budget.
};

}  // namespace scatter::pairs
