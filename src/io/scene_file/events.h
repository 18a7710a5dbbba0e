#pragma once

#include <scatter/io/scene_file.h>

#include "io/scene_file/names.h"
#include "io/scene_file/table.h"

namespace scatter::io {

/// All `[[joint]]` of the file. Objects must have been read.
void readJoints(const SceneTable& file, SceneFile& scene, const SceneNames& names);

/// All `[[event]]` of the file. Objects and fields must have been read.
void readEvents(const SceneTable& file, SceneFile& scene, const SceneNames& names);

}  // namespace scatter::io
