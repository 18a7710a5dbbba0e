#pragma once

#include <scatter/levels/level_set.h>
#include <scatter/levels/surface_mesh.h>
#include <scatter/result.h>

#include <filesystem>
#include <string>
#include <vector>

namespace scatter::lab {

/// What a picture shows side by side: the mesh, if it is not empty, then each level, coarsest first.
struct LevelPicture {
  std::string title;
  const LevelSet* levels = nullptr;
  const SurfaceMesh* mesh = nullptr;

  /// Under each panel, the mesh's first; as many as there are panels.
  std::vector<std::string> captions;
};

/// Draws it into a .png or .svg file, all panels from the same side and at the same scale, with every part in
/// a colour of its own. Needs gnuplot but no display. Fails, leaving nothing behind, on another extension
/// and if the file cannot be written.
[[nodiscard]] Result<void> drawLevels(const LevelPicture& picture, const std::filesystem::path& file);

}  // namespace scatter::lab
