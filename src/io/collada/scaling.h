#pragma once

#include <scatter/io/physics_document.h>

namespace scatter::io {

/// Scales a body's shapes along the axes of its frame. False if a round shape became a hull near it.
[[nodiscard]] bool scaleShapes(std::vector<DocumentShape>& shapes, const Vec3& scale);

/// The same for levels. Fails, with a phrase, if they do not nest any more.
[[nodiscard]] Result<std::shared_ptr<const LevelSet>> scaleLevels(const LevelSet& levels, const Vec3& scale);

}  // namespace scatter::io
