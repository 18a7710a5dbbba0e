#pragma once

#include <scatter/lab/clock.h>
#include <scatter/lab/timer.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace scatter {

/// What a loop does after its timers are updated, in this order (report, Figure 4.2).
enum class LoopTask : std::uint8_t {
  kInput,
  kPhysics,  ///< Called once for each fixed step that is due: not at all, once, or several times a loop.
  kProfiling,
  kDebug,
  kRenderer,
  kFrameData,
};
inline constexpr std::size_t kLoopTaskCount = 6;

struct LoopDef {
  double frequency = 60.0;        ///< Loops per second.
  double fixedStep = 1.0 / 60.0;  ///< Seconds of one physics step.
  int maxSteps = 8;               ///< Physics steps per loop at most; what is due beyond is dropped.
};

/// What a loop has done since it was made.
struct LoopReport {
  std::uint64_t loops = 0;
  std::uint64_t steps = 0;
  std::uint64_t lateLoops = 0;         ///< Loops that ended more than one period after their time.
  std::uint64_t loopsWithDropped = 0;  ///< Loops whose bound on catch-up steps was reached.
  double droppedSeconds = 0.0;         ///< Physics time that was never stepped.
};

/// A single-thread uncoupled loop, synchronised to a fixed frequency (report, section 4.2): physics runs in
/// fixed steps from its own sub-timer, everything else once a loop. Steps that cannot be made up for within
/// `maxSteps` are dropped and counted, so that an overload slows the simulation down and never feeds itself.
class Loop {
 public:
  static constexpr double kMinRate = 0.05;
  static constexpr double kMaxRate = 4.0;

  /// The clock must outlive the loop.
  explicit Loop(Clock& clock, LoopDef def = {});

  /// Tasks of one kind run in the order in which they were added.
  void add(LoopTask kind, std::function<void()> task);

  /// Loops until stop().
  void run();

  /// One loop: timers, tasks, then sleep until the next is due.
  void runOnce();

  /// Ends run() after the loop that is under way, whose further catch-up steps are left out. May be called
  /// from any thread and from a signal handler.
  void stop() { stopRequested_.store(true, std::memory_order_relaxed); }
  [[nodiscard]] bool stopRequested() const { return stopRequested_.load(std::memory_order_relaxed); }

  void pausePhysics() { physicsTimer_.pause(); }
  void resumePhysics() { physicsTimer_.resume(); }
  [[nodiscard]] bool physicsPaused() const { return !physicsTimer_.running(); }

  /// Clamped to [kMinRate, kMaxRate].
  void setPhysicsRate(double rate);
  [[nodiscard]] double physicsRate() const { return physicsTimer_.rate(); }

  /// Pauses the physics and makes one step in the next loop.
  void singleStep();

  [[nodiscard]] Timer& timer() { return timer_; }
  [[nodiscard]] SubTimer& renderTimer() { return renderTimer_; }
  [[nodiscard]] const SubTimer& physicsTimer() const { return physicsTimer_; }

  /// How far the physics timer is past the last fixed step, 0 to 1: for interpolated drawing.
  [[nodiscard]] double stepFraction() const { return accumulated_ / def_.fixedStep; }

  [[nodiscard]] const LoopDef& def() const { return def_; }
  [[nodiscard]] const LoopReport& report() const { return report_; }

 private:
  void updateTimers();
  void runTasks(LoopTask kind);
  void runPhysics();
  void synchronise();

  Clock& clock_;
  LoopDef def_;
  Timer timer_;
  SubTimer physicsTimer_;
  SubTimer renderTimer_;
  std::array<std::vector<std::function<void()>>, kLoopTaskCount> tasks_;
  std::atomic<bool> stopRequested_ = false;
  LoopReport report_;
  double accumulated_ = 0.0;
  double lastPhysics_ = 0.0;
  double nextLoop_ = 0.0;
  int singleSteps_ = 0;
};

}  // namespace scatter
