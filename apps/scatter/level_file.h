#pragma once

#include <scatter/io/model.h>
#include <scatter/levels/level_set.h>
#include <scatter/levels/surface_mesh.h>
#include <scatter/result.h>

#include <memory>
#include <string>
#include <vector>

namespace scatter::app {

/// A model with levels as a file has it, sound or not.
struct LevelModel {
  std::string name;
  std::shared_ptr<const LevelSet> levels;
  SurfaceMesh mesh;  ///< May be empty.
};

/// The models of a COLLADA or glTF physics file, chosen by its extension. Their levels need not be nested.
/// Bodies without levels count as one with their shapes as the only level; those with a plane or a mesh as a
/// shape are left out with a note. Fails if there are none.
[[nodiscard]] Result<std::vector<LevelModel>> readLevelFile(const std::string& path);

/// Whether it is a COLLADA or glTF physics file of one body, which has levels, and in which nothing happens:
/// what writeLevelFile() makes.
[[nodiscard]] bool isLevelFile(const std::string& path);

/// Writes a model as a COLLADA or glTF physics file, chosen by the extension.
[[nodiscard]] Result<void> writeLevelFile(const Model& model, const std::string& path);

/// Whether writeLevelFile knows the extension and the folder is there.
[[nodiscard]] Result<void> checkLevelFileName(const std::string& path);

}  // namespace scatter::app
