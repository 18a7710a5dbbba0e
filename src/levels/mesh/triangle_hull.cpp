#include "levels/mesh/triangle_hull.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

#include "levels/mesh/triangle.h"

namespace scatter::levels {
namespace {

constexpr int kJoggles = 6;

/// -1 to 1.
double unitNoise(std::mt19937_64& engine) {
  return static_cast<double>(engine() >> 11U) * 0x1.0p-52 - 1.0;
}

/// The index of the point with the largest value of `measure`.
template <class Measure>
std::uint32_t farthestBy(std::span<const glm::dvec3> points, const Measure& measure) {
  std::uint32_t best = 0;
  double largest = -1.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double value = measure(points[i]);
    if (value > largest) {
      largest = value;
      best = static_cast<std::uint32_t>(i);
    }
  }
  return best;
}

}  // namespace

bool HullBuilder::build(std::span<const glm::dvec3> points, const HullDef& definition, TriangleHull& result) {
  originals_ = points;
  points_ = points;
  Outcome outcome = attempt(definition, result);
  if (outcome != Outcome::kInconsistent) return outcome == Outcome::kDone;

  // Coplanar points can make rounding contradict itself; moved a little, they do not.
  DoubleBounds bounds;
  for (const glm::dvec3& point : points) bounds.add(point);
  double amplitude = std::max(1e-10 * glm::length(bounds.max - bounds.min), 0.01 * definition.tolerance);
  std::mt19937_64 engine(1);
  for (int i = 0; i < kJoggles; ++i, amplitude *= 8.0) {
    joggled_.assign(points.begin(), points.end());
    for (glm::dvec3& point : joggled_) {
      for (int axis = 0; axis < 3; ++axis) point[axis] += amplitude * unitNoise(engine);
    }
    points_ = joggled_;
    outcome = attempt(definition, result);
    if (outcome != Outcome::kInconsistent) return outcome == Outcome::kDone;
  }
  return false;
}

HullBuilder::Outcome HullBuilder::attempt(const HullDef& definition, TriangleHull& result) {
  tolerance_ = definition.tolerance;
  if (points_.size() < 4 || !startSimplex(definition.thickness)) return Outcome::kFlat;
  result.excess = 0.0;
  for (std::size_t vertices = 4; vertices <= points_.size(); ++vertices) {
    const std::int32_t face = takeFarthestFace();
    if (face < 0) break;
    if (static_cast<int>(vertices) == definition.budget) {
      result.excess = faces_[static_cast<std::size_t>(face)].distance;
    }
    if (!insert(static_cast<std::uint32_t>(face))) return Outcome::kInconsistent;
  }
  emit(result);
  return Outcome::kDone;
}

bool HullBuilder::startSimplex(double thickness) {
  const glm::dvec3 first = points_.front();
  const std::uint32_t a = farthestBy(points_, [&](const glm::dvec3& p) { return glm::length(p - first); });
  const glm::dvec3 start = points_[a];
  const std::uint32_t b = farthestBy(points_, [&](const glm::dvec3& p) { return glm::length(p - start); });
  const double length = glm::length(points_[b] - start);
  if (!(length > 0.0) || length < thickness) return false;

  const glm::dvec3 along = (points_[b] - start) / length;
  const auto acrossOf = [&](const glm::dvec3& p) { return p - start - along * glm::dot(along, p - start); };
  const std::uint32_t c = farthestBy(points_, [&](const glm::dvec3& p) { return glm::length(acrossOf(p)); });
  const double width = glm::length(acrossOf(points_[c]));
  if (!(width > 0.0) || width < thickness) return false;

  const glm::dvec3 normal = glm::normalize(glm::cross(points_[b] - start, points_[c] - start));
  const std::uint32_t d =
      farthestBy(points_, [&](const glm::dvec3& p) { return std::abs(glm::dot(normal, p - start)); });
  const double height = glm::dot(normal, points_[d] - start);
  if (!(std::abs(height) > 0.0) || std::abs(height) < thickness) return false;

  // On a set this thin, distances to planes say little: ask for more than the tolerance.
  tolerance_ = std::max(tolerance_ * std::min(1.0, 3.0 * std::abs(height) / length), 1e-12 * length);
  faces_.clear();
  queue_.clear();
  nextOutside_.assign(points_.size(), -1);
  const std::uint32_t left = height > 0.0 ? c : b;
  const std::uint32_t right = height > 0.0 ? b : c;
  addFace({a, left, right});
  addFace({a, right, d});
  addFace({right, left, d});
  addFace({left, a, d});
  faces_[0].across = {3, 2, 1};
  faces_[1].across = {0, 2, 3};
  faces_[2].across = {0, 3, 1};
  faces_[3].across = {0, 1, 2};
  for (std::uint32_t i = 0; i < points_.size(); ++i) {
    if (i != a && i != b && i != c && i != d) assign(i, 0);
  }
  for (std::uint32_t i = 0; i < 4; ++i) enqueue(i);
  return true;
}

void HullBuilder::addFace(const Triangle& corners) {
  const glm::dvec3 a = points_[corners[0]];
  const glm::dvec3 b = points_[corners[1]];
  const glm::dvec3 c = points_[corners[2]];
  Face face;
  face.corners = corners;
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  const double length = glm::length(normal);
  face.plane.normal = length > 0.0 ? normal / length : glm::dvec3(0.0);
  face.plane.offset =
      (glm::dot(face.plane.normal, a) + glm::dot(face.plane.normal, b) + glm::dot(face.plane.normal, c)) /
      3.0;
  face.distance = tolerance_;
  faces_.push_back(face);
}

void HullBuilder::assign(std::uint32_t point, std::size_t firstFace) {
  Face* best = nullptr;
  double largest = tolerance_;
  for (std::size_t i = firstFace; i < faces_.size(); ++i) {
    const double distance = faces_[i].plane.signedDistance(points_[point]);
    if (distance > largest) {
      largest = distance;
      best = &faces_[i];
    }
  }
  if (best == nullptr) return;
  nextOutside_[point] = best->firstOutside;
  best->firstOutside = static_cast<std::int32_t>(point);
  if (largest > best->distance) {
    best->distance = largest;
    best->farthest = static_cast<std::int32_t>(point);
  }
}

void HullBuilder::enqueue(std::uint32_t face) {
  if (faces_[face].farthest < 0) return;
  queue_.emplace_back(faces_[face].distance, face);
  std::push_heap(queue_.begin(), queue_.end());
}

/// The face with the furthest point outside, or -1.
std::int32_t HullBuilder::takeFarthestFace() {
  while (!queue_.empty()) {
    std::pop_heap(queue_.begin(), queue_.end());
    const std::uint32_t face = queue_.back().second;
    queue_.pop_back();
    if (faces_[face].isAlive) return static_cast<std::int32_t>(face);
  }
  return -1;
}

void HullBuilder::collectVisible(std::uint32_t start, const glm::dvec3& eye) {
  const double slack = 1e-3 * tolerance_;
  visible_.assign(1, start);
  horizon_.clear();
  faces_[start].isVisible = true;
  for (std::size_t next = 0; next < visible_.size(); ++next) {
    const Face& face = faces_[visible_[next]];
    for (std::size_t k = 0; k < 3; ++k) {
      Face& other = faces_[face.across[k]];
      if (other.isVisible) continue;
      if (other.plane.signedDistance(eye) > slack) {
        other.isVisible = true;
        visible_.push_back(face.across[k]);
      }
    }
  }
  for (const std::uint32_t i : visible_) {
    const Face& face = faces_[i];
    for (std::size_t k = 0; k < 3; ++k) {
      if (faces_[face.across[k]].isVisible) continue;
      horizon_.push_back({face.corners[k], face.corners[(k + 1) % 3], face.across[k]});
    }
  }
}

/// Makes one loop of the horizon; false if it is none.
bool HullBuilder::orderHorizon() {
  for (std::size_t i = 0; i + 1 < horizon_.size(); ++i) {
    const auto follower = std::find_if(horizon_.begin() + static_cast<std::ptrdiff_t>(i) + 1, horizon_.end(),
                                       [&](const HorizonEdge& edge) { return edge.from == horizon_[i].to; });
    if (follower == horizon_.end()) return false;
    std::swap(*follower, horizon_[i + 1]);
  }
  return horizon_.size() >= 3 && horizon_.back().to == horizon_.front().from;
}

bool HullBuilder::insert(std::uint32_t face) {
  const auto apex = static_cast<std::uint32_t>(faces_[face].farthest);
  collectVisible(face, points_[apex]);
  if (!orderHorizon()) return false;

  orphans_.clear();
  for (const std::uint32_t i : visible_) {
    faces_[i].isAlive = false;
    for (std::int32_t p = faces_[i].firstOutside; p >= 0; p = nextOutside_[static_cast<std::size_t>(p)]) {
      if (static_cast<std::uint32_t>(p) != apex) orphans_.push_back(static_cast<std::uint32_t>(p));
    }
  }

  const auto first = static_cast<std::uint32_t>(faces_.size());
  const auto count = static_cast<std::uint32_t>(horizon_.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    const HorizonEdge& edge = horizon_[i];
    addFace({edge.from, edge.to, apex});
    faces_.back().across = {edge.outer, first + (i + 1) % count, first + (i + count - 1) % count};
    Face& outer = faces_[edge.outer];
    for (std::size_t k = 0; k < 3; ++k) {
      if (outer.corners[k] == edge.to && outer.corners[(k + 1) % 3] == edge.from) outer.across[k] = first + i;
    }
  }
  for (const std::uint32_t point : orphans_) assign(point, first);
  for (std::uint32_t i = 0; i < count; ++i) enqueue(first + i);
  return true;
}

void HullBuilder::emit(TriangleHull& result) const {
  constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> indices(points_.size(), kUnused);
  result.vertices.clear();
  result.triangles.clear();
  result.planes.clear();
  result.area = 0.0;
  result.bounds = {};
  for (const Face& face : faces_) {
    if (!face.isAlive) continue;
    Triangle triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& index = indices[face.corners[k]];
      if (index == kUnused) {
        index = static_cast<std::uint32_t>(result.vertices.size());
        result.vertices.push_back(originals_[face.corners[k]]);
        result.bounds.add(result.vertices.back());
      }
      triangle[k] = index;
    }
    result.triangles.push_back(triangle);
    result.planes.push_back(face.plane);
    result.area += triangleArea(points_[face.corners[0]], points_[face.corners[1]], points_[face.corners[2]]);
  }
}

glm::dvec3 centerOf(const TriangleHull& hull) {
  glm::dvec3 middle{0.0};
  for (const glm::dvec3& vertex : hull.vertices) middle += vertex;
  middle /= static_cast<double>(hull.vertices.size());
  glm::dvec3 weighted{0.0};
  double volume = 0.0;
  for (const Triangle& triangle : hull.triangles) {
    const glm::dvec3 a = hull.vertices[triangle[0]] - middle;
    const glm::dvec3 b = hull.vertices[triangle[1]] - middle;
    const glm::dvec3 c = hull.vertices[triangle[2]] - middle;
    const double part = glm::dot(a, glm::cross(b, c));
    weighted += part * (a + b + c) / 4.0;
    volume += part;
  }
  return volume > 0.0 ? middle + weighted / volume : middle;
}

double distanceTo(const TriangleHull& hull, const glm::dvec3& point) {
  double best = std::numeric_limits<double>::infinity();
  bool isInside = true;
  for (std::size_t i = 0; i < hull.triangles.size(); ++i) {
    if (hull.planes[i].signedDistance(point) <= 0.0) continue;
    isInside = false;
    const Triangle& t = hull.triangles[i];
    const glm::dvec3 nearest =
        closestPoint(point, hull.vertices[t[0]], hull.vertices[t[1]], hull.vertices[t[2]]);
    const glm::dvec3 offset = point - nearest;
    best = std::min(best, glm::dot(offset, offset));
  }
  return isInside ? 0.0 : std::sqrt(best);
}

double reach(std::span<const glm::dvec3> points, const glm::dvec3& direction) {
  double largest = -std::numeric_limits<double>::infinity();
  for (const glm::dvec3& point : points) largest = std::max(largest, glm::dot(direction, point));
  return largest;
}

}  // namespace scatter::levels
