#include "lab/level_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "lab/raster.h"
#include "levels/part_geometry.h"
#include "levels/polytope.h"

namespace scatter::lab {

namespace {

constexpr double kFilled = 0.94;  // of the picture
const Color kMeshColor{0.78, 0.80, 0.83};

/// Neighbouring numbers get colours far apart: hues a golden section apart, two brightnesses.
Color colorOf(std::size_t part) {
  const double hue = std::fmod(0.58 + 0.61803398875 * static_cast<double>(part), 1.0);
  const double light = part % 2 == 0 ? 0.95 : 0.82;
  const auto channel = [&](double shift) {
    const double wave = std::abs(std::fmod(hue + shift, 1.0) * 6.0 - 3.0) - 1.0;
    return light * (0.50 + 0.50 * std::clamp(wave, 0.0, 1.0));
  };
  return {channel(0.0), channel(2.0 / 3.0), channel(1.0 / 3.0)};
}

/// A lamp over the left shoulder and some light from everywhere; back faces are lit as front ones.
Color shaded(const Color& color, const glm::dvec3& normal) {
  const glm::dvec3 lamp = glm::normalize(glm::dvec3(-0.45, -0.75, -0.6));
  const glm::dvec3 facing = normal.z > 0.0 ? -normal : normal;
  const double diffuse = std::max(0.0, glm::dot(facing, lamp));
  return color * (0.42 + 0.60 * diffuse);
}

levels::Polytope solidOf(const ConvexPart& part) {
  return levels::innerPolytope(part, 0.0, 0.0);
}

bool isRound(const ConvexPart& part) {
  return !std::holds_alternative<Box>(part.shape) && !std::holds_alternative<ConvexHull>(part.shape);
}

}  // namespace

LevelView::LevelView(const Level& level, int width, int leastHeight, int mostHeight) : width_(width) {
  const glm::dvec3 away = -glm::normalize(glm::dvec3(0.62, 0.42, 0.78));
  const glm::dvec3 right = glm::normalize(glm::cross(away, glm::dvec3(0.0, 1.0, 0.0)));
  axes_ = glm::transpose(glm::dmat3(right, glm::cross(away, right), away));
  glm::dvec3 low{std::numeric_limits<double>::infinity()};
  glm::dvec3 high = -low;
  for (const ConvexPart& part : level.parts) {
    const levels::Polytope solid = solidOf(part);
    for (const glm::dvec3& vertex : solid.vertices()) {
      low = glm::min(low, axes_ * vertex);
      high = glm::max(high, axes_ * vertex);
    }
  }
  center_ = 0.5 * (low + high);
  const glm::dvec3 size = glm::max(high - low, glm::dvec3(1e-12));
  const double wanted = width * size.y / size.x;
  height_ = static_cast<int>(std::clamp<double>(wanted, leastHeight, mostHeight));
  pixelsPerMetre_ = kFilled * std::min(width_ / size.x, height_ / size.y);
}

glm::dvec3 LevelView::toScreen(const glm::dvec3& point) const {
  const glm::dvec3 view = (axes_ * point - center_) * pixelsPerMetre_;
  return view + glm::dvec3(0.5 * width_, 0.5 * height_, 0.0);
}

std::string LevelView::render(const SurfaceMesh& mesh) const {
  Raster raster(width_, height_);
  for (const auto& triangle : mesh.triangles) {
    ScreenTriangle screen;
    for (std::size_t i = 0; i < 3; ++i) screen.corners[i] = toScreen(glm::dvec3(mesh.vertices[triangle[i]]));
    const glm::dvec3 across =
        glm::cross(screen.corners[1] - screen.corners[0], screen.corners[2] - screen.corners[0]);
    if (!(glm::length(across) > 0.0)) continue;
    screen.normal = glm::normalize(across);
    if (screen.normal.z > 0.0) screen.normal = -screen.normal;
    screen.color = shaded(kMeshColor, screen.normal);
    raster.draw(screen);
  }
  return raster.rgb();
}

std::string LevelView::render(const Level& level) const {
  Raster raster(width_, height_);
  for (std::size_t part = 0; part < level.parts.size(); ++part) {
    const levels::Polytope solid = solidOf(level.parts[part]);
    const Color color = colorOf(part);
    std::uint32_t face = 0;
    for (const levels::Polytope::Face& side : solid.faces()) {
      ScreenTriangle screen;
      screen.normal = axes_ * side.plane.normal;
      if (screen.normal.z > 0.0) continue;
      screen.color = shaded(color, screen.normal);
      screen.part = static_cast<std::uint32_t>(part);
      screen.face = isRound(level.parts[part]) ? 0 : face++;
      const auto loop = solid.loop(side);
      for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
        screen.corners[0] = toScreen(solid.vertices()[loop[0]]);
        screen.corners[1] = toScreen(solid.vertices()[loop[i]]);
        screen.corners[2] = toScreen(solid.vertices()[loop[i + 1]]);
        raster.draw(screen);
      }
    }
  }
  return raster.rgb();
}

}  // namespace scatter::lab
