#include "levels/polytope.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <utility>

namespace scatter::levels {
namespace {

constexpr std::uint32_t kUnusedVertex = std::numeric_limits<std::uint32_t>::max();

enum class Side { kInside, kOn, kOutside };

/// New vertices where edges cross a plane, one per edge although two faces share it.
class EdgeCuts {
 public:
  EdgeCuts(const std::vector<glm::dvec3>& vertices, const std::vector<double>& distances, Polytope& target)
      : vertices_(vertices), distances_(distances), target_(target) {}

  std::uint32_t at(std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax(a, b);
    for (const Cut& cut : cuts_) {
      if (cut.low == low && cut.high == high) return cut.vertex;
    }
    const double share = distances_[low] / (distances_[low] - distances_[high]);
    const std::uint32_t vertex =
        target_.addVertex(vertices_[low] + share * (vertices_[high] - vertices_[low]));
    cuts_.push_back({low, high, vertex});
    return vertex;
  }

  void appendTo(std::vector<std::uint32_t>& list) const {
    for (const Cut& cut : cuts_) list.push_back(cut.vertex);
  }

 private:
  struct Cut {
    std::uint32_t low;
    std::uint32_t high;
    std::uint32_t vertex;
  };

  const std::vector<glm::dvec3>& vertices_;
  const std::vector<double>& distances_;
  Polytope& target_;
  std::vector<Cut> cuts_;
};

/// Two unit vectors u, v with u × v = normal.
std::pair<glm::dvec3, glm::dvec3> basisOf(const glm::dvec3& normal) {
  const glm::dvec3 a = glm::abs(normal);
  glm::dvec3 axis{0.0, 0.0, 1.0};
  if (a.x <= a.y && a.x <= a.z)
    axis = {1.0, 0.0, 0.0};
  else if (a.y <= a.z)
    axis = {0.0, 1.0, 0.0};
  const glm::dvec3 u = glm::normalize(glm::cross(axis, normal));
  return {u, glm::cross(normal, u)};
}

struct PlanePoint {
  glm::dvec2 position;
  std::uint32_t vertex;
};

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Corners of the convex hull, counter-clockwise (Andrew's monotone chain).
std::vector<std::uint32_t> hullLoop(std::vector<PlanePoint> points) {
  std::sort(points.begin(), points.end(), [](const PlanePoint& a, const PlanePoint& b) {
    if (a.position.x != b.position.x) return a.position.x < b.position.x;
    if (a.position.y != b.position.y) return a.position.y < b.position.y;
    return a.vertex < b.vertex;
  });
  std::vector<PlanePoint> chain;
  const auto extend = [&chain](const PlanePoint& point, std::size_t base) {
    while (chain.size() >= base + 2 &&
           turn(chain[chain.size() - 2].position, chain.back().position, point.position) <= 0.0) {
      chain.pop_back();
    }
    chain.push_back(point);
  };
  for (const PlanePoint& point : points) extend(point, 0);
  const std::size_t base = chain.size() - 1;
  for (auto point = points.rbegin() + 1; point != points.rend(); ++point) extend(*point, base);
  chain.pop_back();
  std::vector<std::uint32_t> loop;
  loop.reserve(chain.size());
  for (const PlanePoint& point : chain) loop.push_back(point.vertex);
  return loop;
}

/// Squared distance of `p` from triangle abc, by the regions of its corners, edges and inside.
double squaredDistanceToTriangle(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
                                 const glm::dvec3& c) {
  const auto toSegment = [&p](const glm::dvec3& from, const glm::dvec3& to) {
    const glm::dvec3 edge = to - from;
    const double length2 = glm::dot(edge, edge);
    const double t = length2 > 0.0 ? std::clamp(glm::dot(p - from, edge) / length2, 0.0, 1.0) : 0.0;
    const glm::dvec3 gap = p - (from + t * edge);
    return glm::dot(gap, gap);
  };
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  const double length2 = glm::dot(normal, normal);
  const bool isAbove = length2 > 0.0 && glm::dot(glm::cross(b - a, p - a), normal) >= 0.0 &&
                       glm::dot(glm::cross(c - b, p - b), normal) >= 0.0 &&
                       glm::dot(glm::cross(a - c, p - c), normal) >= 0.0;
  if (isAbove) {
    const double height = glm::dot(p - a, normal);
    return height * height / length2;
  }
  return std::min({toSegment(a, b), toSegment(b, c), toSegment(c, a)});
}

}  // namespace

void DoubleBounds::add(const glm::dvec3& point) {
  min = glm::min(min, point);
  max = glm::max(max, point);
}

bool DoubleBounds::overlaps(const DoubleBounds& other, double margin) const {
  return min.x <= other.max.x + margin && other.min.x <= max.x + margin && min.y <= other.max.y + margin &&
         other.min.y <= max.y + margin && min.z <= other.max.z + margin && other.min.z <= max.z + margin;
}

Polytope Polytope::box(const glm::dvec3& center, const glm::dmat3& axes, const glm::dvec3& halfExtents) {
  Polytope result;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const glm::dvec3 sign{(corner & 1U) != 0 ? 1.0 : -1.0, (corner & 2U) != 0 ? 1.0 : -1.0,
                          (corner & 4U) != 0 ? 1.0 : -1.0};
    result.addVertex(center + axes * (sign * halfExtents));
  }
  static constexpr std::array<std::array<std::uint32_t, 4>, 6> kLoops{
      {{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3}, {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}}};
  for (int side = 0; side < 6; ++side) {
    const int axis = side / 2;
    const glm::dvec3 normal = side % 2 == 0 ? axes[axis] : -axes[axis];
    result.addOrderedFace({normal, glm::dot(normal, center) + halfExtents[axis]},
                          kLoops[static_cast<std::size_t>(side)]);
  }
  return result;
}

std::span<const std::uint32_t> Polytope::loop(const Face& face) const {
  return std::span(loops_).subspan(face.first, face.count);
}

DoubleBounds Polytope::bounds() const {
  DoubleBounds bounds;
  for (const glm::dvec3& vertex : vertices_) bounds.add(vertex);
  return bounds;
}

std::uint32_t Polytope::addVertex(const glm::dvec3& vertex) {
  vertices_.push_back(vertex);
  return static_cast<std::uint32_t>(vertices_.size() - 1);
}

void Polytope::addOrderedFace(const HalfSpace& plane, std::span<const std::uint32_t> loop) {
  faces_.push_back(
      {plane, static_cast<std::uint32_t>(loops_.size()), static_cast<std::uint32_t>(loop.size())});
  loops_.insert(loops_.end(), loop.begin(), loop.end());
}

void Polytope::addFace(const HalfSpace& plane, std::vector<std::uint32_t> members) {
  if (members.size() < 3) return;
  const auto [u, v] = basisOf(plane.normal);
  const glm::dvec3 origin = vertices_[members.front()];
  std::vector<PlanePoint> points;
  points.reserve(members.size());
  for (const std::uint32_t member : members) {
    const glm::dvec3 offset = vertices_[member] - origin;
    points.push_back({{glm::dot(offset, u), glm::dot(offset, v)}, member});
  }
  const std::vector<std::uint32_t> loop = hullLoop(std::move(points));
  if (loop.size() >= 3) addOrderedFace(plane, loop);
}

void Polytope::dropUnusedVertices() {
  std::vector<std::uint32_t> newIndex(vertices_.size(), kUnusedVertex);
  std::vector<glm::dvec3> kept;
  for (std::uint32_t& index : loops_) {
    if (newIndex[index] == kUnusedVertex) {
      newIndex[index] = static_cast<std::uint32_t>(kept.size());
      kept.push_back(vertices_[index]);
    }
    index = newIndex[index];
  }
  vertices_ = std::move(kept);
}

Polytope Polytope::clipped(const HalfSpace& halfSpace, double epsilon) const {
  std::vector<double> distances;
  std::vector<Side> sides;
  std::vector<std::uint32_t> cap;
  for (std::uint32_t i = 0; i < vertices_.size(); ++i) {
    const double distance = halfSpace.signedDistance(vertices_[i]);
    distances.push_back(distance);
    sides.push_back(distance > epsilon ? Side::kOutside : distance < -epsilon ? Side::kInside : Side::kOn);
    if (sides.back() == Side::kOn) cap.push_back(i);
  }
  if (std::find(sides.begin(), sides.end(), Side::kOutside) == sides.end()) return *this;
  if (std::find(sides.begin(), sides.end(), Side::kInside) == sides.end()) return {};

  Polytope result;
  result.vertices_ = vertices_;
  EdgeCuts cuts(vertices_, distances, result);
  std::vector<std::uint32_t> kept;
  for (const Face& face : faces_) {
    kept.clear();
    bool hasInside = false;
    const auto corners = loop(face);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::uint32_t a = corners[i];
      const std::uint32_t b = corners[i + 1 < corners.size() ? i + 1 : 0];
      hasInside = hasInside || sides[a] == Side::kInside;
      if (sides[a] != Side::kOutside) kept.push_back(a);
      const bool crosses = (sides[a] == Side::kInside && sides[b] == Side::kOutside) ||
                           (sides[a] == Side::kOutside && sides[b] == Side::kInside);
      if (crosses) kept.push_back(cuts.at(a, b));
    }
    // A face with nothing inside lies on the plane or beyond it: the cap takes its place.
    if (hasInside && kept.size() >= 3) result.addOrderedFace(face.plane, kept);
  }
  cuts.appendTo(cap);
  result.addFace(halfSpace, std::move(cap));
  result.dropUnusedVertices();
  return result;
}

SolidMoments Polytope::moments() const {
  glm::dvec3 origin{0.0};
  for (const glm::dvec3& vertex : vertices_) origin += vertex / static_cast<double>(vertices_.size());
  double volume = 0.0;
  glm::dvec3 first{0.0};
  glm::dmat3 second{0.0};
  for (const Face& face : faces_) {
    const auto corners = loop(face);
    const glm::dvec3 a = vertices_[corners[0]] - origin;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      const glm::dvec3 b = vertices_[corners[i]] - origin;
      const glm::dvec3 c = vertices_[corners[i + 1]] - origin;
      const glm::dvec3 sum = a + b + c;
      const double part = glm::dot(a, glm::cross(b, c)) / 6.0;
      volume += part;
      first += part / 4.0 * sum;
      // Second moment of a tetrahedron with one corner at the origin: V/20 (Σ vvᵀ + ΣvΣvᵀ).
      second += part / 20.0 *
                (glm::outerProduct(a, a) + glm::outerProduct(b, b) + glm::outerProduct(c, c) +
                 glm::outerProduct(sum, sum));
    }
  }
  if (!(volume > 0.0)) return {};
  const glm::dvec3 center = first / volume;
  const glm::dmat3 spread = second / volume - glm::outerProduct(center, center);
  const double trace = spread[0][0] + spread[1][1] + spread[2][2];
  return {volume, origin + center, glm::dmat3(trace) - spread};
}

double Polytope::distance(const glm::dvec3& point) const {
  double best = std::numeric_limits<double>::infinity();
  bool inside = true;
  for (const Face& face : faces_) {
    if (face.plane.signedDistance(point) <= 0.0) continue;
    inside = false;
    const auto corners = loop(face);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      best = std::min(best, squaredDistanceToTriangle(point, vertices_[corners[0]], vertices_[corners[i]],
                                                      vertices_[corners[i + 1]]));
    }
  }
  return inside ? 0.0 : std::sqrt(best);
}

}  // namespace scatter::levels
