#include "prop.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <utility>

#include "boxes.h"

namespace scatter::tools {
namespace {

/// By which things stand above a floor, metres: a thousandth of their size.
constexpr float kPropMargin = 0.001F;

std::vector<Vec3> snappedRing(const Ring& ring) {
  std::vector<Vec3> points;
  for (const glm::dvec3& point : ring) points.push_back(snapped(point));
  return points;
}

ConvexPart hullOf(const Ring& from, const Ring& to) {
  ConvexHull hull{snappedRing(from)};
  for (const Vec3& point : snappedRing(to)) hull.vertices.push_back(point);
  return {std::move(hull), {}};
}

Vec3 centerOf(const std::vector<Vec3>& points) {
  Vec3 sum(0.0F);
  for (const Vec3& point : points) sum += point;
  return sum / static_cast<float>(points.size());
}

}  // namespace

Ring polygon(int corners, double radius, double y, double phase) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = phase + 2.0 * glm::pi<double>() * i / corners;
    ring.emplace_back(radius * std::cos(angle), y, radius * std::sin(angle));
  }
  return ring;
}

Ring polygonAcross(const glm::dvec3& axis, const glm::dvec3& center, int corners, double radius) {
  const glm::dmat3 axes = axesAlong(axis, {0.0, 0.0, 1.0});
  Ring ring;
  for (const glm::dvec3& point : polygon(corners, radius, 0.0)) {
    ring.push_back(center + axes * glm::dvec3(point.y, point.x, point.z));
  }
  return ring;
}

void Prop::beginGroup(const glm::dmat3& axes) {
  groups_.push_back({axes, {}, {}});
}

void Prop::addBox(const glm::dvec3& center, const glm::dvec3& halfExtents) {
  addBar(center - glm::dvec3(halfExtents.x, 0.0, 0.0), center + glm::dvec3(halfExtents.x, 0.0, 0.0),
         halfExtents.z, halfExtents.y);
}

void Prop::addBar(const glm::dvec3& from, const glm::dvec3& to, double halfWidth, double halfHeight) {
  const glm::dvec3 along = glm::normalize(to - from);
  const glm::dmat3 axes =
      axesAlong(along, std::abs(along.y) > 0.9 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0));
  std::vector<Vec3> ends[2];
  for (const auto& [y, z] : {std::pair(-1, -1), std::pair(-1, 1), std::pair(1, 1), std::pair(1, -1)}) {
    const glm::dvec3 across = axes[1] * (y * halfHeight) + axes[2] * (z * halfWidth);
    ends[0].push_back(snapped(from + across));
    ends[1].push_back(snapped(to + across));
  }
  addMesh(ends[0], ends[1]);
  std::vector<Vec3> corners = ends[0];
  corners.insert(corners.end(), ends[1].begin(), ends[1].end());
  finest_.parts.push_back(boxAround(corners, axes, 0.0));
  addCorners(finest_.parts.back(), groups_.back().points);
}

void Prop::addFrustum(const Ring& from, const Ring& to) {
  addMesh(snappedRing(from), snappedRing(to));
  finest_.parts.push_back(hullOf(from, to));
  std::vector<Vec3>& points = groups_.back().points;
  const auto& vertices = std::get<ConvexHull>(finest_.parts.back().shape).vertices;
  // The margin counts as if it had corners.
  for (const Vec3& vertex : vertices) {
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 margin(0.0F);
      margin[axis] = kPropMargin;
      points.push_back(vertex - margin);
      points.push_back(vertex + margin);
    }
  }
}

void Prop::addLoft(const std::vector<Ring>& rings) {
  for (std::size_t i = 1; i < rings.size(); ++i) addFrustum(rings[i - 1], rings[i]);
}

void Prop::addPanel(const Panel& panel) {
  const auto at = [](double radius, double y, double angle) {
    return glm::dvec3(radius * std::cos(angle), y, radius * std::sin(angle));
  };
  const auto end = [&](double y, double inner, double outer) {
    return Ring{at(inner, y, panel.angleFrom), at(outer, y, panel.angleFrom), at(outer, y, panel.angleTo),
                at(inner, y, panel.angleTo)};
  };
  addFrustum(end(panel.yFrom, panel.innerFrom, panel.outerFrom),
             end(panel.yTo, panel.innerTo, panel.outerTo));
}

void Prop::addMiddleHull(const Ring& from, const Ring& to) {
  groups_.back().middle.push_back(hullOf(from, to));
}

void Prop::addMesh(const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
  const auto base = static_cast<std::uint32_t>(mesh_.vertices.size());
  const auto corners = static_cast<std::uint32_t>(from.size());
  mesh_.vertices.insert(mesh_.vertices.end(), from.begin(), from.end());
  mesh_.vertices.insert(mesh_.vertices.end(), to.begin(), to.end());
  const Vec3 middle = 0.5F * (centerOf(from) + centerOf(to));
  const auto addOutward = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const auto& v = mesh_.vertices;
    const Vec3 normal = glm::cross(v[b] - v[a], v[c] - v[a]);
    const bool outward = glm::dot(normal, v[a] - middle) > 0.0F;
    mesh_.triangles.push_back(outward ? std::array{a, b, c} : std::array{a, c, b});
  };
  for (std::uint32_t i = 1; i + 1 < corners; ++i) {
    addOutward(base, base + i, base + i + 1);
    addOutward(base + corners, base + corners + i, base + corners + i + 1);
  }
  for (std::uint32_t i = 0; i < corners; ++i) {
    const std::uint32_t next = (i + 1) % corners;
    addOutward(base + i, base + next, base + corners + i);
    addOutward(base + next, base + corners + next, base + corners + i);
  }
}

Level Prop::middleLevel() const {
  Level level;
  for (const Group& group : groups_) {
    if (group.middle.empty()) {
      level.parts.push_back(boxAround(group.points, group.axes, 0.0));
    } else {
      level.parts.insert(level.parts.end(), group.middle.begin(), group.middle.end());
    }
  }
  return level;
}

Result<Model> Prop::build() const {
  Level middle = middleLevel();
  std::vector<Vec3> corners;
  for (const ConvexPart& part : middle.parts) {
    if (const auto* hull = std::get_if<ConvexHull>(&part.shape)) {
      for (const Vec3& vertex : hull->vertices) {
        corners.push_back(vertex - Vec3(kPropMargin));
        corners.push_back(vertex + Vec3(kPropMargin));
      }
    } else {
      addCorners(part, corners);
    }
  }
  Level coarsest{{boxAround(corners, glm::dmat3(1.0), 0.0)}};
  LevelSetDef def;
  def.name = name_;
  def.levels = {std::move(coarsest), std::move(middle), finest_};
  def.hullMargin = kPropMargin;
  if (const Result<SolidMass> mass = massOfMesh(mesh_)) def.mass = mass->properties;
  return LevelSet::create(std::move(def)).map([&](std::shared_ptr<const LevelSet> levels) {
    return Model{name_, mesh_, std::move(levels), mass_, 0.6F, 0.1F};
  });
}

}  // namespace scatter::tools
