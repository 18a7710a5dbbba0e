#include "viewer/drawing/projection.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace scatter::viewer {

namespace {

float aspectOf(const PixelArea& pixels) {
  return static_cast<float>(pixels.width) / static_cast<float>(pixels.height);
}

}  // namespace

glm::mat4 viewMatrix(const Camera& camera) {
  return glm::lookAtRH(camera.eye, camera.target, camera.up);
}

glm::mat4 projectionMatrix(const Camera& camera, float aspect) {
  return glm::perspectiveRH_NO(camera.fieldOfView, aspect, camera.near, camera.far);
}

glm::mat4 modelMatrix(const Item& item) {
  const glm::mat3 turned = glm::mat3_cast(item.pose.rotation);
  return {glm::vec4(turned[0] * item.scale.x, 0.0F), glm::vec4(turned[1] * item.scale.y, 0.0F),
          glm::vec4(turned[2] * item.scale.z, 0.0F), glm::vec4(item.pose.position, 1.0F)};
}

PixelArea pixelsOf(const Area& area, const glm::ivec2& window) {
  const auto edge = [](float share, int length) {
    return static_cast<int>(std::lround(share * static_cast<float>(length)));
  };
  PixelArea pixels;
  pixels.left = edge(area.left, window.x);
  pixels.top = edge(area.top, window.y);
  pixels.width = std::max(1, edge(area.left + area.width, window.x) - pixels.left);
  pixels.height = std::max(1, edge(area.top + area.height, window.y) - pixels.top);
  return pixels;
}

std::optional<glm::vec2> pixelOf(const View& view, const glm::ivec2& window, const Vec3& point) {
  const PixelArea pixels = pixelsOf(view.area, window);
  const glm::vec4 clip =
      projectionMatrix(view.camera, aspectOf(pixels)) * viewMatrix(view.camera) * glm::vec4(point, 1.0F);
  if (clip.w <= 0.0F) return std::nullopt;
  return glm::vec2(
      static_cast<float>(pixels.left) + (0.5F + 0.5F * clip.x / clip.w) * static_cast<float>(pixels.width),
      static_cast<float>(pixels.top) + (0.5F - 0.5F * clip.y / clip.w) * static_cast<float>(pixels.height));
}

Ray rayThrough(const View& view, const glm::ivec2& window, const glm::vec2& pixel) {
  const PixelArea pixels = pixelsOf(view.area, window);
  const float tall = std::tan(0.5F * view.camera.fieldOfView);
  const float right =
      2.0F * (pixel.x - static_cast<float>(pixels.left)) / static_cast<float>(pixels.width) - 1.0F;
  const float up =
      1.0F - 2.0F * (pixel.y - static_cast<float>(pixels.top)) / static_cast<float>(pixels.height);
  const Vec3 inCamera(right * tall * aspectOf(pixels), up * tall, -1.0F);
  const glm::mat3 toWorld = glm::transpose(glm::mat3(viewMatrix(view.camera)));
  return {view.camera.eye, glm::normalize(toWorld * inCamera)};
}

std::optional<std::size_t> viewAt(const Picture& picture, const glm::ivec2& window, const glm::vec2& pixel) {
  for (std::size_t i = picture.views.size(); i-- > 0;) {
    const PixelArea pixels = pixelsOf(picture.views[i].area, window);
    const float x = pixel.x - static_cast<float>(pixels.left);
    const float y = pixel.y - static_cast<float>(pixels.top);
    if (x >= 0.0F && y >= 0.0F && x < static_cast<float>(pixels.width) &&
        y < static_cast<float>(pixels.height))
      return i;
  }
  return std::nullopt;
}

}  // namespace scatter::viewer
