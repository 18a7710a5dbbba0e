#pragma once

#include <scatter/world/scene.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/camera_rig.h"
#include "viewer/commands.h"
#include "viewer/debug_views.h"
#include "viewer/hand_tools.h"
#include "viewer/layout.h"
#include "viewer/outputs.h"
#include "viewer/pane.h"
#include "viewer/playback.h"
#include "viewer/renderer.h"
#include "viewer/window_commands.h"
#include "viewer/world_control.h"

namespace scatter::viewer {

/// Everything that a window shows and that its panels change. What is referred to outlives it.
struct ViewerState {
  std::vector<std::unique_ptr<Pane>>& panes;
  Playback& playback;
  HandTools& hands;
  WorldControl& control;
  Outputs& outputs;
  CameraRig& camera;
  DebugViewSet& views;
  Commands& commands;
  WindowSwitches& switches;

  OpenPanels open{};
  Shadows shadows = Shadows::kGround;

  std::vector<std::shared_ptr<const SceneInfo>> scenes{};  ///< As they were when the list was opened.
  std::optional<std::string> wantedScene{};                ///< To be opened before the next step.
  std::string hovered{};  ///< The object under the pointer; empty if there is none.

  float aspect = 1.0F;            ///< Of one world's picture, width by height.
  float draggedBudget = 0.0F;     ///< Of the slider, milliseconds, until it is let go.
  double drawMilliseconds = 0.0;  ///< Of the last pictures, smoothed.
  DrawStatistics statistics{};
};

}  // namespace scatter::viewer
