#pragma once

#include <scatter/lab/clock.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "viewer/camera_rig.h"
#include "viewer/commands.h"
#include "viewer/outputs.h"
#include "viewer/view_script.h"

namespace scatter::viewer {

/// Does what a script says, loop by loop. All that it is given must outlive it.
class ScriptPlayer {
 public:
  /// Does what only the window itself can: inputs, and pointing at objects.
  using Other = std::function<Result<void>(const ScriptAction&)>;

  ScriptPlayer(const std::optional<ViewScript>& script, const Commands& commands, CameraRig& camera,
               Outputs& outputs)
      : script_(script), commands_(commands), camera_(camera), outputs_(outputs) {}

  /// Fails on a name that is no command's, and on one that is set and no switch's.
  [[nodiscard]] Result<void> check() const;

  /// All up to a loop that has not been done yet; after check(). Fails as `other` does.
  [[nodiscard]] Result<void> play(std::uint64_t loop, const Other& other);

 private:
  [[nodiscard]] Result<void> perform(const ScriptAction& action, const Other& other);

  const std::optional<ViewScript>& script_;
  const Commands& commands_;
  CameraRig& camera_;
  Outputs& outputs_;
  std::size_t next_ = 0;
};

/// Of a window: its loops' own time if it does a script or so many loops (0: until it is closed), else the
/// system's.
[[nodiscard]] std::unique_ptr<Clock> makeClock(const std::optional<ViewScript>& script, std::uint64_t loops);

}  // namespace scatter::viewer
