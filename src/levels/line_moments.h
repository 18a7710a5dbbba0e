#pragma once

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <limits>

namespace scatter::levels {

/// Integrals over a region: of 1, of x and of x xᵀ.
struct RawMoments {
  double volume = 0.0;
  glm::dvec3 first{0.0};
  glm::dmat3 second{0.0};

  RawMoments& operator+=(const RawMoments& other) {
    volume += other.volume;
    first += other.first;
    second += other.second;
    return *this;
  }
  [[nodiscard]] RawMoments scaled(double factor) const {
    return {factor * volume, factor * first, factor * second};
  }
};

/// Integrals of columns that stand for a region.
struct EstimatedMoments {
  RawMoments moments{};
  double error = 0.0;  ///< Of the volume, cubic metres: how much half as many columns each way differ.
};

struct Line {
  glm::dvec3 origin{0.0};
  glm::dvec3 direction{0.0};
};

/// A stretch of a line, between two values of its parameter; empty unless low < high.
struct Stretch {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool isEmpty() const { return !(low < high); }
};

/// Over a stretch, by the line's parameter.
[[nodiscard]] inline RawMoments lineMoments(const Line& line, const Stretch& stretch) {
  const double a = stretch.low;
  const double b = stretch.high;
  const double length = b - a;
  const double first = (b * b - a * a) / 2.0;
  const double second = (b * b * b - a * a * a) / 3.0;
  const glm::dvec3& o = line.origin;
  const glm::dvec3& d = line.direction;
  return {length, length * o + first * d,
          length * glm::outerProduct(o, o) + first * (glm::outerProduct(o, d) + glm::outerProduct(d, o)) +
              second * glm::outerProduct(d, d)};
}

/// How columns lean to the two sides of a grid, as a share of their length. Seen upright, a side along the
/// columns would be in or out by chance; seen from askew it is in by so much.
inline constexpr double kColumnLean[2]{0.41, 0.37};

}  // namespace scatter::levels
