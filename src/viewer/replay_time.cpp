#include "viewer/replay_time.h"

#include <algorithm>

namespace scatter::viewer {

void ReplayTime::step() {
  if (!playing_) return;
  if (frame_ != end()) frame_ = backwards_ ? frame_ - 1 : frame_ + 1;
  if (frame_ == end()) playing_ = false;
}

void ReplayTime::setPlaying(bool playing) {
  playing_ = playing;
  if (playing && frame_ == end()) frame_ = backwards_ ? last_ : first_;
}

void ReplayTime::show(std::uint64_t frame) {
  playing_ = false;
  frame_ = std::clamp(frame, first_, last_);
}

void ReplayTime::showNext(int frames) {
  const auto far = static_cast<std::uint64_t>(frames < 0 ? -frames : frames);
  show(frames < 0 ? frame_ - std::min(far, frame_ - first_) : frame_ + std::min(far, last_ - frame_));
}

}  // namespace scatter::viewer
