#pragma once

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>

namespace scatter::viewer {

/// How much larger panels and their letters can be than in a window of 1280 x 720, from small to large.
inline constexpr std::array kPanelScales{1.0F, 1.25F, 1.5F, 1.75F, 2.0F, 2.5F, 3.0F, 4.0F};

/// Which of them a window of that size in pixels has: the largest that neither side of it is too small for.
[[nodiscard]] std::size_t panelScaleIndex(const glm::ivec2& window);

[[nodiscard]] inline float panelScale(const glm::ivec2& window) {
  return kPanelScales.at(panelScaleIndex(window));
}

}  // namespace scatter::viewer
