#pragma once

#include <string>
#include <vector>

#include "viewer/renderer.h"

namespace scatter::viewer {

/// What has happened at a window, on its way to the panels and to the program.
class InputQueue {
 public:
  void add(const InputEvent& event) { events_.push_back(event); }

  /// Releases all keys and buttons that are down, for a window that no longer hears of them.
  void releaseAll();

  /// All events since the last call. Shows them to the panels, whose context is current, and fills in what
  /// they take and which keys are held.
  [[nodiscard]] std::vector<InputEvent> take();

  /// Tells Dear ImGui where the pointer is and which buttons and keys are down. A button that went down and
  /// up again since the last frame is down for one.
  void showToPanels();

 private:
  void note(InputEvent& event);

  static constexpr std::size_t kKeys = static_cast<std::size_t>(Key::kCount);
  static constexpr std::size_t kButtons = 3;

  std::vector<InputEvent> events_;
  bool keysDown_[kKeys]{};
  bool keysSeen_[kKeys]{};  ///< Went down since the last frame.
  bool buttonsDown_[kButtons]{};
  bool buttonsSeen_[kButtons]{};  ///< Went down since the last frame.
  glm::vec2 pointer_{-1.0F};
};

/// Prepares the current Dear ImGui context: keys mapped, no files written, letters of all sizes there. Fails
/// if the Dear ImGui that runs is not the one that this was compiled for.
[[nodiscard]] Result<void> setUpPanels();

/// Begins a frame of Dear ImGui in a window of that size, in pixels, so many seconds after the last one, with
/// letters and spaces as large as the window asks for.
void beginPanels(InputQueue& input, const glm::ivec2& window, float seconds);

/// The seconds that the frame took, for animations of panels, from a clock that nothing else reads.
class FrameClock {
 public:
  [[nodiscard]] float next();

 private:
  double last_ = -1.0;
};

}  // namespace scatter::viewer
