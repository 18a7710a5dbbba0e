#include "levels/build/edge_collapse.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>
#include <map>
#include <vector>

#include "levels/build/place_search.h"
#include "levels/mesh/triangle.h"

namespace scatter::levels {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Edges with more planes around are not worth the search for a point.
constexpr std::size_t kMostPlanes = 22;

/// Collapses tried before giving up.
constexpr std::size_t kMostTries = 20;

/// Planes closer than this count as one (cosine).
constexpr double kSamePlane = 1.0 - 1e-7;

/// An edge and where its ends would go.
struct Collapse {
  double cost = kInfinity;
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  glm::dvec3 point{0.0};
};

class Collapser {
 public:
  Collapser(HullBuilder& builder, const TriangleHull& original, const std::optional<Mirror>& mirror,
            TriangleHull& hull)
      : builder_(builder),
        original_(original),
        mirror_(mirror),
        hull_(hull),
        diagonal_(glm::length(original.bounds.max - original.bounds.min)) {}

  [[nodiscard]] bool isDone(std::size_t maxVertices) const { return cornersOf(hull_) <= maxVertices; }

  /// False if no edge can be collapsed.
  bool step() {
    std::vector<Collapse> candidates = findCandidates();
    std::sort(candidates.begin(), candidates.end(), [](const Collapse& x, const Collapse& y) {
      return std::array{x.cost, double(x.a), double(x.b)} < std::array{y.cost, double(y.a), double(y.b)};
    });
    if (candidates.size() > kMostTries) candidates.resize(kMostTries);
    return std::any_of(candidates.begin(), candidates.end(),
                       [this](const Collapse& collapse) { return apply(collapse); });
  }

 private:
  /// The corners of the edge: the key under which its point is remembered.
  using EdgeKey = std::array<double, 9>;
  struct Found {
    double cost = kInfinity;
    glm::dvec3 point{0.0};
  };

  /// The planes around an edge, and how volume grows as its ends move to a point.
  struct Surroundings {
    std::vector<HalfSpace> planes;
    glm::dvec3 gradient{0.0};
    double base = 0.0;
  };

  /// Of corners within rounding of a face, one may be left out where its image is not.
  [[nodiscard]] std::size_t cornersOf(const TriangleHull& hull) const {
    return mirror_ ? withImages(hull.vertices, *mirror_, kOnPlane * diagonal_).size() : hull.vertices.size();
  }

  std::vector<Collapse> findCandidates() {
    around_.assign(hull_.vertices.size(), {});
    for (std::uint32_t i = 0; i < hull_.triangles.size(); ++i) {
      for (const std::uint32_t vertex : hull_.triangles[i]) around_[vertex].push_back(i);
    }
    std::vector<Collapse> candidates;
    for (const Triangle& triangle : hull_.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = triangle[k];
        const std::uint32_t b = triangle[(k + 1) % 3];
        if (a > b) continue;
        const Found found = priceOf(a, b);
        if (found.cost < kInfinity) candidates.push_back({found.cost, a, b, found.point});
      }
    }
    return candidates;
  }

  [[nodiscard]] Surroundings surroundingsOf(std::uint32_t a, std::uint32_t b) const {
    std::vector<std::uint32_t> faces = around_[a];
    faces.insert(faces.end(), around_[b].begin(), around_[b].end());
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    Surroundings result;
    for (const std::uint32_t i : faces) {
      const Triangle& t = hull_.triangles[i];
      const HalfSpace& plane = hull_.planes[i];
      const double area = triangleArea(hull_.vertices[t[0]], hull_.vertices[t[1]], hull_.vertices[t[2]]);
      result.gradient += plane.normal * (area / 3.0);
      result.base += plane.offset * area / 3.0;
      const auto same = std::find_if(result.planes.begin(), result.planes.end(), [&](const HalfSpace& other) {
        return glm::dot(other.normal, plane.normal) > kSamePlane;
      });
      if (same == result.planes.end()) {
        result.planes.push_back(plane);
      } else {
        same->offset = std::max(same->offset, plane.offset);
      }
    }
    return result;
  }

  Found priceOf(std::uint32_t a, std::uint32_t b) {
    const Surroundings around = surroundingsOf(a, b);
    if (around.planes.size() > kMostPlanes) return {};
    const glm::dvec3& from = hull_.vertices[a];
    const glm::dvec3& to = hull_.vertices[b];
    const EdgeKey key{from.x,     from.y, from.z, to.x, to.y, to.z, around.gradient.x, around.gradient.y,
                      around.base};
    const auto known = known_.find(key);
    if (known != known_.end()) return known->second;

    const glm::dvec3 middle = 0.5 * (from + to);
    const Places places = findPlaces(around.planes, around.gradient, middle, 1e-9 * diagonal_);
    Found found;
    const bool isOwnImage =
        mirror_ && ((*mirror_)(from) == to || (from[mirror_->axis] == 0.0 && to[mirror_->axis] == 0.0));
    const auto offer = [&](const glm::dvec3& place) {
      // The middle of two places beyond the planes, which are symmetric, is beyond them, too.
      const glm::dvec3 point = isOwnImage ? mirror_->flattened(place) : place;
      if (glm::length(point - from) > 2.0 * diagonal_) return;
      const double volume = std::max(0.0, glm::dot(around.gradient, point) - around.base);
      const double cost = distanceTo(original_, point) + std::cbrt(volume);
      if (cost < found.cost) found = {cost, point};
    };
    if (places.leastVolume) offer(*places.leastVolume);
    if (places.nearest) offer(*places.nearest);
    known_.emplace(key, found);
    return found;
  }

  bool apply(const Collapse& collapse) {
    const glm::dvec3& a = hull_.vertices[collapse.a];
    const glm::dvec3& b = hull_.vertices[collapse.b];
    const auto isReplaced = [&](const glm::dvec3& vertex) {
      return &vertex == &a || &vertex == &b ||
             (mirror_ && ((*mirror_)(vertex) == a || (*mirror_)(vertex) == b));
    };
    points_.clear();
    std::copy_if(hull_.vertices.begin(), hull_.vertices.end(), std::back_inserter(points_),
                 [&](const glm::dvec3& vertex) { return !isReplaced(vertex); });
    points_.push_back(collapse.point);
    if (mirror_) points_ = withImages(points_, *mirror_, kOnPlane * diagonal_);
    const double epsilon = 1e-9 * diagonal_;
    if (!builder_.build(points_, {epsilon, epsilon, 0}, trial_)) return false;
    if (cornersOf(trial_) >= cornersOf(hull_)) return false;
    // A point that slipped past a plane within rounding may have lost more than that elsewhere.
    const bool holdsBoth =
        std::all_of(trial_.planes.begin(), trial_.planes.end(), [&](const HalfSpace& plane) {
          const auto holds = [&](const glm::dvec3& point) {
            return plane.signedDistance(point) <= 1e-7 * diagonal_;
          };
          return holds(a) && holds(b) && (!mirror_ || (holds((*mirror_)(a)) && holds((*mirror_)(b))));
        });
    if (!holdsBoth) return false;
    std::swap(hull_, trial_);
    return true;
  }

  HullBuilder& builder_;
  const TriangleHull& original_;
  std::optional<Mirror> mirror_;
  TriangleHull& hull_;
  double diagonal_;
  std::vector<std::vector<std::uint32_t>> around_;  ///< Triangles at each vertex.
  std::map<EdgeKey, Found> known_;
  TriangleHull trial_;
  std::vector<glm::dvec3> points_;
};

}  // namespace

bool collapseEdges(HullBuilder& builder, const TriangleHull& original, const CollapseDef& definition,
                   TriangleHull& hull) {
  Collapser collapser(builder, original, definition.mirror, hull);
  while (!collapser.isDone(definition.maxVertices)) {
    if (!collapser.step()) return false;
  }
  return true;
}

}  // namespace scatter::levels
