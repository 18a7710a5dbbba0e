#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/body_looks.h"
#include "viewer/cutaway.h"
#include "viewer/layout.h"
#include "viewer/viewer.h"
#include "viewer/viewer_state.h"
#include "viewer/window_loop.h"

namespace scatter::viewer {

/// A lab window while it is open.
class Window final : public WindowLoop {
 public:
  [[nodiscard]] static Result<std::unique_ptr<Window>> create(Renderer& renderer, const ViewerDef& def);

  [[nodiscard]] Result<ViewerReport> run();

 private:
  Window(Renderer& renderer, const ViewerDef& def);

  [[nodiscard]] Result<void> openWorlds();
  void checkHands();

  [[nodiscard]] Result<void> perform(const ScriptAction& action) override;
  void take(const InputEvent& event) override;
  void step() override;
  [[nodiscard]] Picture picture() override;
  void showPanels() override;

  [[nodiscard]] Result<void> openScene(const std::string& name);

  void openWanted();
  void takePointer(const InputEvent& event);
  void press(const InputEvent& event);
  void fly();

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
  [[nodiscard]] ViewerReport report() const;

  const ViewerDef& def_;
  BodyLooks looks_;
  std::vector<std::unique_ptr<Pane>> panes_;
  Playback playback_;
  HandTools hands_;
  std::optional<WorldControl> control_;
  Cutaway cutaway_;
  DebugViewSet views_;
  std::optional<ViewerState> state_;

  glm::vec2 pointer_{0.0F};
  std::array<bool, static_cast<std::size_t>(Key::kCount)> keys_{};
  std::array<bool, 3> buttons_{};
  Crowd crowd_;
  double aimed_ = 0.0;  ///< When the camera was, by the clock.
};

}  // namespace scatter::viewer
