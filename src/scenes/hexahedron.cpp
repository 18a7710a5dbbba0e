#include "scenes/hexahedron.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace scatter {
namespace {

/// The ends of the edges at which corner `i` lies, each 0 or 1.
Vec3 signs(std::size_t i) {
  return {static_cast<float>(i & 1U), static_cast<float>((i >> 1U) & 1U), static_cast<float>((i >> 2U) & 1U)};
}

}  // namespace

Hexahedron Hexahedron::box(const Vec3& low, const Vec3& high) {
  std::array<Vec3, 8> corners{};
  for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = glm::mix(low, high, signs(i));
  return Hexahedron(corners);
}

Vec3 Hexahedron::at(const Vec3& share) const {
  const auto along = [&](std::size_t i) { return glm::mix(corners_[i], corners_[i + 1], share.x); };
  const Vec3 near = glm::mix(along(0), along(2), share.y);
  const Vec3 far = glm::mix(along(4), along(6), share.y);
  return glm::mix(near, far, share.z);
}

Hexahedron Hexahedron::cut(const Share& share) const {
  std::array<Vec3, 8> corners{};
  for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = at(glm::mix(share.from, share.to, signs(i)));
  return Hexahedron(corners);
}

float Hexahedron::shortestEdge(int axis) const {
  const std::size_t step = std::size_t{1} << static_cast<unsigned>(axis);
  float shortest = std::numeric_limits<float>::max();
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    if ((i & step) == 0) shortest = std::min(shortest, glm::length(corners_[i + step] - corners_[i]));
  }
  return shortest;
}

Hexahedron Hexahedron::shrunk(float inset) const {
  constexpr float kSlant = 1.35F;  // 1 / sin(50°), and a little
  const Vec3 edges(shortestEdge(0), shortestEdge(1), shortestEdge(2));
  const Vec3 share = kSlant * inset / edges;
  assert(std::max({share.x, share.y, share.z}) < 0.5F);
  return cut({share, Vec3(1.0F) - share});
}

ConvexPart Hexahedron::boxPart() const {
  const Vec3& low = corners_.front();
  const Vec3& high = corners_.back();
  return {.shape = Box{0.5F * (high - low)}, .pose = {0.5F * (low + high), kNoRotation}};
}

ConvexPart Hexahedron::part() const {
  return {.shape = ConvexHull{{corners_.begin(), corners_.end()}}, .pose = {}};
}

}  // namespace scatter
