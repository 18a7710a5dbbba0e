#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <vector>

#include "viewer/drawing/draw_list.h"

namespace scatter::viewer {

/// What the light meets first: the depths of all items of a view that throw shadows, seen from the light. The
/// processor draws it, so that all renderers have the same shadows. Of closed meshes it has the sides away
/// from the light: what lies on the light's side of them is lit whatever its distance from texel to texel,
/// and the side that would be speckled is dark anyway.
class ShadowMap {
 public:
  static constexpr int kSize = 1024;  ///< Texels to a side.

  /// Of the part of the view where items can lie in shadows. False if there is none; then the map is not to
  /// be used.
  [[nodiscard]] bool draw(const View& view, const PixelArea& pixels, const DrawList& list,
                          const OutlineOf& outlineOf);

  /// Depths away from the light, 0 to 0xffffff where there is nothing, row by row from y 0. The texels at the
  /// edges are empty.
  [[nodiscard]] const std::vector<std::uint32_t>& texels() const { return texels_; }

  /// From the world to the map: x and y in shares of its sides, z as a share of 0xffffff.
  [[nodiscard]] const glm::mat4& fromWorld() const { return fromWorld_; }

  /// Metres off its surface at which an item's light is looked up.
  [[nodiscard]] float lift() const { return lift_; }

 private:
  /// `region` is in axes of which z points to the light; `turn` leads there.
  void fit(const Bounds& region, const glm::mat3& turn);

  /// Metres by which what throws the shadows may differ from the items, so that there are not too many
  /// triangles.
  [[nodiscard]] float errorFor(const View& view, const OutlineOf& outlineOf) const;
  void cast(const Item& item, const MeshOutline& outline, float error);

  /// `area` is twice the triangle's, negative if it is seen from behind.
  void fill(const Vec3& a, const Vec3& b, const Vec3& c, float area);

  std::vector<std::uint32_t> texels_;
  glm::mat4 fromWorld_{1.0F};
  float texel_ = 1.0F;  ///< Metres of the shorter side.
  float lift_ = 0.0F;
  std::vector<Vec3> corners_;  ///< Of the mesh that is drawn, x and y in texels; kept to save allocations.
};

}  // namespace scatter::viewer
