#include "viewer/drawing/draw_list.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>

#include "viewer/drawing/scenery_geometry.h"

namespace scatter::viewer {

namespace {

/// Details may differ from the mesh by this much on the screen.
constexpr float kErrorPixels = 2.0F;

/// Shadows have no shading that shows detail.
constexpr float kShadowErrorPixels = 4.0F;

/// The four sides of what a camera sees, as planes through the eye whose normals point inside.
class Frustum {
 public:
  Frustum(const Camera& camera, float aspect) : eye_(camera.eye), near_(camera.near), far_(camera.far) {
    const glm::mat3 toWorld = glm::transpose(glm::mat3(viewMatrix(camera)));
    const float tall = std::tan(0.5F * camera.fieldOfView);
    const float wide = tall * aspect;
    forward_ = -toWorld[2];
    sides_ = {glm::normalize(toWorld * Vec3(1.0F, 0.0F, -wide)),
              glm::normalize(toWorld * Vec3(-1.0F, 0.0F, -wide)),
              glm::normalize(toWorld * Vec3(0.0F, 1.0F, -tall)),
              glm::normalize(toWorld * Vec3(0.0F, -1.0F, -tall))};
  }

  [[nodiscard]] bool sees(const Vec3& center, float radius) const {
    const Vec3 offset = center - eye_;
    const float depth = glm::dot(forward_, offset);
    if (depth < near_ - radius || depth > far_ + radius) return false;
    return std::all_of(sides_.begin(), sides_.end(),
                       [&](const Vec3& side) { return glm::dot(side, offset) >= -radius; });
  }

 private:
  Vec3 eye_;
  Vec3 forward_{0.0F};
  float near_;
  float far_;
  std::array<Vec3, 4> sides_{};
};

float largestScale(const Item& item) {
  return std::max({std::abs(item.scale.x), std::abs(item.scale.y), std::abs(item.scale.z)});
}

/// Flattens the world onto the ground along the light's rays.
glm::mat4 flattening(const Vec3& toLight, float height) {
  glm::mat4 flat(1.0F);
  flat[1] = glm::vec4(-toLight.x / toLight.y, 0.0F, -toLight.z / toLight.y, 0.0F);
  flat[3] = glm::vec4(height * toLight.x / toLight.y, height, height * toLight.z / toLight.y, 1.0F);
  return flat;
}

/// Where shadows fall: on the ground, or on a floor.
struct ShadowPlane {
  float height = 0.0F;
  glm::vec3 color{0.0F};         ///< Of what lies in the shadow.
  std::optional<Bounds> edge{};  ///< Of a floor; shadows do not fall beyond it.
};

/// Lit by the sky alone.
glm::vec3 shaded(const Color& color) {
  return 0.42F * glm::vec3(color);
}

/// The uppermost side of a floor.
ShadowPlane planeOf(const Item& floor, const MeshOutline& outline) {
  const Vec3 center = floor.pose(floor.scale * outline.center);
  const glm::mat3 turn = glm::mat3_cast(floor.pose.rotation);
  const Vec3& half = floor.scale;
  const Vec3 reach = half.x * glm::abs(turn[0]) + half.y * glm::abs(turn[1]) + half.z * glm::abs(turn[2]);
  return {center.y + reach.y, shaded(floor.color), Bounds{center - reach, center + reach}};
}

class Lister {
 public:
  Lister(const View& view, const PixelArea& pixels)
      : view_(view),
        frustum_(view.camera, static_cast<float>(pixels.width) / static_cast<float>(pixels.height)),
        pixelsAtOneMetre_(0.5F * static_cast<float>(pixels.height) /
                          std::tan(0.5F * view.camera.fieldOfView)),
        lightIsHigh_(view.scenery.toLight.y > 0.2F * glm::length(view.scenery.toLight)) {
    if (groundIsSeen(view)) castOn({*view.scenery.ground, 0.5F * view.scenery.groundColor, std::nullopt});
  }

  /// Lets shadows fall on a floor if there is no ground.
  void addFloor(const Item& floor, const MeshOutline& outline) {
    const ShadowPlane plane = planeOf(floor, outline);
    if (!view_.scenery.ground && view_.camera.eye.y > plane.height) castOn(plane);
  }

  void add(const Item& item, const MeshOutline& outline, DrawList& list) const {
    const auto [center, radius] = ballAround(item, outline);
    const float distance = glm::distance(center, view_.camera.eye);
    const float pixelsPerMetre = pixelsAtOneMetre_ / std::max(distance - radius, view_.camera.near);
    const glm::mat4 model = modelMatrix(item);
    const bool isSolid = item.color.a >= 1.0F;
    if (plane_ && throwsShadow(item)) {
      const std::size_t detail = detailFor(item, outline, pixelsPerMetre, kShadowErrorPixels);
      addShadow({&item, detail, Vec3(0.0F), model}, center, radius, list);
    }
    if (!frustum_.sees(center, radius)) {
      ++list.culled;
      return;
    }
    const std::size_t detail = detailFor(item, outline, pixelsPerMetre, kErrorPixels);
    std::vector<DrawCall>& calls = !isSolid ? list.seeThrough : item.isFloor ? list.floors : list.solid;
    calls.push_back({&item, detail, distance, model});
  }

 private:
  void castOn(const ShadowPlane& plane) {
    if (!lightIsHigh_ || view_.scenery.shadows == Shadows::kNothing) return;
    plane_ = plane;
    flatten_ = flattening(view_.scenery.toLight, plane.height);
  }

  /// Of the colour that the light has left there; none where a shadow is not seen.
  [[nodiscard]] std::optional<glm::vec3> shadowColor(const Vec3& spot) const {
    if (plane_->edge) {
      const Bounds& edge = *plane_->edge;
      const bool falls =
          spot.x > edge.min.x && spot.x < edge.max.x && spot.z > edge.min.z && spot.z < edge.max.z;
      return falls ? std::optional(plane_->color) : std::nullopt;
    }
    const float share = groundShare(view_, spot);
    if (share < 0.02F) return std::nullopt;
    return glm::mix(view_.scenery.horizon, plane_->color, share);
  }

  void addShadow(ShadowCall call, const Vec3& center, float radius, DrawList& list) const {
    if (center.y + radius < plane_->height) return;
    const Vec3 spot(flatten_ * glm::vec4(center, 1.0F));
    const Vec3& light = view_.scenery.toLight;
    const float reach = radius * glm::length(light) / light.y;
    const auto color = shadowColor(spot);
    if (!color || !frustum_.sees(spot, reach)) return;
    call.color = *color;
    call.model = flatten_ * call.model;
    list.shadows.push_back(call);
  }

  const View& view_;
  Frustum frustum_;
  float pixelsAtOneMetre_;
  bool lightIsHigh_;
  std::optional<ShadowPlane> plane_;
  glm::mat4 flatten_{1.0F};
};

}  // namespace

ItemBall ballAround(const Item& item, const MeshOutline& outline) {
  return {item.pose(item.scale * outline.center), largestScale(item) * outline.radius};
}

bool throwsShadow(const Item& item) {
  return item.castsShadow && item.color.a >= 1.0F && !item.wireframe && !item.isFloor;
}

std::size_t detailFor(const Item& item, const MeshOutline& outline, float unitsPerMetre, float error) {
  const float units = largestScale(item) * unitsPerMetre;
  std::size_t detail = 0;
  while (detail + 1 < outline.errors.size() && outline.errors[detail + 1] * units <= error) ++detail;
  return detail;
}

DrawList listDraws(const View& view, const PixelArea& pixels, const OutlineOf& outlineOf) {
  DrawList list;
  Lister lister(view, pixels);
  for (const Item& item : view.items) {
    if (item.isFloor) lister.addFloor(item, outlineOf(item.mesh));
  }
  for (const Item& item : view.items) lister.add(item, outlineOf(item.mesh), list);
  // Stable, so that items at the same distance do not change places from frame to frame.
  std::stable_sort(list.solid.begin(), list.solid.end(),
                   [](const DrawCall& a, const DrawCall& b) { return a.distance < b.distance; });
  std::stable_sort(list.seeThrough.begin(), list.seeThrough.end(),
                   [](const DrawCall& a, const DrawCall& b) { return a.distance > b.distance; });
  return list;
}

void count(const View& view, const DrawList& list, const OutlineOf& outlineOf, DrawStatistics& statistics) {
  statistics.items += list.floors.size() + list.solid.size() + list.seeThrough.size();
  statistics.culled += list.culled;
  statistics.shadows += list.shadows.size();
  statistics.lines += view.lines.size() + view.linesOnTop.size();
  for (const auto* calls : {&list.floors, &list.solid, &list.seeThrough}) {
    for (const DrawCall& call : *calls)
      statistics.triangles += outlineOf(call.item->mesh).triangles[call.detail];
  }
}

}  // namespace scatter::viewer
