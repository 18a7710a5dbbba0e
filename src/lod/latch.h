#pragma once

#include <algorithm>
#include <cstdint>

namespace scatter::lod {

/// Goes on at once and off after a while. The while doubles each time that the latch must go on again soon
/// after: a request that is itself the reason why all is fine is not given up every other moment.
class Latch {
 public:
  /// `steps`: of being fine, after which it goes off.
  explicit Latch(int steps) : base_(steps), wait_(steps) {}

  /// Once a step. In between `isOver` and `isFine` it stays as it is, and is not on its way to go off.
  void update(bool isOver, bool isFine) {
    if (isOn_) {
      fineSteps_ = isFine && !isOver ? fineSteps_ + 1 : 0;
      if (fineSteps_ >= wait_) turnOff();
      return;
    }
    ++offSteps_;
    if (isOver) {
      turnOn();
    } else if (offSteps_ > wait_) {
      isRelapse_ = false;
      wait_ = base_;
    }
  }

  [[nodiscard]] bool isOn() const { return isOn_; }

 private:
  static constexpr std::int64_t kMostDoublings = 16;

  void turnOn() {
    isOn_ = true;
    fineSteps_ = 0;
    if (isRelapse_) wait_ = std::min(2 * wait_, kMostDoublings * base_);
  }

  void turnOff() {
    isOn_ = false;
    isRelapse_ = true;
    offSteps_ = 0;
  }

  std::int64_t base_;
  std::int64_t wait_;
  std::int64_t fineSteps_ = 0;
  std::int64_t offSteps_ = 0;
  bool isOn_ = false;
  bool isRelapse_ = false;  ///< Has only just gone off.
};

}  // namespace scatter::lod
