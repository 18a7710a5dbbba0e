#include "viewer/drawing/draw_list.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

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

std::size_t detailFor(const MeshOutline& outline, float scale, float pixelsPerMetre, float errorPixels) {
  std::size_t detail = 0;
  while (detail + 1 < outline.errors.size() &&
         outline.errors[detail + 1] * scale * pixelsPerMetre <= errorPixels)
    ++detail;
  return detail;
}

/// Flattens the world onto the ground along the light's rays.
glm::mat4 flattening(const Vec3& toLight, float height) {
  glm::mat4 flat(1.0F);
  flat[1] = glm::vec4(-toLight.x / toLight.y, 0.0F, -toLight.z / toLight.y, 0.0F);
  flat[3] = glm::vec4(height * toLight.x / toLight.y, height, height * toLight.z / toLight.y, 1.0F);
  return flat;
}

class Lister {
 public:
  Lister(const View& view, const PixelArea& pixels)
      : view_(view),
        frustum_(view.camera, static_cast<float>(pixels.width) / static_cast<float>(pixels.height)),
        pixelsAtOneMetre_(0.5F * static_cast<float>(pixels.height) /
                          std::tan(0.5F * view.camera.fieldOfView)),
        castsShadows_(groundIsSeen(view) &&
                      view.scenery.toLight.y > 0.2F * glm::length(view.scenery.toLight)) {
    if (castsShadows_) flatten_ = flattening(view.scenery.toLight, *view.scenery.ground);
  }

  void add(const Item& item, const MeshOutline& outline, DrawList& list) const {
    const float scale = std::max({std::abs(item.scale.x), std::abs(item.scale.y), std::abs(item.scale.z)});
    const Vec3 center = item.pose(item.scale * outline.center);
    const float radius = scale * outline.radius;
    const float distance = glm::distance(center, view_.camera.eye);
    const float pixelsPerMetre = pixelsAtOneMetre_ / std::max(distance - radius, view_.camera.near);
    const glm::mat4 model = modelMatrix(item);
    const bool isSolid = item.color.a >= 1.0F;
    if (castsShadows_ && isSolid && !item.wireframe) {
      const std::size_t detail = detailFor(outline, scale, pixelsPerMetre, kShadowErrorPixels);
      addShadow({&item, detail, Vec3(0.0F), model}, center, radius, list);
    }
    if (!frustum_.sees(center, radius)) {
      ++list.culled;
      return;
    }
    const std::size_t detail = detailFor(outline, scale, pixelsPerMetre, kErrorPixels);
    (isSolid ? list.solid : list.seeThrough).push_back({&item, detail, distance, model});
  }

 private:
  void addShadow(ShadowCall call, const Vec3& center, float radius, DrawList& list) const {
    const float height = *view_.scenery.ground;
    if (center.y + radius < height) return;
    const Vec3 spot(flatten_ * glm::vec4(center, 1.0F));
    const Vec3& light = view_.scenery.toLight;
    const float reach = radius * glm::length(light) / light.y;
    const float share = groundShare(view_, spot);
    if (share < 0.02F || !frustum_.sees(spot, reach)) return;
    call.color = glm::mix(view_.scenery.horizon, 0.5F * view_.scenery.groundColor, share);
    call.model = flatten_ * call.model;
    list.shadows.push_back(call);
  }

  const View& view_;
  Frustum frustum_;
  float pixelsAtOneMetre_;
  bool castsShadows_;
  glm::mat4 flatten_{1.0F};
};

}  // namespace

DrawList listDraws(const View& view, const PixelArea& pixels,
                   const std::function<const MeshOutline&(MeshId)>& outlineOf) {
  DrawList list;
  const Lister lister(view, pixels);
  for (const Item& item : view.items) lister.add(item, outlineOf(item.mesh), list);
  // Stable, so that items at the same distance do not change places from frame to frame.
  std::stable_sort(list.solid.begin(), list.solid.end(),
                   [](const DrawCall& a, const DrawCall& b) { return a.distance < b.distance; });
  std::stable_sort(list.seeThrough.begin(), list.seeThrough.end(),
                   [](const DrawCall& a, const DrawCall& b) { return a.distance > b.distance; });
  return list;
}

void count(const View& view, const DrawList& list, const std::function<const MeshOutline&(MeshId)>& outlineOf,
           DrawStatistics& statistics) {
  statistics.items += list.solid.size() + list.seeThrough.size();
  statistics.culled += list.culled;
  statistics.shadows += list.shadows.size();
  statistics.lines += view.lines.size() + view.linesOnTop.size();
  for (const auto* calls : {&list.solid, &list.seeThrough}) {
    for (const DrawCall& call : *calls)
      statistics.triangles += outlineOf(call.item->mesh).triangles[call.detail];
  }
}

}  // namespace scatter::viewer
