#include "viewer/playback.h"

#include <algorithm>

namespace scatter::viewer {

void Playback::step() {
  if (past_) {
    if (held_) return;
    if (++*past_ >= newest()) past_.reset();
    return;
  }
  for (const auto& pane : panes_) {
    if (!pane->experiment().stopped().empty()) continue;
    // What is wrong stays in stopped(), where the panels find it.
    if (!pane->experiment().step()) setPaused(true);
  }
}

void Playback::setPaused(bool paused) {
  held_ = false;
  if (paused) {
    loop_.pausePhysics();
  } else {
    loop_.resumePhysics();
  }
}

void Playback::stepForward() {
  held_ = false;
  loop_.singleStep();
}

void Playback::stepBack() {
  if (shown() > oldest()) show(shown() - 1);
}

void Playback::show(std::uint64_t frame) {
  setPaused(true);
  held_ = true;
  past_ = std::clamp(frame, oldest(), newest());
  if (*past_ == newest()) past_.reset();
}

std::uint64_t Playback::oldest() const {
  std::uint64_t oldest = 0;
  for (const auto& pane : panes_) oldest = std::max(oldest, pane->experiment().history().oldest());
  return std::min(oldest, newest());
}

std::uint64_t Playback::newest() const {
  std::uint64_t newest = 0;
  for (const auto& pane : panes_) newest = std::max(newest, pane->experiment().history().newest());
  return newest;
}

Result<void> Playback::restart() {
  past_.reset();
  for (const auto& pane : panes_) {
    if (auto started = pane->experiment().restart(pane->experiment().options().hands); !started)
      return started;
  }
  return {};
}

Result<void> Playback::open(const std::string& scene) {
  const std::string before = panes_.front()->experiment().options().scene;
  for (std::size_t i = 0; i < panes_.size(); ++i) {
    auto opened = panes_[i]->open(scene);
    if (opened) continue;
    // What could be opened once can be opened again, but for files that have changed meanwhile.
    for (std::size_t k = 0; k < i; ++k) static_cast<void>(panes_[k]->open(before));
    return opened;
  }
  past_.reset();
  setPaused(false);
  return {};
}

float Playback::fraction() const {
  // At full speed the newest frame is shown, so that nothing lags behind.
  if (paused() || rate() >= 1.0) return 1.0F;
  return static_cast<float>(std::clamp(loop_.stepFraction(), 0.0, 1.0));
}

}  // namespace scatter::viewer
