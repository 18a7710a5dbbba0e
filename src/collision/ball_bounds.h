#pragma once

#include "collision/frame.h"
#include "collision/support.h"

namespace scatter {

/// World bounds of the hull of balls of these radii, padded as their centres are, with its body at `frame`:
/// as close as they may be, but for rounding, however the body is turned.
void boundBalls(const PolytopeView& centers, const float* radii, const Frame& frame, Vec3& low, Vec3& high);

}  // namespace scatter
