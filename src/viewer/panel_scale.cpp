#include "viewer/panel_scale.h"

#include <algorithm>

namespace scatter::viewer {

std::size_t panelScaleIndex(const glm::ivec2& window) {
  const float grown = std::min(static_cast<float>(window.x) / 1280.0F, static_cast<float>(window.y) / 720.0F);
  std::size_t index = 0;
  while (index + 1 < kPanelScales.size() && kPanelScales.at(index + 1) <= grown) ++index;
  return index;
}

}  // namespace scatter::viewer
