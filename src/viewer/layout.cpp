#include "viewer/layout.h"

#include <algorithm>
#include <glm/common.hpp>

#include "viewer/panel_scale.h"

namespace scatter::viewer {
namespace {

// Pixels in a window of 1280 x 720, where both sides together take less than a third.
constexpr float kLab = 168.0F;
constexpr float kNumbers = 256.0F;
constexpr float kTime = 88.0F;
constexpr float kTimeFolded = 32.0F;
constexpr float kTitle = 19.0F;       // height of what is left of a folded panel at a side,
constexpr float kTitleWidth = 96.0F;  // and its width
constexpr float kLeastPicture = 160.0F;

constexpr float kInspectorShare = 0.5F;  // of the height at the side, for the inspector

}  // namespace

Layout::Layout(const glm::ivec2& window, std::size_t panes, const OpenPanels* panels)
    : window_(glm::max(window, glm::ivec2(1))), panes_(panes), scale_(panelScale(window)) {
  if (panels == nullptr) return;
  open_ = *panels;
  // In a tiny window the panels lie over the picture.
  const bool hasWidth = window_.x >= scale_ * (kLab + kNumbers + kLeastPicture);
  const bool hasHeight = window_.y >= scale_ * (kTime + kLeastPicture);
  if (open_.lab && hasWidth) left_ = scale_ * kLab;
  if (open_.numbers && hasWidth) right_ = scale_ * kNumbers;
  if (hasHeight) bottom_ = scale_ * (open_.time ? kTime : kTimeFolded);
}

bool Layout::isNarrow(const glm::ivec2& window) {
  return static_cast<float>(window.x) < 3.0F * panelScale(window) * (kLab + kNumbers);
}

Place Layout::lab() const {
  if (!open_.lab) return {{0.0F, 0.0F}, scale_ * glm::vec2(kTitleWidth, kTitle)};
  return {{0.0F, 0.0F}, {scale_ * kLab, sideHeight()}};
}

Place Layout::numbers(bool inspected) const {
  const float width = scale_ * (open_.numbers ? kNumbers : kTitleWidth);
  const float height =
      open_.numbers ? sideHeight() * (inspected ? 1.0F - kInspectorShare : 1.0F) : scale_ * kTitle;
  return {{window_.x - width, 0.0F}, {width, height}};
}

Place Layout::inspector() const {
  const glm::vec2 size(scale_ * kNumbers, kInspectorShare * sideHeight());
  return {{window_.x - size.x, sideHeight() - size.y}, size};
}

Place Layout::time() const {
  const float height = scale_ * (open_.time ? kTime : kTimeFolded);
  return {{0.0F, window_.y - height}, {window_.x, height}};
}

Place Layout::help() const {
  return {{0.0F, 0.0F}, window_};
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

bool Layout::isPicture(const glm::vec2& point) const {
  return point.x >= left_ && point.x < window_.x - right_ && point.y >= 0.0F && point.y < window_.y - bottom_;
}

std::size_t Layout::paneAt(const glm::vec2& point) const {
  const float column = (point.x - left_) / size().x;
  return static_cast<std::size_t>(std::clamp(column, 0.0F, static_cast<float>(panes_) - 0.5F));
}

}  // namespace scatter::viewer
