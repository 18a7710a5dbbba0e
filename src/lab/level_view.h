#pragma once

#include <scatter/levels/level_set.h>
#include <scatter/levels/surface_mesh.h>

#include <glm/mat3x3.hpp>
#include <string>

namespace scatter::lab {

/// Looks at a model from its front, right and above, without perspective.
class LevelView {
 public:
  /// All of `level` fits into the picture, whose height follows from it, within limits. Pixels.
  LevelView(const Level& level, int width, int leastHeight, int mostHeight);

  [[nodiscard]] int height() const { return height_; }

  /// The pictures, three bytes a pixel.
  [[nodiscard]] std::string render(const SurfaceMesh& mesh) const;
  [[nodiscard]] std::string render(const Level& level) const;

 private:
  [[nodiscard]] glm::dvec3 toScreen(const glm::dvec3& point) const;

  int width_;
  int height_ = 0;
  glm::dmat3 axes_{1.0};  ///< Rows: right, down, away from the eye.
  glm::dvec3 center_{0.0};
  double pixelsPerMetre_ = 1.0;
};

}  // namespace scatter::lab
