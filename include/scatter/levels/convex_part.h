#pragma once

#include <scatter/math.h>

#include <variant>
#include <vector>

namespace scatter {

struct Box {
  Vec3 halfExtents{0.5F};
};

struct Sphere {
  float radius = 0.5F;
};

/// Round-ended cylinder along the local y axis; `halfHeight` is that of the cylindrical part.
struct Capsule {
  float radius = 0.5F;
  float halfHeight = 0.5F;
};

/// Along the local y axis.
struct Cylinder {
  float radius = 0.5F;
  float halfHeight = 0.5F;
};

/// The convex hull of a point cloud.
struct ConvexHull {
  std::vector<Vec3> vertices;
};

using ConvexShape = std::variant<Box, Sphere, Capsule, Cylinder, ConvexHull>;

/// One convex piece of a level, placed in the frame of its model.
struct ConvexPart {
  ConvexShape shape;
  Transform pose;
};

}  // namespace scatter
