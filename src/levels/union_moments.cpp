#include "levels/union_moments.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "levels/part_geometry.h"
#include "levels/polytope.h"

namespace scatter::levels {

namespace {

Stretch common(const Stretch& a, const Stretch& b) {
  return {std::max(a.low, b.low), std::min(a.high, b.high)};
}

/// Where |x|² <= r² of what is left of x along the line: `across` and `along` are of the origin and the
/// direction.
Stretch withinRadius(const glm::dvec3& across, const glm::dvec3& along, double radius) {
  const double a = glm::dot(along, along);
  const double b = glm::dot(across, along);
  const double c = glm::dot(across, across) - radius * radius;
  if (!(a > 0.0)) return c < 0.0 ? Stretch{} : Stretch{0.0, 0.0};
  const double root = b * b - a * c;
  if (!(root > 0.0)) return {0.0, 0.0};
  const double half = std::sqrt(root);
  return {(-b - half) / a, (-b + half) / a};
}

Stretch withinSlab(double origin, double direction, double half) {
  if (direction == 0.0) return std::abs(origin) < half ? Stretch{} : Stretch{0.0, 0.0};
  const auto [low, high] = std::minmax({(-half - origin) / direction, (half - origin) / direction});
  return {low, high};
}

Stretch cut(const Sphere& sphere, const Line& line) {
  return withinRadius(line.origin, line.direction, toDouble(sphere.radius));
}

Stretch cut(const Cylinder& cylinder, const Line& line) {
  const glm::dvec3 flat(1.0, 0.0, 1.0);
  const Stretch stretch = withinRadius(line.origin * flat, line.direction * flat, toDouble(cylinder.radius));
  const Stretch slab = withinSlab(line.origin.y, line.direction.y, toDouble(cylinder.halfHeight));
  return common(stretch, slab);
}

// Of the cylinder and the two balls, all in one stretch, as a capsule is convex.
Stretch cut(const Capsule& capsule, const Line& line) {
  Stretch stretch = cut(Cylinder{capsule.radius, capsule.halfHeight}, line);
  for (const double sign : {1.0, -1.0}) {
    const glm::dvec3 end(0.0, sign * toDouble(capsule.halfHeight), 0.0);
    const Stretch ball = cut(Sphere{capsule.radius}, {line.origin - end, line.direction});
    if (ball.isEmpty()) continue;
    stretch = stretch.isEmpty() ? ball
                                : Stretch{std::min(stretch.low, ball.low), std::max(stretch.high, ball.high)};
  }
  return stretch;
}

/// A part as lines are cut with it.
class Solid {
 public:
  explicit Solid(const ConvexPart& part) : part_(part), pose_(part.pose) {
    if (auto core = flatSidedCore(part); core && *core) core_ = std::move(**core);
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 along(0.0);
      along[axis] = 1.0;
      low_[axis] = -reach(-along);
      high_[axis] = reach(along);
    }
  }

  /// Along a direction of any length: the largest dot product.
  [[nodiscard]] double reach(const glm::dvec3& direction) const {
    const double length = glm::length(direction);
    return length * support(part_, 0.0, direction / length);
  }

  [[nodiscard]] bool meetsBounds(const Solid& other) const {
    return glm::all(glm::lessThan(low_, other.high_)) && glm::all(glm::lessThan(other.low_, high_));
  }

  [[nodiscard]] Stretch cutWith(const Line& line) const {
    if (core_) return cutFlat(line);
    const Line local{pose_.toLocal(line.origin), line.direction * pose_.rotation};
    if (const auto* sphere = std::get_if<Sphere>(&part_.shape)) return cut(*sphere, local);
    if (const auto* capsule = std::get_if<Capsule>(&part_.shape)) return cut(*capsule, local);
    if (const auto* cylinder = std::get_if<Cylinder>(&part_.shape)) return cut(*cylinder, local);
    return {0.0, 0.0};
  }

  /// Columns: two sides to see the part by, as long and as wide as it is, and the short way through.
  [[nodiscard]] glm::dmat3 axes() const {
    if (!core_) return {pose_.rotation[1], pose_.rotation[2], pose_.rotation[0]};
    const auto largest =
        std::max_element(core_->faces().begin(), core_->faces().end(),
                         [this](const auto& a, const auto& b) { return areaOf(a) < areaOf(b); });
    const glm::dvec3 through = largest->plane.normal;
    const glm::dvec3 edge = longestEdge(*largest);
    const glm::dvec3 side = glm::normalize(edge - through * glm::dot(through, edge));
    return {side, glm::cross(through, side), through};
  }

 private:
  [[nodiscard]] Stretch cutFlat(const Line& line) const {
    Stretch stretch;
    for (const Polytope::Face& face : core_->faces()) {
      const double outside = face.plane.signedDistance(line.origin);
      const double rate = glm::dot(face.plane.normal, line.direction);
      if (rate > 0.0) {
        stretch.high = std::min(stretch.high, -outside / rate);
      } else if (rate < 0.0) {
        stretch.low = std::max(stretch.low, -outside / rate);
      } else if (outside > 0.0) {
        return {0.0, 0.0};
      }
    }
    return stretch;
  }

  [[nodiscard]] double areaOf(const Polytope::Face& face) const {
    const auto corners = core_->loop(face);
    glm::dvec3 sum(0.0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      const glm::dvec3& first = core_->vertices()[corners[0]];
      sum += glm::cross(core_->vertices()[corners[i]] - first, core_->vertices()[corners[i + 1]] - first);
    }
    return glm::length(sum);
  }

  [[nodiscard]] glm::dvec3 longestEdge(const Polytope::Face& face) const {
    const auto corners = core_->loop(face);
    glm::dvec3 longest(0.0);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const glm::dvec3 edge =
          core_->vertices()[corners[(i + 1) % corners.size()]] - core_->vertices()[corners[i]];
      if (glm::length(edge) > glm::length(longest)) longest = edge;
    }
    return longest;
  }

  const ConvexPart& part_;
  DoublePose pose_;
  std::optional<Polytope> core_;
  glm::dvec3 low_{0.0};
  glm::dvec3 high_{0.0};
};

/// One part, and what of it other parts hold as well.
class Columns {
 public:
  Columns(const Solid& solid, const std::vector<const Solid*>& others, const glm::dvec3& origin)
      : solid_(solid), others_(others), origin_(origin) {
    const glm::dmat3 axes = solid.axes();
    direction_ = axes[2] + kColumnLean[0] * axes[0] + kColumnLean[1] * axes[1];
    for (int side = 0; side < 2; ++side) {
      axis_[side] = axes[side];
      covector_[side] = axes[side] - kColumnLean[side] * axes[2];
      low_[side] = -solid.reach(-covector_[side]);
      high_[side] = solid.reach(covector_[side]);
    }
  }

  EstimatedMoments shared() {
    narrow();
    if (!(high_[0] > low_[0]) || !(high_[1] > low_[1])) return {};
    const RawMoments fine = integrate(kColumns);
    return {fine, std::abs(fine.volume - integrate(kColumns / 2).volume)};
  }

 private:
  static constexpr int kColumns = 64;

  /// Another part and its bounds on the grid.
  struct Seen {
    const Solid* solid;
    glm::dvec2 low;
    glm::dvec2 high;

    [[nodiscard]] bool covers(const glm::dvec2& at) const {
      return glm::all(glm::lessThanEqual(low, at)) && glm::all(glm::lessThanEqual(at, high));
    }
  };

  RawMoments integrate(int columns) {
    const double wide = (high_[0] - low_[0]) / columns;
    const double deep = (high_[1] - low_[1]) / columns;
    RawMoments sum;
    for (int i = 0; i < columns; ++i) {
      for (int j = 0; j < columns; ++j) {
        sum += along({low_[0] + (i + 0.5) * wide, low_[1] + (j + 0.5) * deep});
      }
    }
    return sum.scaled(wide * deep);
  }

  // Only where others are.
  void narrow() {
    glm::dvec2 low(std::numeric_limits<double>::infinity());
    glm::dvec2 high(-low);
    for (const Solid* other : others_) {
      Seen seen{other, {}, {}};
      for (int side = 0; side < 2; ++side) {
        seen.low[side] = -other->reach(-covector_[side]);
        seen.high[side] = other->reach(covector_[side]);
      }
      low = glm::min(low, seen.low);
      high = glm::max(high, seen.high);
      seen_.push_back(seen);
    }
    low_ = glm::max(low_, low);
    high_ = glm::min(high_, high);
  }

  // Of the stretches that others have of the part's own, each place once.
  RawMoments along(const glm::dvec2& at) {
    const Line line{at[0] * axis_[0] + at[1] * axis_[1], direction_};
    RawMoments sum;
    const Stretch own = solid_.cutWith(line);
    if (own.isEmpty()) return sum;
    stretches_.clear();
    for (const Seen& seen : seen_) {
      if (!seen.covers(at)) continue;
      const Stretch stretch = common(own, seen.solid->cutWith(line));
      if (!stretch.isEmpty()) stretches_.push_back(stretch);
    }
    std::sort(stretches_.begin(), stretches_.end(),
              [](const Stretch& a, const Stretch& b) { return a.low < b.low; });
    double until = own.low;
    for (Stretch stretch : stretches_) {
      stretch.low = std::max(stretch.low, until);
      if (stretch.isEmpty()) continue;
      sum += lineMoments({line.origin - origin_, line.direction}, stretch);
      until = stretch.high;
    }
    return sum;
  }

  const Solid& solid_;
  const std::vector<const Solid*>& others_;
  std::vector<Seen> seen_;
  glm::dvec3 origin_;
  std::array<glm::dvec3, 2> axis_{};
  std::array<glm::dvec3, 2> covector_{};
  glm::dvec3 direction_{0.0};
  glm::dvec2 low_{0.0};
  glm::dvec2 high_{0.0};
  std::vector<Stretch> stretches_;
};

EstimatedMoments workOut(std::span<const ConvexPart> parts, const glm::dvec3& origin) {
  std::vector<Solid> solids;
  solids.reserve(parts.size());
  for (const ConvexPart& part : parts) solids.emplace_back(part);
  EstimatedMoments sum;
  for (std::size_t i = 1; i < solids.size(); ++i) {
    std::vector<const Solid*> others;
    for (std::size_t j = 0; j < i; ++j) {
      if (solids[i].meetsBounds(solids[j])) others.push_back(&solids[j]);
    }
    if (others.empty()) continue;
    const EstimatedMoments shared = Columns(solids[i], others, origin).shared();
    sum.moments += shared.moments;
    sum.error += shared.error;
  }
  return sum;
}

/// All numbers that parts are made of, by their bits.
class PartsKey {
 public:
  PartsKey(std::span<const ConvexPart> parts, const glm::dvec3& origin) {
    for (int axis = 0; axis < 3; ++axis) append(origin[axis]);
    for (const ConvexPart& part : parts) {
      append(part.shape.index());
      std::visit([this](const auto& shape) { append(shape); }, part.shape);
      append(part.pose.position);
      append(part.pose.rotation);
    }
  }

  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  template <class T>
  void append(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    const auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
    bytes_.append(bytes.data(), bytes.size());
  }
  void append(const ConvexHull& hull) {
    append(hull.vertices.size());
    for (const Vec3& vertex : hull.vertices) append(vertex);
  }

  std::string bytes_;
};

/// What was worked out of late. Every world that a scene is played in reads its models anew, and most of the
/// time that takes is here.
class Memory {
 public:
  [[nodiscard]] std::optional<EstimatedMoments> find(const std::string& key) {
    const std::scoped_lock lock(mutex_);
    const auto known = known_.find(key);
    return known == known_.end() ? std::nullopt : std::optional(known->second);
  }

  void keep(std::string key, const EstimatedMoments& moments) {
    const std::scoped_lock lock(mutex_);
    if (bytes_ + key.size() > kMostBytes) {
      known_.clear();
      bytes_ = 0;
    }
    if (key.size() > kMostBytes) return;
    bytes_ += key.size();
    known_.insert_or_assign(std::move(key), moments);
  }

 private:
  static constexpr std::size_t kMostBytes = 1 << 20;

  std::mutex mutex_;
  std::map<std::string, EstimatedMoments> known_;
  std::size_t bytes_ = 0;
};

}  // namespace

EstimatedMoments sharedMoments(std::span<const ConvexPart> parts, const glm::dvec3& origin) {
  static Memory memory;
  std::string key = PartsKey(parts, origin).take();
  if (const auto known = memory.find(key)) return *known;
  const EstimatedMoments moments = workOut(parts, origin);
  memory.keep(std::move(key), moments);
  return moments;
}

}  // namespace scatter::levels
