#include "scenes/detailed_bodies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>
#include <tuple>
#include <utility>

#include "levels/convex_hull.h"

namespace scatter {
namespace {

constexpr float kGrid = 4096.0F;     // points lie on multiples of its inverse: short in a file, and exact
constexpr int kMostExtraPoints = 5;  // of a random hull, beside its eight
constexpr float kMeanReach = 0.8F;   // of its points along an axis, by its radius
constexpr float kMostReach = 1.4F;   // of a hull along the body, by the length of its group
constexpr float kMostShift = 0.4F;   // of its middle, by that length
constexpr float kFullTurn = 2.0F * std::numbers::pi_v<float>;

Vec3 onGrid(const Vec3& point) {
  return glm::round(point * kGrid) / kGrid;
}

/// From -1 to 1 in each coordinate.
Vec3 insideCube(Random& random) {
  const float x = random.uniform(-1.0F, 1.0F);
  const float y = random.uniform(-1.0F, 1.0F);
  const float z = random.uniform(-1.0F, 1.0F);
  return {x, y, z};
}

/// A point in each octant, and some more.
ConvexHull randomHull(const Vec3& center, const Vec3& radii, Random& random) {
  ConvexHull hull;
  for (int octant = 0; octant < 8; ++octant) {
    const Vec3 corner((octant & 1) != 0 ? 1.0F : -1.0F, (octant & 2) != 0 ? 1.0F : -1.0F,
                      (octant & 4) != 0 ? 1.0F : -1.0F);
    const Vec3 share = Vec3(kMeanReach) + (1.0F - kMeanReach) * insideCube(random);
    hull.vertices.push_back(onGrid(center + radii * corner * share));
  }
  for (std::size_t extra = random.below(kMostExtraPoints + 1); extra > 0; --extra) {
    hull.vertices.push_back(onGrid(center + radii * random.direction()));
  }
  return hull;
}

int longestAxis(const Vec3& size) {
  if (size.x >= size.y && size.x >= size.z) return 0;
  return size.y >= size.z ? 1 : 2;
}

/// Where a circle about the y axis is.
Vec3 around(float radius, float height, float angle) {
  return {radius * std::cos(angle), height, radius * std::sin(angle)};
}

/// A piece of a ring between two angles; of a disc if the inner radius is zero.
ConvexHull ringPiece(float inner, float outer, float halfWidth, float from, float to) {
  ConvexHull hull;
  for (const float height : {-halfWidth, halfWidth}) {
    if (inner <= 0.0F) hull.vertices.push_back(onGrid({0.0F, height, 0.0F}));
    for (const float angle : {from, to}) {
      if (inner > 0.0F) hull.vertices.push_back(onGrid(around(inner, height, angle)));
      hull.vertices.push_back(onGrid(around(outer, height, angle)));
    }
  }
  return hull;
}

ConvexHull spoke(float from, float to, float halfWidth, float angle) {
  const Vec3 across = halfWidth * around(1.0F, 0.0F, angle + 0.25F * kFullTurn);
  ConvexHull hull;
  for (const float radius : {from, to}) {
    for (const float height : {-halfWidth, halfWidth}) {
      const Vec3 middle = around(radius, height, angle);
      hull.vertices.push_back(onGrid(middle - across));
      hull.vertices.push_back(onGrid(middle + across));
    }
  }
  return hull;
}

ConvexHull boxHull(const Vec3& low, const Vec3& high) {
  ConvexHull hull;
  for (int corner = 0; corner < 8; ++corner) {
    hull.vertices.push_back(onGrid({(corner & 1) != 0 ? high.x : low.x, (corner & 2) != 0 ? high.y : low.y,
                                    (corner & 4) != 0 ? high.z : low.z}));
  }
  return hull;
}

/// The hull of all points of these hulls, without the points inside of it.
Result<ConvexPart> hullAround(const std::vector<ConvexHull>& hulls) {
  std::vector<glm::dvec3> points;
  for (const ConvexHull& hull : hulls)
    points.insert(points.end(), hull.vertices.begin(), hull.vertices.end());
  const auto solid = levels::convexHull(points);
  if (!solid) return fail("a hull: " + solid.error().message);
  ConvexHull around;
  for (const glm::dvec3& vertex : solid->vertices()) around.vertices.emplace_back(vertex);
  // In an order that does not depend on how the hull was found.
  std::sort(around.vertices.begin(), around.vertices.end(),
            [](const Vec3& a, const Vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); });
  return ConvexPart{.shape = std::move(around), .pose = {}};
}

}  // namespace

HullGroups makeCluster(const ClusterDef& def, Random& random) {
  const int axis = longestAxis(def.halfExtents);
  const auto count = static_cast<float>(def.groups);
  const float length = def.halfExtents[axis] / std::max(count, kMostReach);
  const float ends = def.halfExtents[axis] - kMostReach * length;
  HullGroups groups(static_cast<std::size_t>(def.groups));
  for (int i = 0; i < std::max(def.hulls, def.groups); ++i) {
    const int group = i % def.groups;
    const float along = def.groups > 1 ? 2.0F * static_cast<float>(group) / (count - 1.0F) - 1.0F : 0.0F;
    Vec3 center = 0.55F * def.halfExtents * insideCube(random);
    center[axis] = ends * along + kMostShift * length * random.uniform(-1.0F, 1.0F);
    Vec3 radii = def.halfExtents * random.uniform(0.28F, 0.44F);
    radii[axis] = length * random.uniform(0.75F, kMostReach - kMostShift);
    groups[static_cast<std::size_t>(group)].push_back(randomHull(center, radii, random));
  }
  return groups;
}

HullGroups makeWheel(const WheelBodyDef& def, Random& random) {
  constexpr int kArcs = 8;
  const float inner = def.radius * random.uniform(0.74F, 0.84F);
  const float hub = def.radius * random.uniform(0.2F, 0.3F);
  const float spokeHalfWidth = def.halfWidth * random.uniform(0.35F, 0.5F);
  HullGroups groups(kArcs + 1);
  const auto arcOf = [](int i, int count) { return static_cast<std::size_t>(i * kArcs / count); };
  const auto angleOf = [](int i, int count) {
    return kFullTurn * static_cast<float>(i) / static_cast<float>(count);
  };
  for (int i = 0; i < def.segments; ++i) {
    groups[arcOf(i, def.segments)].push_back(
        ringPiece(inner, def.radius, def.halfWidth, angleOf(i, def.segments), angleOf(i + 1, def.segments)));
  }
  for (int i = 0; i < def.spokes; ++i) {
    // Into the hub and into the rim.
    groups[arcOf(i, def.spokes)].push_back(
        spoke(0.6F * hub, 0.5F * (inner + def.radius), spokeHalfWidth, angleOf(2 * i + 1, 2 * def.spokes)));
  }
  for (int i = 0; i < def.wedges; ++i) {
    groups.back().push_back(
        ringPiece(0.0F, hub, 0.8F * def.halfWidth, angleOf(i, def.wedges), angleOf(i + 1, def.wedges)));
  }
  return groups;
}

HullGroups makeTable(const Vec3& size) {
  const float thick = 0.1F * size.y;
  const Vec3 half(0.5F * size.x, 0.0F, 0.5F * size.z);
  std::vector<ConvexHull> legs;
  for (const float x : {-1.0F, 1.0F}) {
    for (const float z : {-1.0F, 1.0F}) {
      const Vec3 corner(x * half.x, 0.0F, z * half.z);
      const Vec3 inside(x * (half.x - thick), size.y - thick, z * (half.z - thick));
      legs.push_back(boxHull(glm::min(corner, inside), glm::max(corner, inside)));
    }
  }
  return {{boxHull({-half.x, size.y - thick, -half.z}, {half.x, size.y, half.z})}, std::move(legs)};
}

Result<Model> nestedModel(std::string name, const HullGroups& groups, float mass) {
  LevelSetDef def{.name = name, .levels = std::vector<Level>(3), .mass = {}};
  std::vector<ConvexHull> all;
  for (const auto& group : groups) {
    auto around = hullAround(group);
    if (!around) return tl::unexpected(around.error());
    def.levels[1].parts.push_back(std::move(*around));
    for (const ConvexHull& hull : group) def.levels[2].parts.push_back({.shape = hull, .pose = {}});
    all.insert(all.end(), group.begin(), group.end());
  }
  auto around = hullAround(all);
  if (!around) return tl::unexpected(around.error());
  def.levels[0].parts.push_back(std::move(*around));
  auto levels = LevelSet::create(std::move(def));
  if (!levels) return tl::unexpected(levels.error());
  return Model{.name = std::move(name), .mesh = {}, .levels = std::move(*levels), .mass = mass};
}

}  // namespace scatter
