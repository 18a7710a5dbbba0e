#pragma once

#include <array>
#include <glm/vec2.hpp>

#include "viewer/camera_rig.h"
#include "viewer/input.h"

namespace scatter::viewer {

/// Steers a camera with the pointer where there is nothing to be held: both outer buttons turn, the middle
/// one moves, the wheel zooms.
class CameraPointer {
 public:
  explicit CameraPointer(CameraRig& camera) : camera_(camera) {}  ///< Must outlive it.

  /// Any event of a window so many pixels high; those that are no pointer's do nothing.
  void take(const InputEvent& event, int windowHeight);

 private:
  CameraRig& camera_;
  glm::vec2 pointer_{0.0F};
  std::array<bool, 3> buttons_{};
};

}  // namespace scatter::viewer
