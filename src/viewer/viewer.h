#pragma once

#include <scatter/lab/run.h>
#include <scatter/result.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/renderer.h"
#include "viewer/view_script.h"

namespace scatter::viewer {

struct ViewerDef {
  /// One world, or two side by side, with one clock and one camera.
  std::vector<RunOptions> worlds{};

  /// Pictures, recordings and runs go here.
  std::filesystem::path out = "out/view";

  /// The window closes after so many loops; 0: when the user closes it.
  std::uint64_t loops = 0;

  /// What is done in the user's place. With a script, or a number of loops, time is that of the loops, one
  /// step of physics each at a rate of 1, however long they take, so that the same script does the same;
  /// without, it is the clock's.
  std::optional<ViewScript> script{};

  std::vector<std::string> views{"marks"};  ///< Debug views that are on from the start.
  bool panels = true;                       ///< Shown from the start.
};

/// What a window has seen.
struct ViewerReport {
  std::uint64_t loops = 0;
  std::vector<std::uint64_t> frames{};       ///< Physics frames of each world.
  std::vector<std::uint64_t> stateHashes{};  ///< After the last frame of each.
  std::vector<std::size_t> objects{};        ///< In each at the end.
  std::vector<LevelEventCounts> levelEvents{};
  double medianDrawMs = 0.0;        ///< Of drawing, wall time.
  double medianLoopMs = 0.0;        ///< Of a whole loop without its wait, wall time.
  std::uint64_t historyBytes = 0;   ///< Of disk, of the fullest history.
  std::uint64_t historyFrames = 0;  ///< That it holds.
};

/// Opens the scene in the renderer's window and runs it until it is closed. Fails if a world cannot be made,
/// a script names what does not exist, or a file could not be written; what was shown until then is lost.
[[nodiscard]] Result<ViewerReport> runViewer(Renderer& renderer, const ViewerDef& def);

}  // namespace scatter::viewer
