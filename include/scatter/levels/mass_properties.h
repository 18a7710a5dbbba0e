#pragma once

#include <scatter/levels/convex_part.h>
#include <scatter/result.h>

#include <vector>

namespace scatter {

/// Of a homogeneous solid, per kilogram: multiply the inertia by the body's mass.
struct MassProperties {
  float volume = 0.0F;      ///< Cubic metres; parts that overlap are counted once each.
  Vec3 centerOfMass{0.0F};  ///< In the model's frame.
  Mat3 inertia{0.0F};       ///< Square metres, about the centre of mass, along the model's axes.
};

/// Exact for each part (closed forms; hulls by tetrahedra), summed over the parts. Fails if a part
/// has no volume or is not finite, naming the part, counted from 1.
[[nodiscard]] Result<MassProperties> massProperties(const std::vector<ConvexPart>& parts);

}  // namespace scatter
