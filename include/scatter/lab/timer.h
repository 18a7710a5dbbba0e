#pragma once

#include <scatter/lab/clock.h>

namespace scatter {

/// Seconds that pass on a Clock while the timer runs (report, section 4.2). It moves only in update(), so
/// that everything in one loop sees the same time. Starts paused at zero; the clock must outlive it.
class Timer {
 public:
  explicit Timer(const Clock& clock);

  void start();   ///< Sets the timer to zero and lets it run.
  void pause();   ///< Takes in the time until now, then stands still.
  void resume();  ///< Runs on from where it stood.
  void reset();   ///< Sets the timer to zero; it stays running or paused.
  void update();  ///< Takes in the clock's time.

  [[nodiscard]] bool running() const { return running_; }

  /// At the last update, since start() or reset().
  [[nodiscard]] double seconds() const { return elapsed_ - origin_; }

  /// Seconds run since the timer was made; reset() leaves it alone, so that sub-timers can follow it.
  [[nodiscard]] double elapsed() const { return elapsed_; }

 private:
  const Clock& clock_;
  double lastClock_;
  double elapsed_ = 0.0;
  double origin_ = 0.0;
  bool running_ = false;
};

/// Follows a Timer at a rate of its own, so that a component can run faster or slower than the program
/// (report, section 4.2). Runs at once; a change of rate or a pause never makes it jump, and a reset of its
/// source leaves it alone. The source must outlive it.
class SubTimer {
 public:
  explicit SubTimer(const Timer& source, double rate = 1.0);

  void pause();
  void resume();
  void reset();   ///< Sets it to zero; it stays running or paused.
  void update();  ///< Takes in the source's time; call after the source's update().

  /// Seconds of this timer per second of its source, not negative; holds from the source's last update on.
  void setRate(double rate);

  [[nodiscard]] double rate() const { return rate_; }
  [[nodiscard]] bool running() const { return running_; }
  [[nodiscard]] double seconds() const { return seconds_; }

 private:
  const Timer& source_;
  double rate_;
  double lastElapsed_;
  double seconds_ = 0.0;
  bool running_ = true;
};

}  // namespace scatter
