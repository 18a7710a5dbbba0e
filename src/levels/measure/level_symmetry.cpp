#include <scatter/levels/level_symmetry.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

#include "levels/part_geometry.h"

namespace scatter {
namespace levels {
namespace {

/// As a share of the diagonal.
constexpr double kSamePlace = 1e-6;

/// What tells parts apart.
struct Outline {
  RoundedHull hull;
  glm::dvec3 middle{0.0};

  explicit Outline(const ConvexPart& part) : hull(roundedHull(part, 0.0)) {
    for (const glm::dvec3& point : hull.points) middle += point / static_cast<double>(hull.points.size());
  }
};

class SymmetrySearch {
 public:
  explicit SymmetrySearch(const LevelSet& levels) : levels_(levels) {
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 direction{0.0};
      direction[axis] = 1.0;
      for (const ConvexPart& part : levels.finest().parts) {
        bounds_.max[axis] = std::max(bounds_.max[axis], support(part, 0.0, direction));
        bounds_.min[axis] = std::min(bounds_.min[axis], -support(part, 0.0, -direction));
      }
    }
    tolerance_ = kSamePlace * glm::length(bounds_.max - bounds_.min);
  }

  [[nodiscard]] std::optional<LevelSymmetry> run() const {
    for (const int axis : {0, 2, 1}) {
      const double middle = 0.5 * (bounds_.min[axis] + bounds_.max[axis]);
      const double offset = std::abs(middle) <= tolerance_ ? 0.0 : middle;
      LevelSymmetry symmetry{{axis, static_cast<float>(offset)}, {}};
      for (int level = 1; level <= levels_.count(); ++level) {
        const std::optional<SymmetricParts> parts = partsOf(levels_.level(level), axis, offset);
        if (!parts) break;
        symmetry.levels.push_back(*parts);
      }
      if (symmetry.levels.size() == static_cast<std::size_t>(levels_.count())) return symmetry;
    }
    return std::nullopt;
  }

 private:
  /// Nothing if a part has no image.
  [[nodiscard]] std::optional<SymmetricParts> partsOf(const Level& level, int axis, double offset) const {
    const std::vector<Outline> outlines(level.parts.begin(), level.parts.end());
    const auto mirror = [&](glm::dvec3 point) {
      point[axis] = 2.0 * offset - point[axis];
      return point;
    };
    std::vector<bool> isTaken(outlines.size(), false);
    SymmetricParts result;
    for (std::size_t i = 0; i < outlines.size(); ++i) {
      if (isTaken[i]) continue;
      // The part itself comes last: one of two in one place may be the other's image.
      std::size_t image = i + 1;
      while (image < outlines.size() && (isTaken[image] || !isImage(outlines[i], outlines[image], mirror)))
        ++image;
      if (image < outlines.size()) {
        isTaken[image] = true;
        ++result.pairs;
      } else if (isImage(outlines[i], outlines[i], mirror)) {
        ++result.own;
      } else {
        return std::nullopt;
      }
    }
    return result;
  }

  template <class MirrorPoint>
  [[nodiscard]] bool isImage(const Outline& a, const Outline& b, const MirrorPoint& mirror) const {
    const auto isNear = [&](const glm::dvec3& from, const glm::dvec3& to) {
      return glm::length(mirror(from) - to) <= tolerance_;
    };
    if (!isNear(a.middle, b.middle) || std::abs(a.hull.radius - b.hull.radius) > tolerance_) return false;
    const auto& own = a.hull.points;
    const auto& others = b.hull.points;
    return own.size() == others.size() && std::all_of(own.begin(), own.end(), [&](const glm::dvec3& from) {
             return std::any_of(others.begin(), others.end(),
                                [&](const auto& to) { return isNear(from, to); });
           });
  }

  const LevelSet& levels_;
  DoubleBounds bounds_;
  double tolerance_ = 0.0;
};

}  // namespace
}  // namespace levels

std::optional<LevelSymmetry> symmetryOf(const LevelSet& levels) {
  return levels::SymmetrySearch(levels).run();
}

}  // namespace scatter
