#include "viewer/camera_pointer.h"

#include <algorithm>

namespace scatter::viewer {

void CameraPointer::take(const InputEvent& event, int windowHeight) {
  using Kind = InputEvent::Kind;
  if (event.kind == Kind::kMouseUp) buttons_[static_cast<std::size_t>(event.button)] = false;
  if (event.kind == Kind::kMouseDown && !event.takenByPanels) {
    buttons_[static_cast<std::size_t>(event.button)] = true;
  }
  if (event.kind == Kind::kWheel && !event.takenByPanels) camera_.zoomByNotches(event.wheel);
  if (event.kind != Kind::kMouseMove) return;
  const glm::vec2 moved = (event.position - pointer_) / static_cast<float>(std::max(1, windowHeight));
  pointer_ = event.position;
  if (buttons_[0] || buttons_[1]) camera_.turnByDrag(moved);
  if (buttons_[2]) camera_.pan(-moved.x, moved.y);
}

}  // namespace scatter::viewer
