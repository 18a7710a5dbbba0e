#pragma once

#include "io/collada_frame.h"

#include <scatter/levels/level_set.h>

namespace scatter::io {

/// The `<shape>` children of an element, in metres, y up. Fails if there are none.
[[nodiscard]] Result<Level> readShapes(const ColladaFrame& frame, const pugi::xml_node& parent);

/// The rotation that a `<rotate>` holds: an axis and an angle in degrees. The axis must not be zero.
[[nodiscard]] Quat rotationFromDegrees(double x, double y, double z, double degrees);

}  // namespace scatter::io
