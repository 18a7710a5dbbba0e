#pragma once

#include <scatter/io/model.h>
#include <scatter/levels/convex_part.h>
#include <scatter/result.h>

#include <string>
#include <vector>

#include "scenes/placement.h"

namespace scatter {

/// The hulls of a body, those that are near each other together.
using HullGroups = std::vector<std::vector<ConvexHull>>;

/// A long body.
struct ClusterDef {
  Vec3 halfExtents{1.0F};  ///< No hull reaches further.
  int groups = 8;          ///< One behind the other along the longest axis.
  int hulls = 64;          ///< At least one a group.
};

/// Random hulls along a body.
[[nodiscard]] HullGroups makeCluster(const ClusterDef& def, Random& random);

/// Its axle is the y axis, so that it lies flat.
struct WheelBodyDef {
  float radius = 0.8F;
  float halfWidth = 0.15F;  ///< Of the rim, metres; hub and spokes are narrower.
  int segments = 27;        ///< Of the rim.
  int spokes = 8;
  int wedges = 5;  ///< Of the hub.
};

/// A rim, spokes and a hub; the length of the spokes and the depth of the rim are random.
[[nodiscard]] HullGroups makeWheel(const WheelBodyDef& def, Random& random);

/// A slab on four legs, its feet at height zero.
[[nodiscard]] HullGroups makeTable(const Vec3& size);

/// A model of three levels: the hulls, the hull of each group, and the hull of all. Nested, since a hull
/// holds the points it is made of. Fails on a hull without volume.
[[nodiscard]] Result<Model> nestedModel(std::string name, const HullGroups& groups, float mass);

}  // namespace scatter
