#include "viewer/mesh_occlusion.h"

#include <array>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "viewer/drawing/ray_tree.h"

namespace scatter::viewer {

namespace {

constexpr std::size_t kRays = 40;
constexpr float kReachShare = 0.4F;  // share of the diagonal
constexpr float kLift = 0.002F;      // share of the diagonal by which rays start off the surface

/// Directions around +z, as dense as a matt surface receives light from them (cosine), on a golden spiral.
std::array<Vec3, kRays> makeDirections() {
  std::array<Vec3, kRays> directions{};
  for (std::size_t i = 0; i < kRays; ++i) {
    const float share = (static_cast<float>(i) + 0.5F) / static_cast<float>(kRays);
    const float angle = glm::two_pi<float>() * 0.618034F * static_cast<float>(i);
    const float width = std::sqrt(share);
    directions[i] = {width * std::cos(angle), width * std::sin(angle), std::sqrt(1.0F - share)};
  }
  return directions;
}

/// Axes with `normal` as the third.
Mat3 axesAround(const Vec3& normal) {
  const Vec3 other = std::abs(normal.y) < 0.9F ? Vec3(0.0F, 1.0F, 0.0F) : Vec3(1.0F, 0.0F, 0.0F);
  const Vec3 first = glm::normalize(glm::cross(other, normal));
  return {first, glm::cross(normal, first), normal};
}

float diagonalOf(const MeshData& mesh) {
  if (mesh.positions.empty()) return 0.0F;
  Bounds bounds{mesh.positions.front(), mesh.positions.front()};
  for (const Vec3& position : mesh.positions) {
    bounds.min = glm::min(bounds.min, position);
    bounds.max = glm::max(bounds.max, position);
  }
  return glm::length(bounds.max - bounds.min);
}

}  // namespace

std::vector<float> bakeOcclusion(const MeshData& mesh) {
  assert(mesh.normals.size() == mesh.positions.size());
  const RayTree tree(mesh);
  const auto directions = makeDirections();
  const float diagonal = diagonalOf(mesh);
  const float reach = kReachShare * diagonal;
  std::vector<float> occlusion;
  occlusion.reserve(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Mat3 axes = axesAround(mesh.normals[i]);
    const Vec3 origin = mesh.positions[i] + kLift * diagonal * mesh.normals[i];
    float blocked = 0.0F;
    for (const Vec3& direction : directions) {
      // What is near blocks more than what is far: no hard step at the reach.
      if (reach > 0.0F) blocked += 1.0F - tree.nearestHit(origin, axes * direction, reach) / reach;
    }
    occlusion.push_back(blocked / static_cast<float>(kRays));
  }
  return occlusion;
}

}  // namespace scatter::viewer
