#pragma once

#include <chrono>

namespace scatter {

/// The fixed-rate timing source of a program; cannot be paused or changed (report, section 4.2).
class Clock {
 public:
  Clock() = default;
  Clock(const Clock&) = delete;
  Clock& operator=(const Clock&) = delete;
  virtual ~Clock() = default;

  /// Seconds since the clock was made; never decreases.
  [[nodiscard]] virtual double now() const = 0;

  /// Returns at `time`, or at once if it has passed.
  virtual void sleepUntil(double time) = 0;
};

/// Real time, from the system's steady clock.
class SystemClock final : public Clock {
 public:
  SystemClock();
  [[nodiscard]] double now() const override;
  void sleepUntil(double time) override;

 private:
  std::chrono::steady_clock::time_point start_;
};

/// Moves only when told to, so that whatever runs on a Clock can be tested without waiting.
class ManualClock final : public Clock {
 public:
  [[nodiscard]] double now() const override { return now_; }
  void sleepUntil(double time) override;

  /// `seconds` is not negative.
  void advance(double seconds);

 private:
  double now_ = 0.0;
};

}  // namespace scatter
