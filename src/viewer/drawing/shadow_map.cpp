#include "viewer/drawing/shadow_map.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <optional>
#include <utility>

namespace scatter::viewer {

namespace {

constexpr std::uint32_t kEmpty = 0xffffffU;
constexpr float kDeepest = 0.998F;                  // as a share of kEmpty, for items
constexpr float kMargin = 2.0F;                     // texels around what is seen
constexpr float kErrorTexels = 2.0F;                // by which a detail's outline may differ,
constexpr float kMostErrorTexels = 16.0F;           // or this if there are very many triangles
constexpr std::size_t kMostCastTriangles = 40'000;  // take a few milliseconds
constexpr float kSeenPixels = 2.0F;                 // radius of the smallest item that takes shadows
constexpr float kLiftTexels = 1.5F;

/// The world's axes turned so that z points to the light.
glm::mat3 turnToLight(const Vec3& toLight) {
  const Vec3 z = glm::normalize(toLight);
  const Vec3 x =
      glm::normalize(glm::cross(std::abs(z.y) < 0.9F ? Vec3(0.0F, 1.0F, 0.0F) : Vec3(1.0F, 0.0F, 0.0F), z));
  return glm::transpose(glm::mat3(x, glm::cross(z, x), z));
}

/// A length of at least this, of a few that there are: what is seen then stays where it is in the map while
/// the length does.
float roundUp(float length) {
  return std::exp2(std::ceil(4.0F * std::log2(std::max(length, 1e-6F))) / 4.0F);
}

Bounds nothing() {
  constexpr float kFar = std::numeric_limits<float>::max();
  return {Vec3(kFar), Vec3(-kFar)};
}

void include(const Vec3& place, float radius, Bounds& bounds) {
  bounds.min = glm::min(bounds.min, place - radius);
  bounds.max = glm::max(bounds.max, place + radius);
}

/// What the camera sees up to a distance.
Bounds seen(const View& view, const PixelArea& pixels, float distance, const glm::mat3& turn) {
  const Camera& camera = view.camera;
  const float tall = distance * std::tan(0.5F * camera.fieldOfView);
  const float wide = tall * static_cast<float>(pixels.width) / static_cast<float>(pixels.height);
  const glm::mat3 toWorld = glm::transpose(glm::mat3(viewMatrix(camera)));
  Bounds bounds = nothing();
  include(turn * camera.eye, 0.0F, bounds);
  for (const float x : {-wide, wide}) {
    for (const float y : {-tall, tall})
      include(turn * (camera.eye + toWorld * Vec3(x, y, -distance)), 0.0F, bounds);
  }
  return bounds;
}

/// A triangle's edge, from row to row.
class Edge {
 public:
  Edge(const Vec3& low, const Vec3& high)
      : slope_((high.x - low.x) / (high.y - low.y)), atZero_(low.x - slope_ * low.y) {}

  [[nodiscard]] float at(float y) const { return atZero_ + slope_ * y; }

 private:
  float slope_;
  float atZero_;
};

/// The first row or column whose middle is behind a place, within the map's edges.
int firstBehind(float place) {
  return static_cast<int>(std::max(1.5F, std::min(ShadowMap::kSize - 0.5F, place + 0.5F)));
}

/// Where items both throw and take shadows, as far as it is seen, in axes of which z points to the light.
/// None if they do so nowhere.
std::optional<Bounds> shadedRegion(const View& view, const PixelArea& pixels, const DrawList& list,
                                   const OutlineOf& outlineOf, const glm::mat3& turn) {
  Bounds casters = nothing();
  for (const Item& item : view.items) {
    if (!throwsShadow(item)) continue;
    const ItemBall ball = ballAround(item, outlineOf(item.mesh));
    include(turn * ball.center, ball.radius, casters);
  }
  const float pixelsAtOneMetre =
      static_cast<float>(pixels.height) / (2.0F * std::tan(0.5F * view.camera.fieldOfView));
  Bounds takers = nothing();
  float deepest = casters.max.z;
  float farthest = view.camera.near;
  for (const DrawCall& call : list.solid) {
    const ItemBall ball = ballAround(*call.item, outlineOf(call.item->mesh));
    const Vec3 center = turn * ball.center;
    deepest = std::min(deepest, center.z - ball.radius);
    if (ball.radius * pixelsAtOneMetre < kSeenPixels * call.distance) continue;
    include(center, ball.radius, takers);
    farthest = std::max(farthest, call.distance + ball.radius);
  }
  const Bounds sight = seen(view, pixels, std::min(farthest, view.camera.far), turn);
  Bounds region{glm::max(glm::max(casters.min, takers.min), sight.min),
                glm::min(glm::min(casters.max, takers.max), sight.max)};
  if (!(region.min.x < region.max.x && region.min.y < region.max.y)) return std::nullopt;
  region.min.z = deepest;
  region.max.z = casters.max.z;
  return region;
}

}  // namespace

bool ShadowMap::draw(const View& view, const PixelArea& pixels, const DrawList& list,
                     const OutlineOf& outlineOf) {
  if (view.scenery.shadows != Shadows::kEverything) return false;
  const glm::mat3 turn = turnToLight(view.scenery.toLight);
  const auto region = shadedRegion(view, pixels, list, outlineOf, turn);
  if (!region) return false;
  fit(*region, turn);
  const float error = errorFor(view, outlineOf);
  for (const Item& item : view.items) {
    if (throwsShadow(item)) cast(item, outlineOf(item.mesh), error);
  }
  return true;
}

float ShadowMap::errorFor(const View& view, const OutlineOf& outlineOf) const {
  float error = kErrorTexels * texel_;
  for (; error < kMostErrorTexels * texel_; error *= 2.0F) {
    std::size_t triangles = 0;
    for (const Item& item : view.items) {
      const MeshOutline& outline = outlineOf(item.mesh);
      if (throwsShadow(item)) triangles += outline.triangles[detailFor(item, outline, 1.0F, error)];
    }
    if (triangles <= kMostCastTriangles) break;
  }
  return error;
}

void ShadowMap::fit(const Bounds& region, const glm::mat3& turn) {
  const glm::vec2 extent = glm::vec2(region.max - region.min) / (kSize - 2.0F * kMargin - 1.0F);
  const glm::vec2 texel(roundUp(extent.x), roundUp(extent.y));
  // Whole texels, so that what stands still does not swim in the map.
  const glm::vec2 corner = (glm::floor(glm::vec2(region.min) / texel) - kMargin) * texel;
  const Vec3 scale(1.0F / (static_cast<float>(kSize) * texel),
                   -kDeepest / std::max(region.max.z - region.min.z, 1e-6F));
  const Vec3 from(corner, region.max.z);
  for (int i = 0; i < 3; ++i) fromWorld_[i] = glm::vec4(scale * turn[i], 0.0F);
  fromWorld_[3] = glm::vec4(-scale * from, 1.0F);
  texel_ = std::min(texel.x, texel.y);
  lift_ = kLiftTexels * std::max(texel.x, texel.y);
  texels_.assign(static_cast<std::size_t>(kSize) * kSize, kEmpty);
}

void ShadowMap::cast(const Item& item, const MeshOutline& outline, float error) {
  const ShadowMesh& mesh = outline.shadows[detailFor(item, outline, 1.0F, error)];
  const ItemBall ball = ballAround(item, outline);
  const Vec3 center(fromWorld_ * glm::vec4(ball.center, 1.0F));
  const glm::vec2 reach = ball.radius * glm::vec2(glm::length(glm::vec3(glm::row(fromWorld_, 0))),
                                                  glm::length(glm::vec3(glm::row(fromWorld_, 1))));
  if (glm::any(glm::greaterThan(glm::abs(glm::vec2(center) - 0.5F), 0.5F + reach))) return;
  const glm::mat4 toTexels =
      glm::scale(glm::mat4(1.0F), Vec3(kSize, kSize, kEmpty)) * fromWorld_ * modelMatrix(item);
  corners_.clear();
  for (const Vec3& position : mesh.positions) {
    Vec3& corner = corners_.emplace_back(toTexels * glm::vec4(position, 1.0F));
    // What is so deep that nothing is seen there needs no depth of its own.
    corner.z = std::max(0.0F, std::min(corner.z, kEmpty - 1.0F));
  }
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Vec3& a = corners_[mesh.indices[i]];
    const Vec3& b = corners_[mesh.indices[i + 1]];
    const Vec3& c = corners_[mesh.indices[i + 2]];
    const float area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    if (area < 0.0F || (mesh.twoSided && area > 0.0F)) fill(a, b, c, area);
  }
}

void ShadowMap::fill(const Vec3& a, const Vec3& b, const Vec3& c, float area) {
  const Vec3* low = &a;
  const Vec3* middle = &b;
  const Vec3* high = &c;
  if (low->y > middle->y) std::swap(low, middle);
  if (middle->y > high->y) std::swap(middle, high);
  if (low->y > middle->y) std::swap(low, middle);
  const int firstRow = firstBehind(low->y);
  const int lastRow = firstBehind(high->y);
  // Most triangles are smaller than a texel, and lie between the middles of two.
  if (firstRow == lastRow) return;
  const float alongX = ((b.z - a.z) * (c.y - a.y) - (c.z - a.z) * (b.y - a.y)) / area;
  const float alongY = ((c.z - a.z) * (b.x - a.x) - (b.z - a.z) * (c.x - a.x)) / area;
  // A triangle that is seen from the side is so steep that rounding could lead far beyond it.
  const float nearest = std::min({a.z, b.z, c.z});
  const float farthest = std::max({a.z, b.z, c.z});
  const Edge one(*low, *high);
  const Edge lower(*low, *middle);
  const Edge upper(*middle, *high);
  for (int row = firstRow; row < lastRow; ++row) {
    const float y = static_cast<float>(row) + 0.5F;
    const float other = (y < middle->y ? lower : upper).at(y);
    const int first = firstBehind(std::min(one.at(y), other));
    const int last = firstBehind(std::max(one.at(y), other));
    float depth = a.z + alongX * (static_cast<float>(first) + 0.5F - a.x) + alongY * (y - a.y);
    std::uint32_t* texels = &texels_[static_cast<std::size_t>(row) * kSize];
    for (int column = first; column < last; ++column, depth += alongX) {
      const auto found = static_cast<std::uint32_t>(std::max(nearest, std::min(farthest, depth)));
      texels[column] = std::min(texels[column], found);
    }
  }
}

}  // namespace scatter::viewer
