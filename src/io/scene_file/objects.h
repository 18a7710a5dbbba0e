#pragma once

#include <scatter/io/scene_file.h>

#include "io/scene_file/names.h"
#include "io/scene_file/table.h"

namespace scatter::io {

/// Friction and the like.
void readSurface(const SceneTable& table, SceneFileMaterial& material);

/// All `[[object]]` of the file, and the bodies that they make. Materials and regions must have been read.
void readObjects(const SceneTable& file, SceneFile& scene, const std::vector<SceneFileMaterial>& materials,
                 SceneNames& names);

}  // namespace scatter::io
