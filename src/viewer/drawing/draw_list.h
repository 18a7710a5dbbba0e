#pragma once

#include <cstddef>
#include <glm/mat4x4.hpp>
#include <vector>

#include "viewer/drawing/mesh_lod.h"
#include "viewer/drawing/projection.h"
#include "viewer/renderer.h"

namespace scatter::viewer {

/// An item that is seen, at the detail to draw it with.
struct DrawCall {
  const Item* item = nullptr;
  std::size_t detail = 0;
  float distance = 0.0F;  ///< Metres from the eye.
  glm::mat4 model{1.0F};
};

/// A shadow on the ground: an item made flat, in one colour that lets nothing through, so that shadows that
/// overlap are no darker.
struct ShadowCall {
  const Item* item = nullptr;
  std::size_t detail = 0;
  glm::vec3 color{0.0F};
  glm::mat4 model{1.0F};
};

/// What to draw of a view, in this order.
struct DrawList {
  std::vector<DrawCall> floors{};
  std::vector<ShadowCall> shadows{};
  std::vector<DrawCall> solid{};       ///< Nearest first.
  std::vector<DrawCall> seeThrough{};  ///< Farthest first.
  std::size_t culled = 0;
};

struct ItemBall {
  Vec3 center{0.0F};
  float radius = 0.0F;
};

/// What an item fits into, in the world.
[[nodiscard]] ItemBall ballAround(const Item& item, const MeshOutline& outline);

[[nodiscard]] bool throwsShadow(const Item& item);

/// The coarsest detail of an item's mesh that differs by no more than an error, in units of which so many
/// make a metre.
[[nodiscard]] std::size_t detailFor(const Item& item, const MeshOutline& outline, float unitsPerMetre,
                                    float error);

/// A mesh's outline, which stays where it is.
using OutlineOf = std::function<const MeshOutline&(MeshId)>;

[[nodiscard]] DrawList listDraws(const View& view, const PixelArea& pixels, const OutlineOf& outlineOf);

/// Adds a view's part to the frame's statistics.
void count(const View& view, const DrawList& list, const OutlineOf& outlineOf, DrawStatistics& statistics);

}  // namespace scatter::viewer
