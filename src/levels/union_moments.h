#pragma once

#include <scatter/levels/convex_part.h>

#include <glm/vec3.hpp>
#include <span>

#include "levels/line_moments.h"

namespace scatter::levels {

/// What parts share with the parts before them: the sum over all parts less this is of their union.
/// About `origin`, by 64 x 64 columns through each part that overlaps others: exact along the column, the
/// middle of each column standing for all of it. Errors are added up over the parts. Hulls without their
/// margin; parts without volume, which massProperties() refuses, must not be given. The last few results are
/// kept, a megabyte at most, and given again for the same parts.
[[nodiscard]] EstimatedMoments sharedMoments(std::span<const ConvexPart> parts, const glm::dvec3& origin);

}  // namespace scatter::levels
