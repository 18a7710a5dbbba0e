#pragma once

#include <cstddef>
#include <glm/vec2.hpp>

#include "viewer/renderer.h"

namespace scatter::viewer {

/// Which panels are unfolded. Of those at the sides a title is left when they are folded, of the one at the
/// bottom a line.
struct OpenPanels {
  bool lab = true;
  bool numbers = true;
  bool time = true;
};

/// A rectangle of the window, pixels from the top left.
struct Place {
  glm::vec2 corner{0.0F};
  glm::vec2 size{0.0F};
};

/// Where things are in a window: panels at the sides and at the bottom, which grow with it and do not
/// overlap, and the worlds side by side between them.
class Layout {
 public:
  /// `panels`: those that are unfolded; null if none are shown at all.
  Layout(const glm::ivec2& window, std::size_t panes, const OpenPanels* panels);

  /// Whether a window is so narrow that panels at both sides would leave less than two thirds of it.
  [[nodiscard]] static bool isNarrow(const glm::ivec2& window);

  [[nodiscard]] glm::vec2 window() const { return window_; }
  [[nodiscard]] float scale() const { return scale_; }  ///< Of letters and of all that goes with them.

  /// Of the panels; what is folded has the size of what is left of it.
  /// @{
  [[nodiscard]] Place lab() const;
  [[nodiscard]] Place numbers(bool inspected) const;  ///< Above the inspector, if something is picked.
  [[nodiscard]] Place inspector() const;
  [[nodiscard]] Place time() const;
  [[nodiscard]] Place help() const;  ///< Over everything.
  /// @}

  /// Of one world's picture.
  [[nodiscard]] glm::vec2 corner(std::size_t pane) const;
  [[nodiscard]] glm::vec2 size() const;
  [[nodiscard]] Area area(std::size_t pane) const;
  [[nodiscard]] float aspect() const { return size().x / size().y; }

  /// Whether a point of the window is one of the pictures', and no panel's at a side.
  [[nodiscard]] bool isPicture(const glm::vec2& point) const;

  /// The world at a point of the window; beside the pictures, the nearest.
  [[nodiscard]] std::size_t paneAt(const glm::vec2& point) const;

 private:
  [[nodiscard]] float sideHeight() const { return window_.y - bottom_; }

  glm::vec2 window_;
  std::size_t panes_;
  OpenPanels open_;
  float scale_;
  float left_ = 0.0F;
  float right_ = 0.0F;
  float bottom_ = 0.0F;
};

}  // namespace scatter::viewer
