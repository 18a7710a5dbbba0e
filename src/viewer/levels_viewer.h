#pragma once

#include <scatter/levels/level_set.h>
#include <scatter/levels/surface_mesh.h>
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

/// A model whose levels are shown.
struct ShownModel {
  std::string name{};
  std::shared_ptr<const LevelSet> levels{};
  SurfaceMesh mesh{};  ///< If it is empty there are no gaps to be seen.
};

struct LevelsViewerDef {
  std::vector<ShownModel> models{};        ///< One or more; one is shown at a time.
  std::filesystem::path out = "out/view";  ///< Pictures go here.
  std::uint64_t loops = 0;                 ///< As ViewerDef has it, as what follows.
  std::optional<ViewScript> script{};
  bool panels = true;
};

/// What a window has seen.
struct LevelsViewerReport {
  std::uint64_t loops = 0;
};

/// Shows the levels of models in the renderer's window, until it is closed: each level's parts, pulled apart,
/// and the mesh in colours of the gap that the level leaves over it. Fails if a mesh cannot be measured, a
/// script names what does not exist, or a picture could not be written.
[[nodiscard]] Result<LevelsViewerReport> runLevelsViewer(Renderer& renderer, const LevelsViewerDef& def);

}  // namespace scatter::viewer
