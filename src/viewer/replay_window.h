#pragma once

#include <scatter/lab/run_history.h>
#include <scatter/recording/recording.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/camera_pointer.h"
#include "viewer/cutaway.h"
#include "viewer/debug_views.h"
#include "viewer/layout.h"
#include "viewer/recorded_curves.h"
#include "viewer/replay.h"
#include "viewer/replay_time.h"
#include "viewer/scene_view.h"
#include "viewer/window_loop.h"

namespace scatter::viewer {

/// The window of a recording: no physics, no hands that move anything, and time that runs both ways.
class ReplayWindow final : public WindowLoop {
 public:
  [[nodiscard]] static Result<std::unique_ptr<ReplayWindow>> create(Renderer& renderer, const ReplayDef& def);

  [[nodiscard]] Result<ReplayReport> run();

 private:
  ReplayWindow(Renderer& renderer, const ReplayDef& def, std::unique_ptr<RunHistory> history);

  void addTime();
  void addViews();
  void addCamera();

  [[nodiscard]] Result<void> perform(const ScriptAction& action) override;
  void take(const InputEvent& event) override;
  void step() override { time_.step(); }
  [[nodiscard]] Picture picture() override;
  void showPanels() override;

  void addPicking();
  void takeClick(const InputEvent& event);
  [[nodiscard]] std::optional<BodyId> bodyAt(const glm::vec2& pixel);
  [[nodiscard]] std::optional<glm::vec2> pixelOfBody(const std::string& name) const;
  void addContacts(View& view) const;
  void showTime(const Layout& place);

  [[nodiscard]] View emptyView() const;
  [[nodiscard]] Layout layout() const;
  [[nodiscard]] Moment moment() const;
  [[nodiscard]] std::string label() const;

  std::unique_ptr<RunHistory> history_;
  BodyLooks looks_;
  SceneView scene_;
  ReplayTime time_;
  CameraPointer pointer_{camera_};
  Cutaway cutaway_;
  DebugViewSet views_;
  Shadows shadows_;
  OpenPanels open_{.lab = false};
  RecordedCurves curves_;
  std::string channel_{};  ///< That is plotted beside the usual ones.
  std::optional<BodyId> picked_{};
  std::string hovered_{};  ///< The name of what is under the pointer.
  glm::vec2 pointed_{0.0F};
  std::optional<BodyId> pressedBody_{};
  std::optional<glm::vec2> pressed_{};  ///< Where the left button went down, until it is no click any more.
  double aimed_ = 0.0;                  ///< When the camera was, by the clock.
};

}  // namespace scatter::viewer
