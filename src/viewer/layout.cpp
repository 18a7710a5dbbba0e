#include "viewer/layout.h"

#include <algorithm>
#include <glm/common.hpp>

namespace scatter::viewer {
namespace {

constexpr float kLeft = 252.0F;
constexpr float kRight = 320.0F;
constexpr float kBottom = 92.0F;
constexpr float kLeastPicture = 240.0F;  // pixels that panels leave

}  // namespace

Layout::Layout(const glm::ivec2& window, std::size_t panes, bool panels)
    : window_(glm::max(window, glm::ivec2(1))), panes_(panes) {
  // In a small window the panels lie over the picture.
  if (!panels || window_.x < kLeft + kRight + kLeastPicture || window_.y < kBottom + kLeastPicture) return;
  left_ = kLeft;
  right_ = kRight;
  bottom_ = kBottom;
}

glm::vec2 Layout::size() const {
  return {(window_.x - left_ - right_) / static_cast<float>(panes_), window_.y - bottom_};
}

glm::vec2 Layout::corner(std::size_t pane) const {
  return {left_ + static_cast<float>(pane) * size().x, 0.0F};
}

Area Layout::area(std::size_t pane) const {
  const glm::vec2 at = corner(pane) / window_;
  const glm::vec2 share = size() / window_;
  return {at.x, at.y, share.x, share.y};
}

std::size_t Layout::paneAt(const glm::vec2& point) const {
  const float column = (point.x - left_) / size().x;
  return static_cast<std::size_t>(std::clamp(column, 0.0F, static_cast<float>(panes_) - 0.5F));
}

}  // namespace scatter::viewer
