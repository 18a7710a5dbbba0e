#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "viewer/renderer.h"

namespace scatter::viewer {

struct PaintedVertex {
  Vec3 position{0.0F};
  Color color{1.0F};
};

/// Triangles, lines or points in their own colours, not lit: one, two or three indices each.
struct PaintedMesh {
  std::vector<PaintedVertex> vertices{};
  std::vector<std::uint32_t> indices{};
};

inline constexpr float kStarPixels = 2.0F;

/// Triangles around the camera, seen from inside, between its near and far distance: the sky's gradient.
[[nodiscard]] PaintedMesh skyDome(const View& view);

/// Points in the sky, always the same ones. None if the scenery has no stars or has a ground.
[[nodiscard]] PaintedMesh stars(const View& view);

/// Whether there is a ground and the camera is above it.
[[nodiscard]] bool groundIsSeen(const View& view);

/// How much of the ground's own colour is left at a place on it: 1 near the camera, 0 in the haze.
[[nodiscard]] float groundShare(const View& view, const Vec3& place);

/// Triangles of the ground, which fades to the horizon's colour. Only if it is seen.
[[nodiscard]] PaintedMesh ground(const View& view);

/// Lines on the ground, every tenth only (or hundredth) if they would be too many.
[[nodiscard]] PaintedMesh groundGrid(const View& view);

/// Lines as given.
[[nodiscard]] PaintedMesh paint(const std::vector<Line>& lines);

}  // namespace scatter::viewer
