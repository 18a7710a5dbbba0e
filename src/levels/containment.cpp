#include <scatter/levels/containment.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "levels/cover.h"
#include "levels/part_check.h"
#include "levels/part_geometry.h"
#include "levels/text.h"

namespace scatter {
namespace levels {
namespace {

/// Rounding of the clipping, as a share of the largest coordinate.
constexpr double kEpsilon = 1e-10;

/// Whether one round part holds, to within `slack`, a rounded hull. Points and centre line are in the
/// round part's frame.
struct HoldsIn {
  const std::vector<glm::dvec3>& points;
  double radius;
  double slack;

  bool operator()(const Sphere& sphere) const {
    return allWithin([](const glm::dvec3& p) { return glm::length(p); }, toDouble(sphere.radius));
  }
  bool operator()(const Capsule& capsule) const {
    const double h = toDouble(capsule.halfHeight);
    const auto toLine = [h](const glm::dvec3& p) {
      return glm::length(p - glm::dvec3(0.0, std::clamp(p.y, -h, h), 0.0));
    };
    return allWithin(toLine, toDouble(capsule.radius));
  }
  bool operator()(const Cylinder& cylinder) const {
    return allWithin([](const glm::dvec3& p) { return std::abs(p.y); }, toDouble(cylinder.halfHeight)) &&
           allWithin([](const glm::dvec3& p) { return std::hypot(p.x, p.z); }, toDouble(cylinder.radius));
  }
  bool operator()(const Box&) const { return false; }
  bool operator()(const ConvexHull&) const { return false; }

 private:
  template <class Distance>
  [[nodiscard]] bool allWithin(const Distance& distance, double limit) const {
    return std::all_of(points.begin(), points.end(),
                       [&](const glm::dvec3& p) { return distance(p) + radius <= limit + slack; });
  }
};

/// Whether a cylinder certainly holds another one, to within `slack`; exact if their axes are parallel. A
/// prism around the finer one would not even fit into its like.
bool holdsCylinder(const ConvexPart& coarse, const ConvexPart& fine, double slack) {
  const auto* const outer = std::get_if<Cylinder>(&coarse.shape);
  const auto* const inner = std::get_if<Cylinder>(&fine.shape);
  if (outer == nullptr || inner == nullptr) return false;
  const DoublePose outerPose(coarse.pose);
  const DoublePose innerPose(fine.pose);
  const glm::dvec3 center = outerPose.toLocal(innerPose.position);
  const glm::dvec3 axis = innerPose.rotation[1] * outerPose.rotation;
  const glm::dvec3 end = toDouble(inner->halfHeight) * axis;
  const double radius = toDouble(inner->radius);
  const double height = std::abs(center.y) + std::abs(end.y) + radius * std::hypot(axis.x, axis.z);
  const double width = std::max(std::hypot(center.x + end.x, center.z + end.z),
                                std::hypot(center.x - end.x, center.z - end.z)) +
                       radius;
  return height <= toDouble(outer->halfHeight) + slack && width <= toDouble(outer->radius) + slack;
}

DoubleBounds boundsOf(const ConvexPart& part, double hullMargin) {
  DoubleBounds bounds;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 direction{0.0};
    direction[axis] = 1.0;
    bounds.max[axis] = support(part, hullMargin, direction);
    bounds.min[axis] = -support(part, hullMargin, -direction);
  }
  return bounds;
}

/// A part of the coarser level, ready to be asked what it holds.
struct CoarsePart {
  const ConvexPart* part = nullptr;
  std::optional<Cover> core;  ///< Box or hull without margin; nothing for round shapes.
  double margin = 0.0;        ///< Around the core.
};

/// A part of the finer level.
struct FinePart {
  const ConvexPart* part = nullptr;
  RoundedHull rounded;
  Polytope core;  ///< Box or hull without margin; empty for round shapes.
};

/// One coarser level, asked part by part whether it holds a finer one. Every rule is sufficient: what it
/// accepts is nested. Rules that need more work come later.
class NestingCheck {
 public:
  NestingCheck(std::vector<CoarsePart> coarser, double hullMargin, double tolerance, double epsilon)
      : coarser_(std::move(coarser)), hullMargin_(hullMargin), tolerance_(tolerance), epsilon_(epsilon) {}

  std::optional<Uncovered> findGap(const FinePart& fine) {
    const bool isHeldByOne = std::any_of(coarser_.begin(), coarser_.end(),
                                         [&](const CoarsePart& coarse) { return holds(coarse, fine); });
    if (isHeldByOne) return std::nullopt;

    // A hull grown by the margin lies in a union if the hull lies in what is left of the union's parts
    // when each is shrunk by the margin.
    std::optional<Uncovered> coreGap;
    const bool hasMargin = fine.rounded.radius > 0.0 && !fine.core.isEmpty();
    if (hasMargin && !shrunkCovers().empty()) {
      coreGap = findUncovered(fine.core, shrunkCovers(), tolerance_, epsilon_);
      if (!coreGap || meetsHullsOnly(fine)) return coreGap;
    }
    // It also does if a polytope around both does, which holds for touching boxes, too.
    const Polytope outer = outerPolytope(*fine.part, hullMargin_, tangents(fine), epsilon_);
    const std::optional<Uncovered> gap = findUncovered(outer, fullCovers(), tolerance_, epsilon_);
    if (!gap || !coreGap) return gap;
    return coreGap->distance < gap->distance ? coreGap : gap;
  }

 private:
  [[nodiscard]] bool holds(const CoarsePart& coarse, const FinePart& fine) const {
    const double radius = fine.rounded.radius;
    if (!coarse.core) {
      if (holdsCylinder(*coarse.part, *fine.part, tolerance_)) return true;
      std::vector<glm::dvec3> local;
      const DoublePose pose(coarse.part->pose);
      for (const glm::dvec3& point : fine.rounded.points) local.push_back(pose.toLocal(point));
      return std::visit(HoldsIn{local, radius, tolerance_}, coarse.part->shape);
    }
    // The core may come no nearer to the faces than its own margin exceeds the coarser part's.
    const double inset = std::max(0.0, radius - coarse.margin);
    const auto& planes = coarse.core->planes();
    return std::all_of(planes.begin(), planes.end(), [&](const HalfSpace& plane) {
      const double reach = support(*fine.part, hullMargin_, plane.normal) - radius;
      return reach <= plane.offset - inset + tolerance_;
    });
  }

  /// Between hulls the margins cancel, and the first rule says all that there is to say.
  [[nodiscard]] bool meetsHullsOnly(const FinePart& fine) const {
    const DoubleBounds bounds = boundsOf(*fine.part, hullMargin_);
    return std::all_of(coarser_.begin(), coarser_.end(), [&](const CoarsePart& coarse) {
      return std::holds_alternative<ConvexHull>(coarse.part->shape) ||
             !boundsOf(*coarse.part, 0.0).overlaps(bounds, tolerance_);
    });
  }

  /// Directions in which a polytope around the part must touch it to be judged exactly.
  [[nodiscard]] std::vector<glm::dvec3> tangents(const FinePart& fine) const {
    std::vector<glm::dvec3> normals;
    for (const Polytope::Face& face : fine.core.faces()) normals.push_back(face.plane.normal);
    const DoubleBounds bounds = boundsOf(*fine.part, hullMargin_);
    for (const CoarsePart& coarse : coarser_) {
      if (coarse.core && !coarse.core->bounds().overlaps(bounds, tolerance_ + coarse.margin)) continue;
      if (coarse.core) {
        for (const HalfSpace& plane : coarse.core->planes()) normals.push_back(plane.normal);
      } else if (std::holds_alternative<Cylinder>(coarse.part->shape)) {
        const glm::dvec3 axis = DoublePose(coarse.part->pose).rotation[1];
        normals.insert(normals.end(), {axis, -axis});
      }
    }
    return normals;
  }

  const std::vector<Cover>& shrunkCovers() {
    if (!shrunkCovers_) shrunkCovers_ = makeCovers(hullMargin_);
    return *shrunkCovers_;
  }

  const std::vector<Cover>& fullCovers() {
    if (!fullCovers_) fullCovers_ = makeCovers(0.0);
    return *fullCovers_;
  }

  [[nodiscard]] std::vector<Cover> makeCovers(double inset) const {
    std::vector<Cover> covers;
    for (const CoarsePart& coarse : coarser_) {
      Polytope inner = innerPolytope(*coarse.part, hullMargin_, inset);
      if (!inner.isEmpty()) covers.emplace_back(std::move(inner));
    }
    return covers;
  }

  std::vector<CoarsePart> coarser_;
  double hullMargin_;
  double tolerance_;
  double epsilon_;
  std::optional<std::vector<Cover>> shrunkCovers_;
  std::optional<std::vector<Cover>> fullCovers_;
};

/// The cores of a level's parts, empty for round shapes. Fails on the first part that is no solid.
Result<std::vector<Polytope>> coresOf(const Level& level, const std::string& which) {
  if (level.parts.empty()) return fail("the " + which + " level has no parts");
  std::vector<Polytope> cores;
  for (std::size_t i = 0; i < level.parts.size(); ++i) {
    const std::string where = "the " + which + " level, part " + std::to_string(i + 1) + ": ";
    if (const auto defect = findDefect(level.parts[i])) return fail(where + *defect);
    auto core = flatSidedCore(level.parts[i]);
    if (!core) return fail(where + core.error().message);
    cores.push_back(core->has_value() ? std::move(**core) : Polytope());
  }
  return cores;
}

double largestCoordinate(const Level& level) {
  double largest = 0.0;
  for (const ConvexPart& part : level.parts) {
    const DoubleBounds bounds = boundsOf(part, 0.0);
    const glm::dvec3 reach = glm::max(glm::abs(bounds.min), glm::abs(bounds.max));
    largest = std::max({largest, reach.x, reach.y, reach.z});
  }
  return largest;
}

Result<void> checkLengths(float hullMargin, float tolerance) {
  if (!std::isfinite(hullMargin) || hullMargin < 0.0F) {
    return fail("hull margin " + toText(toDouble(hullMargin)) + " must be finite and not negative");
  }
  if (!std::isfinite(tolerance) || tolerance < 0.0F) {
    return fail("tolerance " + toText(toDouble(tolerance)) + " must be finite and not negative");
  }
  return {};
}

}  // namespace
}  // namespace levels

Result<std::optional<ContainmentGap>> findContainmentGap(const Level& finer, const Level& coarser,
                                                         float hullMargin, float tolerance) {
  using namespace levels;
  if (auto sound = checkLengths(hullMargin, tolerance); !sound) return fail(sound.error().message);
  auto coarseCores = coresOf(coarser, "coarser");
  if (!coarseCores) return fail(coarseCores.error().message);
  auto fineCores = coresOf(finer, "finer");
  if (!fineCores) return fail(fineCores.error().message);

  const double margin = toDouble(hullMargin);
  std::vector<CoarsePart> coarseParts;
  for (std::size_t i = 0; i < coarser.parts.size(); ++i) {
    CoarsePart coarse{&coarser.parts[i], std::nullopt, marginOf(coarser.parts[i], margin)};
    if (!(*coarseCores)[i].isEmpty()) coarse.core.emplace(std::move((*coarseCores)[i]));
    coarseParts.push_back(std::move(coarse));
  }
  const double epsilon = kEpsilon * std::max(largestCoordinate(finer), largestCoordinate(coarser));
  NestingCheck check(std::move(coarseParts), margin, toDouble(tolerance), epsilon);

  std::optional<ContainmentGap> worst;
  for (std::size_t i = 0; i < finer.parts.size(); ++i) {
    const FinePart fine{&finer.parts[i], roundedHull(finer.parts[i], margin), std::move((*fineCores)[i])};
    const std::optional<Uncovered> gap = check.findGap(fine);
    if (!gap || (worst && gap->distance <= toDouble(worst->distance))) continue;
    worst = ContainmentGap{i, Vec3(gap->point), static_cast<float>(gap->distance)};
  }
  return worst;
}

}  // namespace scatter
