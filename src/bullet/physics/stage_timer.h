#pragma once

#include <LinearMath/btQuickprof.h>
#include <scatter/world/step_report.h>

#include <array>
#include <chrono>
#include <cstdint>

namespace scatter {

/// Divides the time of a step among its stages, from Bullet's profile zones. Every moment counts for the
/// innermost stage only.
///
/// Bullet enters tens of thousands of zones a step, most of them inside the narrowphase. These cost a
/// counter; the others a look-up of the name's address; only those that begin or end a stage read the
/// clock.
class BulletStageTimer {
 public:
  BulletStageTimer() = default;
  BulletStageTimer(const BulletStageTimer&) = delete;
  BulletStageTimer& operator=(const BulletStageTimer&) = delete;

  /// While it lives, `timer` follows this thread's zones through Bullet's global hooks, which it puts back
  /// afterwards.
  class Running {
   public:
    explicit Running(BulletStageTimer& timer);
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;
    ~Running();

   private:
    BulletStageTimer& timer_;
    btEnterProfileZoneFunc* enterBefore_;
    btLeaveProfileZoneFunc* leaveBefore_;
  };

  /// While it lives, time counts for `stage`, if the timer is running.
  class Scope {
   public:
    Scope(BulletStageTimer& timer, Stage stage);
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;
    ~Scope();

   private:
    BulletStageTimer& timer_;
  };

  [[nodiscard]] bool isRunning() const { return isRunning_; }

  /// Milliseconds of the last run.
  [[nodiscard]] StageTimes times() const;

 private:
  using Clock = std::chrono::steady_clock;

  /// What a zone's name means.
  struct Zone {
    static constexpr std::uint8_t kNoStage = kStageCount;
    std::uint8_t stage = kNoStage;
    bool closed = false;  ///< No zone inside it begins a stage.
  };

  /// A stage that was interrupted by one inside it.
  struct Interrupted {
    Zone zone;
    std::uint32_t depth = 0;  ///< Of the zone that interrupted it.
  };

  static void enterHook(const char* name);
  static void leaveHook();

  static Zone classify(const char* name);
  Zone lookUp(const char* name);
  void enter(const char* name);
  void leave();
  void begin(Zone zone);
  void countElapsed();

  static constexpr std::size_t kSlots = 256;
  static constexpr std::size_t kMaxNesting = 16;

  struct Slot {
    const char* name = nullptr;
    Zone zone;
  };
  std::array<Slot, kSlots> slots_;

  bool isRunning_ = false;
  Zone current_;
  std::uint32_t depth_ = 0;
  std::size_t nesting_ = 0;
  std::array<Interrupted, kMaxNesting> interrupted_;
  Clock::time_point since_;
  std::array<Clock::duration, kStageCount + 1> elapsed_{};
};

}  // namespace scatter
