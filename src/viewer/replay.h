#pragma once

#include <scatter/result.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "viewer/renderer.h"
#include "viewer/view_script.h"

namespace scatter::viewer {

/// A recording that is shown in a window.
struct ReplayDef {
  std::filesystem::path recording{};
  std::filesystem::path out = "out/view";  ///< Pictures go here.
  std::uint64_t loops = 0;                 ///< As ViewerDef has it, as what follows.
  std::optional<ViewScript> script{};
  std::vector<std::string> views{
      "marks"};  ///< Of these shapes, levels, contacts, credit, sleeping and marks are recorded.
  bool panels = true;
};

/// What a window has seen.
struct ReplayReport {
  std::uint64_t loops = 0;
  std::uint64_t frame = 0;  ///< That was shown last.
  std::string picked{};     ///< The name of the body that was picked last; empty if none is.
  std::string note{};       ///< What of the recording is not whole; empty if all is.
};

/// Opens the recording in the renderer's window, until it is closed. Fails if it cannot be read, a script
/// names what does not exist, or a picture could not be written.
[[nodiscard]] Result<ReplayReport> runReplay(Renderer& renderer, const ReplayDef& def);

}  // namespace scatter::viewer
