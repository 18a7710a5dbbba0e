#pragma once

#include <scatter/lab/clock.h>
#include <scatter/lab/loop.h>
#include <scatter/lab/run_history.h>
#include <scatter/recording/recording.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/camera_pointer.h"
#include "viewer/camera_rig.h"
#include "viewer/commands.h"
#include "viewer/cutaway.h"
#include "viewer/debug_views.h"
#include "viewer/layout.h"
#include "viewer/outputs.h"
#include "viewer/replay.h"
#include "viewer/replay_time.h"
#include "viewer/scene_view.h"
#include "viewer/script_player.h"

namespace scatter::viewer {

/// The window of a recording: no physics, no hands, and time that runs both ways.
class ReplayWindow {
 public:
  [[nodiscard]] static Result<std::unique_ptr<ReplayWindow>> create(Renderer& renderer, const ReplayDef& def);

  [[nodiscard]] Result<ReplayReport> run();

 private:
  ReplayWindow(Renderer& renderer, const ReplayDef& def, std::unique_ptr<RunHistory> history);

  void addCommands();
  void addTime();
  void addViews();
  void addCamera();
  [[nodiscard]] Result<void> perform(const ScriptAction& action);

  void readInput();
  void take(const InputEvent& event);
  void draw();
  void showPanels();
  [[nodiscard]] Layout layout() const;
  [[nodiscard]] Moment moment() const;
  [[nodiscard]] View view();
  [[nodiscard]] std::string label() const;

  Renderer& renderer_;
  ReplayDef def_;
  std::unique_ptr<RunHistory> history_;
  std::unique_ptr<Clock> clock_;
  Loop loop_;
  BodyLooks looks_;
  SceneView scene_;
  ReplayTime time_;
  CameraRig camera_;
  CameraPointer pointer_{camera_};
  Cutaway cutaway_;
  DebugViewSet views_;
  Commands commands_;
  Outputs outputs_;
  ScriptPlayer script_;
  OpenPanels open_{.lab = false, .numbers = false};
  bool panelsShown_;
  bool closing_ = false;

  std::string error_;
  double aimed_ = 0.0;  ///< When the camera was, by the clock.
};

}  // namespace scatter::viewer
