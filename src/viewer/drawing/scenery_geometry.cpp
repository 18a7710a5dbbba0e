#include "viewer/drawing/scenery_geometry.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

namespace scatter::viewer {

namespace {

constexpr std::uint32_t kSegments = 32;
constexpr int kStars = 900;
constexpr float kMostGridLines = 48.0F;  // to each side
constexpr int kGridPieces = 8;           // a line fades from piece to piece

/// Heights of the sky's rings, as sines of elevation: denser near the horizon, where colours change.
constexpr float kRings[] = {-1.0F, -0.7F, -0.4F, -0.2F, -0.08F, 0.0F, 0.08F, 0.2F, 0.4F, 0.7F, 1.0F};

float skyRadius(const Camera& camera) {
  return std::sqrt(camera.near * camera.far);
}

glm::vec3 skyColor(const Scenery& scenery, float elevation) {
  const float share = std::sqrt(std::abs(elevation));
  if (elevation >= 0.0F) return glm::mix(scenery.horizon, scenery.zenith, share);
  return scenery.ground ? scenery.horizon : glm::mix(scenery.horizon, scenery.nadir, share);
}

/// Two triangles for each segment between rings of kSegments vertices each.
void joinRings(std::uint32_t lower, std::uint32_t upper, std::vector<std::uint32_t>& indices) {
  for (std::uint32_t i = 0; i < kSegments; ++i) {
    const std::uint32_t next = (i + 1) % kSegments;
    for (const std::uint32_t index :
         {lower + i, lower + next, upper + i, upper + i, lower + next, upper + next})
      indices.push_back(index);
  }
}

Vec3 around(std::uint32_t segment) {
  const float angle = glm::two_pi<float>() * static_cast<float>(segment) / static_cast<float>(kSegments);
  return {std::cos(angle), 0.0F, std::sin(angle)};
}

/// Numbers from 0 to 1, the same on every machine.
class FixedNumbers {
 public:
  float next() {
    state_ = state_ * 1664525U + 1013904223U;
    return static_cast<float>(state_ >> 8U) / 16777216.0F;
  }

 private:
  std::uint32_t state_ = 7;
};

/// A line of the grid, along `along`, in pieces that fade.
void addGridLine(const View& view, const Vec3& middle, const Vec3& along, float strength, PaintedMesh& mesh) {
  const Scenery& scenery = view.scenery;
  const float length = 2.0F * scenery.fadeRadius / static_cast<float>(kGridPieces);
  const glm::vec3 color = glm::mix(scenery.groundColor, glm::vec3(1.0F), 0.45F);
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (int i = 0; i <= kGridPieces; ++i) {
    const Vec3 place =
        middle + along * (length * (static_cast<float>(i) - 0.5F * static_cast<float>(kGridPieces)));
    mesh.vertices.push_back({place, Color(color, strength * groundShare(view, place))});
  }
  for (std::uint32_t i = 0; i < kGridPieces; ++i) {
    mesh.indices.push_back(first + i);
    mesh.indices.push_back(first + i + 1);
  }
}

}  // namespace

PaintedMesh skyDome(const View& view) {
  PaintedMesh dome;
  const float radius = skyRadius(view.camera);
  for (const float height : kRings) {
    const Color color(skyColor(view.scenery, height), 1.0F);
    const float width = std::sqrt(std::max(0.0F, 1.0F - height * height));
    for (std::uint32_t i = 0; i < kSegments; ++i)
      dome.vertices.push_back(
          {view.camera.eye + radius * (width * around(i) + Vec3(0.0F, height, 0.0F)), color});
  }
  for (std::uint32_t ring = 0; ring + 1 < std::size(kRings); ++ring)
    joinRings(ring * kSegments, (ring + 1) * kSegments, dome.indices);
  return dome;
}

PaintedMesh stars(const View& view) {
  PaintedMesh mesh;
  if (!view.scenery.stars || view.scenery.ground) return mesh;
  FixedNumbers numbers;
  const float radius = skyRadius(view.camera);
  for (std::uint32_t i = 0; i < kStars; ++i) {
    const float height = 2.0F * numbers.next() - 1.0F;
    const float angle = glm::two_pi<float>() * numbers.next();
    const float brightness = numbers.next();
    const float width = std::sqrt(1.0F - height * height);
    const Vec3 direction(width * std::cos(angle), height, width * std::sin(angle));
    mesh.vertices.push_back({view.camera.eye + radius * direction,
                             Color(0.85F, 0.9F, 1.0F, 0.3F + 0.7F * brightness * brightness)});
    mesh.indices.push_back(i);
  }
  return mesh;
}

bool groundIsSeen(const View& view) {
  return view.scenery.ground && view.camera.eye.y > *view.scenery.ground;
}

float groundShare(const View& view, const Vec3& place) {
  const glm::vec2 offset(place.x - view.camera.eye.x, place.z - view.camera.eye.z);
  return 1.0F -
         glm::smoothstep(0.25F * view.scenery.fadeRadius, view.scenery.fadeRadius, glm::length(offset));
}

PaintedMesh ground(const View& view) {
  PaintedMesh mesh;
  if (!groundIsSeen(view)) return mesh;
  const Scenery& scenery = view.scenery;
  const Vec3 foot(view.camera.eye.x, *scenery.ground, view.camera.eye.z);
  const float rings[] = {0.0F, 0.25F, 0.4F, 0.55F,
                         0.7F, 0.85F, 1.0F, std::max(1.1F, 0.9F * view.camera.far / scenery.fadeRadius)};
  for (const float ring : rings) {
    for (std::uint32_t i = 0; i < kSegments; ++i) {
      const Vec3 place = foot + ring * scenery.fadeRadius * around(i);
      const glm::vec3 color = glm::mix(scenery.horizon, scenery.groundColor, groundShare(view, place));
      mesh.vertices.push_back({place, Color(color, 1.0F)});
    }
  }
  for (std::uint32_t ring = 0; ring + 1 < std::size(rings); ++ring)
    joinRings(ring * kSegments, (ring + 1) * kSegments, mesh.indices);
  return mesh;
}

PaintedMesh groundGrid(const View& view) {
  PaintedMesh mesh;
  if (!groundIsSeen(view) || !(view.scenery.gridStep > 0.0F)) return mesh;
  float step = view.scenery.gridStep;
  while (view.scenery.fadeRadius > step * kMostGridLines) step *= 10.0F;
  const int reach = static_cast<int>(view.scenery.fadeRadius / step);
  const Vec3& eye = view.camera.eye;
  const float middleX = std::round(eye.x / step);
  const float middleZ = std::round(eye.z / step);
  const auto strength = [](float line) { return std::fmod(std::abs(line), 10.0F) < 0.5F ? 0.5F : 0.22F; };
  for (int i = -reach; i <= reach; ++i) {
    const float alongX = middleZ + static_cast<float>(i);
    const float alongZ = middleX + static_cast<float>(i);
    addGridLine(view, {eye.x, *view.scenery.ground, alongX * step}, {1.0F, 0.0F, 0.0F}, strength(alongX),
                mesh);
    addGridLine(view, {alongZ * step, *view.scenery.ground, eye.z}, {0.0F, 0.0F, 1.0F}, strength(alongZ),
                mesh);
  }
  return mesh;
}

PaintedMesh paint(const std::vector<Line>& lines) {
  PaintedMesh mesh;
  mesh.vertices.reserve(2 * lines.size());
  mesh.indices.reserve(2 * lines.size());
  for (const Line& line : lines) {
    for (const Vec3& end : {line.from, line.to}) {
      mesh.indices.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
      mesh.vertices.push_back({end, line.color});
    }
  }
  return mesh;
}

}  // namespace scatter::viewer
