#pragma once

#include <algorithm>

#include "lod/recent_quantile.h"

namespace scatter::lod {

/// A point of every step at which the clock is looked at. Learns what a unit takes before and after it, in
/// what it takes in a step as a whole: that is the same however fast the machine is.
class StepPoint {
 public:
  /// Begins a step, which need not come to the point.
  void begin() { units_ = milliseconds_ = 0.0; }

  /// The step has come to it, has cost so much, and has taken so long, both above 0.
  void pass(double units, double milliseconds) {
    units_ = units;
    milliseconds_ = milliseconds;
  }

  /// After a step that did cost `units` and took `milliseconds`.
  void learn(double units, double milliseconds) {
    if (!(milliseconds_ > 0.0) || !(units_ > 0.0) || units <= units_ || milliseconds <= milliseconds_) return;
    const double perUnit = milliseconds / units;
    before_.add(milliseconds_ / units_ / perUnit);
    after_.add((milliseconds - milliseconds_) / (units - units_) / perUnit);
  }

  /// After pass(): what the step may cost, of `units` that were given for it when a unit was taken to need
  /// `perUnit` milliseconds. What makes a step slow lasts: what is left of it takes as much longer.
  [[nodiscard]] double room(double units, double perUnit) const {
    const double usual = units_ * perUnit * ratio(before_);
    if (!(usual > 0.0)) return units;
    const double slowness = std::max(milliseconds_ / usual, 1.0);
    const double left = std::max(units * perUnit - milliseconds_, 0.0);
    return std::min(units_ + left / (slowness * perUnit * ratio(after_)), units);
  }

 private:
  using Ratios = RecentQuantile<31>;

  [[nodiscard]] static double ratio(const Ratios& ratios) {
    constexpr double kUsual = 0.5;
    const double usual = ratios.at(kUsual);
    return usual > 0.0 ? usual : 1.0;
  }

  double units_ = 0.0;
  double milliseconds_ = 0.0;
  Ratios before_;
  Ratios after_;
};

}  // namespace scatter::lod
