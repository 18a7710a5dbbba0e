#include "levels/mesh/mesh_columns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <vector>

namespace scatter::levels {

namespace {

constexpr int kColumns = 512;

/// Where a column passes through a triangle.
struct Crossing {
  std::uint32_t column;
  std::int32_t winding;  ///< 1 on the way in, -1 on the way out.
  double height;
};

/// Twice the area of a triangle, positive if it is counter-clockwise.
double crossOf(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Columns along the third axis, leaning, so many each way.
class Grid {
 public:
  Grid(const WorkMesh& mesh, const glm::dvec3& origin, int columns)
      : mesh_(mesh), origin_(origin), columns_(columns) {
    for (const glm::dvec3& vertex : mesh.vertices) {
      low_ = glm::min(low_, flat(vertex));
      high_ = glm::max(high_, flat(vertex));
    }
    step_ = (high_ - low_) / static_cast<double>(columns);
  }

  RawMoments integrate() {
    for (const Triangle& t : mesh_.triangles) cross(t);
    std::sort(crossings_.begin(), crossings_.end(), [](const Crossing& a, const Crossing& b) {
      return a.column != b.column ? a.column < b.column : a.height < b.height;
    });
    RawMoments sum;
    for (std::size_t first = 0, last = 0; first < crossings_.size(); first = last) {
      while (last < crossings_.size() && crossings_[last].column == crossings_[first].column) ++last;
      add(first, last, sum);
    }
    return sum.scaled(step_.x * step_.y);
  }

 private:
  [[nodiscard]] glm::dvec2 flat(const glm::dvec3& vertex) const {
    const glm::dvec3 p = vertex - origin_;
    return {p.x - kColumnLean[0] * p.z, p.y - kColumnLean[1] * p.z};
  }

  // Not quite the middle, where the corners of models with a middle are.
  [[nodiscard]] glm::dvec2 middleOf(int i, int j) const {
    return low_ + step_ * glm::dvec2(i + 0.5003, j + 0.4998);
  }

  void cross(const Triangle& t) {
    const std::array<glm::dvec2, 3> p{flat(mesh_.vertices[t[0]]), flat(mesh_.vertices[t[1]]),
                                      flat(mesh_.vertices[t[2]])};
    const double area = crossOf(p[0], p[1], p[2]);
    if (area == 0.0) return;
    const glm::dvec2 from = (glm::min(p[0], glm::min(p[1], p[2])) - low_) / step_;
    const glm::dvec2 to = (glm::max(p[0], glm::max(p[1], p[2])) - low_) / step_;
    for (int i = first(from.x); i < last(to.x); ++i) {
      for (int j = first(from.y); j < last(to.y); ++j) {
        const glm::dvec2 at = middleOf(i, j);
        const glm::dvec3 weights(crossOf(at, p[1], p[2]) / area, crossOf(p[0], at, p[2]) / area,
                                 crossOf(p[0], p[1], at) / area);
        if (weights.x < 0.0 || weights.y < 0.0 || weights.z < 0.0) continue;
        const double height =
            weights.x * heightOf(t[0]) + weights.y * heightOf(t[1]) + weights.z * heightOf(t[2]);
        crossings_.push_back({static_cast<std::uint32_t>(i * columns_ + j), area < 0.0 ? 1 : -1, height});
      }
    }
  }

  [[nodiscard]] int first(double cell) const { return std::clamp(static_cast<int>(cell) - 1, 0, columns_); }
  [[nodiscard]] int last(double cell) const { return std::clamp(static_cast<int>(cell) + 1, 0, columns_); }
  [[nodiscard]] double heightOf(std::uint32_t vertex) const { return mesh_.vertices[vertex].z - origin_.z; }

  // A column that rounding leads in and not out again is left out.
  void add(std::size_t first, std::size_t last, RawMoments& sum) const {
    int balance = 0;
    for (std::size_t i = first; i < last; ++i) balance += crossings_[i].winding;
    if (balance != 0) return;
    const auto column = static_cast<int>(crossings_[first].column);
    const glm::dvec2 at = middleOf(column / columns_, column % columns_);
    const Line line{{at.x, at.y, 0.0}, {kColumnLean[0], kColumnLean[1], 1.0}};
    int winding = 0;
    for (std::size_t i = first; i + 1 < last; ++i) {
      winding += crossings_[i].winding;
      const Stretch stretch{crossings_[i].height, crossings_[i + 1].height};
      if (winding > 0 && !stretch.isEmpty()) sum += lineMoments(line, stretch);
    }
  }

  const WorkMesh& mesh_;
  glm::dvec3 origin_;
  int columns_;
  glm::dvec2 low_{std::numeric_limits<double>::infinity()};
  glm::dvec2 high_{-std::numeric_limits<double>::infinity()};
  glm::dvec2 step_{0.0};
  std::vector<Crossing> crossings_;
};

}  // namespace

EstimatedMoments columnMoments(const WorkMesh& mesh, const glm::dvec3& origin) {
  const RawMoments fine = Grid(mesh, origin, kColumns).integrate();
  return {fine, std::abs(fine.volume - Grid(mesh, origin, kColumns / 2).integrate().volume)};
}

}  // namespace scatter::levels
