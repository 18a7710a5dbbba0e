#pragma once

#include <cstddef>
#include <glm/vec2.hpp>

#include "viewer/renderer.h"

namespace scatter::viewer {

/// Where things are in a window, pixels: panels at the sides and at the bottom, the worlds side by side
/// between them.
class Layout {
 public:
  Layout(const glm::ivec2& window, std::size_t panes, bool panels);

  [[nodiscard]] glm::vec2 window() const { return window_; }
  [[nodiscard]] float sideHeight() const { return window_.y - bottom_; }  ///< Of the panels at the sides.
  [[nodiscard]] float leftWidth() const { return left_; }
  [[nodiscard]] float rightWidth() const { return right_; }
  [[nodiscard]] float bottomHeight() const { return bottom_; }

  /// Of one world: its top left corner and its size.
  [[nodiscard]] glm::vec2 corner(std::size_t pane) const;
  [[nodiscard]] glm::vec2 size() const;
  [[nodiscard]] Area area(std::size_t pane) const;

  /// The world at a point of the window; beside the pictures, the nearest.
  [[nodiscard]] std::size_t paneAt(const glm::vec2& point) const;

 private:
  glm::vec2 window_;
  std::size_t panes_;
  float left_ = 0.0F;
  float right_ = 0.0F;
  float bottom_ = 0.0F;
};

}  // namespace scatter::viewer
