#pragma once

#include <scatter/io/scene_file.h>
#include <scatter/result.h>
#include <scatter/world/body.h>

#include "scenes/breakable.h"
#include "scenes/scene_models.h"

namespace scatter {

/// What a body of this object breaks into: its gibs, or the parts of its finest level, `shrink` times their
/// size. `def` is one of its bodies.
[[nodiscard]] Result<Breakable> makePieces(const SceneFileObject& object, const BodyDef& def, float shrink,
                                           SceneModels& models);

}  // namespace scatter
