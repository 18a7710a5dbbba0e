#pragma once

#include <scatter/lab/clock.h>
#include <scatter/lab/loop.h>

#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/camera_rig.h"
#include "viewer/commands.h"
#include "viewer/outputs.h"
#include "viewer/renderer.h"
#include "viewer/script_player.h"
#include "viewer/window_commands.h"

namespace scatter::viewer {

/// What all windows are: a camera, commands, what they write, and loops of the same order: the script's next
/// lines and the user's inputs, then the steps that are due, then a picture with panels over it.
class WindowLoop {
 public:
  WindowLoop(const WindowLoop&) = delete;
  WindowLoop& operator=(const WindowLoop&) = delete;
  virtual ~WindowLoop() = default;

 protected:
  /// A def of any window. The renderer and the def must outlive it.
  template <class Def>
  WindowLoop(Renderer& renderer, const Def& def)
      : WindowLoop(renderer, def.script, def.loops, def.out, def.panels) {}

  /// Until the window is closed. Fails with what has ended it, or with what could not be written.
  [[nodiscard]] Result<void> runLoops();

  /// Ends the loops; with an error if there is one.
  void close(std::string error = {});

  /// Says in the window's title what is shown.
  void setTitle(const std::string& shown) { renderer_.setTitle("Scatter: " + shown); }

  /// What a script's hand does: buttons and the wheel are where its pointer is, and a key that goes down
  /// comes up.
  void inject(InputEvent event);

  /// An action of the script that is no command, picture or look.
  [[nodiscard]] virtual Result<void> perform(const ScriptAction& action) = 0;

  /// Any input, when the command that a key stands for is done.
  virtual void take(const InputEvent& event) = 0;

  /// For each step that is due.
  virtual void step() = 0;

  [[nodiscard]] virtual Picture picture() = 0;
  virtual void showPanels() = 0;

  Renderer& renderer_;
  const std::unique_ptr<Clock> clock_;  ///< That of the loops, or the system's.
  Loop loop_;
  CameraRig camera_;
  Commands commands_;
  Outputs outputs_;
  ScriptPlayer script_;
  WindowSwitches switches_;
  std::vector<double> drawMs_;  ///< Of every loop, as the next.
  std::vector<double> loopMs_;

 private:
  WindowLoop(Renderer& renderer, const std::optional<ViewScript>& script, std::uint64_t loops,
             const std::filesystem::path& out, bool panels);

  void playScript();
  void readInput();
  void draw();

  std::uint64_t loops_ = 0;  ///< Until it is closed.
  glm::vec2 scriptPointer_{0.0F};
  std::string error_;
};

}  // namespace scatter::viewer
