#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace scatter::lab {

/// Colours from 0 to 1.
using Color = glm::dvec3;

/// A triangle on the screen: x to the right and y down in pixels, z away from the eye in any unit.
struct ScreenTriangle {
  glm::dvec3 corners[3]{};
  glm::dvec3 normal{0.0, 0.0, -1.0};  ///< Of the surface, in the view's axes.
  Color color{0.7};                   ///< As seen, shading included.
  std::uint32_t part = 0;             ///< A strong line is drawn between parts,
  std::uint32_t face = 0;             ///< and a fine one between faces of a part.
};

/// A picture drawn in software, with hidden surfaces removed and lines along edges and outlines.
class Raster {
 public:
  /// Each pixel is the mean of kSamples by kSamples of them.
  Raster(int width, int height);

  void draw(const ScreenTriangle& triangle);

  /// Three bytes a pixel, red first, row by row from the top.
  [[nodiscard]] std::string rgb() const;

 private:
  struct Sample {
    float depth = 0.0F;
    glm::vec3 normal{0.0F};
    glm::vec3 color{1.0F};
    std::uint32_t part = 0;  ///< 0 where nothing is; else one more than the triangle's.
    std::uint32_t face = 0;
  };

  static constexpr int kSamples = 3;

  [[nodiscard]] std::size_t indexOf(int x, int y) const;
  [[nodiscard]] glm::vec3 colorAt(int x, int y) const;
  [[nodiscard]] float lineBetween(const Sample& a, const Sample& b) const;

  int width_;   ///< In samples.
  int height_;  ///< In samples.
  std::vector<Sample> samples_;
};

}  // namespace scatter::lab
