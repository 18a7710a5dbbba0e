#pragma once

#include <cstdint>

namespace scatter::viewer {

/// The time of a recording that is played, forwards or backwards.
class ReplayTime {
 public:
  ReplayTime(std::uint64_t first, std::uint64_t last) : first_(first), last_(last), frame_(first) {}

  [[nodiscard]] std::uint64_t first() const { return first_; }
  [[nodiscard]] std::uint64_t last() const { return last_; }
  [[nodiscard]] std::uint64_t frame() const { return frame_; }
  [[nodiscard]] bool isBackwards() const { return backwards_; }
  [[nodiscard]] bool isPlaying() const { return playing_; }

  /// To be called for each step that is due. At the end it stops.
  void step();

  /// From the end that it would run into at once it goes on at the other one.
  void setPlaying(bool playing);
  void turn() { backwards_ = !backwards_; }

  /// Both stop it. What is beyond the ends is the end.
  void show(std::uint64_t frame);
  void showNext(int frames);

 private:
  [[nodiscard]] std::uint64_t end() const { return backwards_ ? first_ : last_; }

  std::uint64_t first_;
  std::uint64_t last_;
  std::uint64_t frame_;
  bool backwards_ = false;
  bool playing_ = true;
};

}  // namespace scatter::viewer
