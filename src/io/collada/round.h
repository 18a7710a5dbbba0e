#pragma once

#include <scatter/levels/convex_part.h>

#include <array>

namespace scatter::io {

/// One end of a round shape along the y axis: an ellipse, or half an ellipsoid.
struct RoundEnd {
  float height = 0.0F;           ///< The y coordinate of the ellipse.
  std::array<float, 2> radii{};  ///< Along x and z.
  float cap = 0.0F;              ///< How far half an ellipsoid reaches out beyond the ellipse; 0: flat.
};

/// The convex hull of two ends as vertices on their surface, so that the hull lies within the shape, at most
/// 1.3 % of the radius away: 20 sides, and as many rings to a cap as look alike.
[[nodiscard]] ConvexHull roundHull(const RoundEnd& bottom, const RoundEnd& top);

}  // namespace scatter::io
