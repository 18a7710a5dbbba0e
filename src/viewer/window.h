#pragma once

#include <scatter/lab/clock.h>
#include <scatter/lab/loop.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/body_looks.h"
#include "viewer/cutaway.h"
#include "viewer/layout.h"
#include "viewer/script_player.h"
#include "viewer/viewer.h"
#include "viewer/viewer_state.h"

namespace scatter::viewer {

/// A lab window while it is open.
class Window {
 public:
  [[nodiscard]] static Result<std::unique_ptr<Window>> create(Renderer& renderer, const ViewerDef& def);

  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;
  ~Window() = default;

  [[nodiscard]] Result<ViewerReport> run();

 private:
  Window(Renderer& renderer, const ViewerDef& def);

  [[nodiscard]] Result<void> openWorlds();
  void addTasks();
  void checkHands();

  [[nodiscard]] Result<void> perform(const ScriptAction& action);
  [[nodiscard]] Result<void> openScene(const std::string& name);
  void inject(InputEvent event);

  void openWanted();
  void readInput();
  void take(const InputEvent& event);
  void takePointer(const InputEvent& event);
  void press(const InputEvent& event);
  void fly();
  void draw();

  /// The pane under a point of the window, and the ray through the point.
  struct Pointed {
    std::size_t pane = 0;
    Ray ray;
  };
  [[nodiscard]] Pointed pointedAt(const glm::vec2& position) const;
  [[nodiscard]] std::string hoveredName() const;
  [[nodiscard]] std::optional<glm::vec2> positionOf(const std::string& object) const;
  [[nodiscard]] Layout layout() const;
  [[nodiscard]] View emptyView(std::size_t pane) const;
  /// What this frame's views and panels need to know of the physics.
  [[nodiscard]] ObservationParts parts() const;
  /// What is shown of each world.
  [[nodiscard]] std::vector<Moment> moments();
  /// Lets the camera look at what happens, and cuts away what is between.
  void aim(const std::vector<Moment>& moments);
  [[nodiscard]] Picture picture();
  [[nodiscard]] ViewerReport report() const;

  Renderer& renderer_;
  ViewerDef def_;
  std::unique_ptr<Clock> clock_;  ///< That of the loops, or the system's.
  Loop loop_;
  BodyLooks looks_;
  std::vector<std::unique_ptr<Pane>> panes_;
  Playback playback_;
  HandTools hands_;
  std::optional<WorldControl> control_;
  Outputs outputs_;
  CameraRig camera_;
  Cutaway cutaway_;
  DebugViewSet views_;
  Commands commands_;
  ScriptPlayer script_;
  std::optional<ViewerState> state_;

  std::string error_;
  glm::vec2 pointer_{0.0F};
  std::array<bool, static_cast<std::size_t>(Key::kCount)> keys_{};
  std::array<bool, 3> buttons_{};
  Crowd crowd_;
  double aimed_ = 0.0;  ///< When the camera was, by the clock.
  std::vector<double> drawMs_;
  std::vector<double> loopMs_;
};

}  // namespace scatter::viewer
