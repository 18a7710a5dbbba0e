#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <optional>

#include "viewer/renderer.h"

namespace scatter::viewer {

/// From the world to the camera's axes: x right, y up, z toward the viewer.
[[nodiscard]] glm::mat4 viewMatrix(const Camera& camera);

/// From the camera's axes to OpenGL's clip space. `aspect` is width by height.
[[nodiscard]] glm::mat4 projectionMatrix(const Camera& camera, float aspect);

/// From the mesh's axes to the world.
[[nodiscard]] glm::mat4 modelMatrix(const Item& item);

/// A rectangle of pixels from the top left of the window.
struct PixelArea {
  int left = 0;
  int top = 0;
  int width = 1;   ///< At least 1.
  int height = 1;  ///< At least 1.
};

/// The pixels that belong to a view's area. Areas that share an edge leave no gap and do not overlap.
[[nodiscard]] PixelArea pixelsOf(const Area& area, const glm::ivec2& window);

/// Where a point is seen in the window, in pixels; none if it is behind the camera. It may lie outside the
/// area.
[[nodiscard]] std::optional<glm::vec2> pixelOf(const View& view, const glm::ivec2& window, const Vec3& point);

struct Ray {
  Vec3 origin{0.0F};
  Vec3 direction{0.0F, 0.0F, -1.0F};  ///< A unit vector.
};

/// What is seen at a pixel of the window lies on this ray.
[[nodiscard]] Ray rayThrough(const View& view, const glm::ivec2& window, const glm::vec2& pixel);

/// The uppermost of the views that has the pixel, as an index.
[[nodiscard]] std::optional<std::size_t> viewAt(const Picture& picture, const glm::ivec2& window,
                                                const glm::vec2& pixel);

}  // namespace scatter::viewer
