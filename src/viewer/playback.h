#pragma once

#include <scatter/lab/loop.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "viewer/pane.h"

namespace scatter::viewer {

/// The time of a window: all its worlds have one. Shows the newest frame, or an earlier one that the
/// histories keep; played from there, the recording runs until it reaches the newest, and the worlds run on.
class Playback {
 public:
  /// Both must outlive it.
  Playback(Loop& loop, std::vector<std::unique_ptr<Pane>>& panes) : loop_(loop), panes_(panes) {}

  /// To be called for each physics step that is due.
  void step();

  [[nodiscard]] bool paused() const { return loop_.physicsPaused(); }
  void setPaused(bool paused);
  void stepForward();  ///< Pauses and makes one step, or shows the next frame of the past.
  void stepBack();     ///< Pauses and shows the frame before.

  [[nodiscard]] double rate() const { return loop_.physicsRate(); }
  void setRate(double rate) { loop_.setPhysicsRate(rate); }

  /// The frame of the past that is shown; nothing if it is the newest.
  [[nodiscard]] std::optional<std::uint64_t> past() const { return past_; }
  void show(std::uint64_t frame);  ///< One from oldest() to newest(); pauses.
  void showNewest() { past_.reset(); }

  /// Frames that all histories keep.
  [[nodiscard]] std::uint64_t oldest() const;
  [[nodiscard]] std::uint64_t newest() const;
  [[nodiscard]] std::uint64_t shown() const { return past_.value_or(newest()); }

  /// Starts all scenes again, from their first frame.
  [[nodiscard]] Result<void> restart();

  /// Opens another scene in all worlds, which run. Fails, with the scenes as they were or started again, if
  /// it cannot be opened in one.
  [[nodiscard]] Result<void> open(const std::string& scene);

  /// How far the bodies are on their way to the newest frame, for slow motion.
  [[nodiscard]] float fraction() const;

 private:
  Loop& loop_;
  std::vector<std::unique_ptr<Pane>>& panes_;
  std::optional<std::uint64_t> past_;
  bool held_ = false;  ///< What is shown stays, though a step was due when it was asked for.
};

}  // namespace scatter::viewer
