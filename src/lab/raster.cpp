#include "lab/raster.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace scatter::lab {

namespace {

/// How much of the colour a line takes away.
constexpr float kOutline = 0.85F;
constexpr float kEdge = 0.45F;

/// Faces that turn by more than this have an edge between them although they count as one.
constexpr float kSharpCosine = 0.8F;

double turn(const glm::dvec3& a, const glm::dvec3& b, double x, double y) {
  return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

/// The samples that a range of coordinates covers.
std::pair<int, int> rangeOf(double low, double high, int count) {
  const double limit = count;
  return {static_cast<int>(std::clamp(std::floor(low), 0.0, limit)),
          static_cast<int>(std::clamp(std::ceil(high), 0.0, limit))};
}

}  // namespace

Raster::Raster(int width, int height)
    : width_(width * kSamples),
      height_(height * kSamples),
      samples_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)) {}

std::size_t Raster::indexOf(int x, int y) const {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
}

void Raster::draw(const ScreenTriangle& triangle) {
  const double scale = kSamples;
  const glm::dvec3 toSamples(scale, scale, 1.0);
  const glm::dvec3 a = triangle.corners[0] * toSamples;
  const glm::dvec3 b = triangle.corners[1] * toSamples;
  const glm::dvec3 c = triangle.corners[2] * toSamples;
  const double area = turn(a, b, c.x, c.y);
  if (!(std::abs(area) > 1e-12)) return;
  const auto [left, right] = rangeOf(std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}), width_);
  const auto [top, bottom] = rangeOf(std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}), height_);
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) {
      const double px = x + 0.5;
      const double py = y + 0.5;
      const double u = turn(b, c, px, py) / area;
      const double v = turn(c, a, px, py) / area;
      const double w = 1.0 - u - v;
      if (u < 0.0 || v < 0.0 || w < 0.0) continue;
      const auto depth = static_cast<float>(u * a.z + v * b.z + w * c.z);
      Sample& sample = samples_[indexOf(x, y)];
      if (sample.part != 0 && sample.depth <= depth) continue;
      sample = {depth, glm::vec3(triangle.normal), glm::vec3(triangle.color), triangle.part + 1,
                triangle.face};
    }
  }
}

float Raster::lineBetween(const Sample& a, const Sample& b) const {
  if (a.part != b.part) return kOutline;
  if (a.part == 0) return 0.0F;
  return a.face != b.face || glm::dot(a.normal, b.normal) < kSharpCosine ? kEdge : 0.0F;
}

glm::vec3 Raster::colorAt(int x, int y) const {
  const Sample& here = samples_[indexOf(x, y)];
  float line = 0.0F;
  if (x + 1 < width_) line = std::max(line, lineBetween(here, samples_[indexOf(x + 1, y)]));
  if (y + 1 < height_) line = std::max(line, lineBetween(here, samples_[indexOf(x, y + 1)]));
  if (x > 0) line = std::max(line, lineBetween(here, samples_[indexOf(x - 1, y)]));
  if (y > 0) line = std::max(line, lineBetween(here, samples_[indexOf(x, y - 1)]));
  return here.color * (1.0F - line);
}

std::string Raster::rgb() const {
  std::string bytes;
  for (int y = 0; y < height_; y += kSamples) {
    for (int x = 0; x < width_; x += kSamples) {
      glm::vec3 sum{0.0F};
      for (int i = 0; i < kSamples * kSamples; ++i) sum += colorAt(x + i % kSamples, y + i / kSamples);
      const glm::vec3 mean = glm::clamp(sum / static_cast<float>(kSamples * kSamples), 0.0F, 1.0F);
      for (int channel = 0; channel < 3; ++channel) {
        bytes += static_cast<char>(static_cast<unsigned char>(std::lround(255.0F * mean[channel])));
      }
    }
  }
  return bytes;
}

}  // namespace scatter::lab
