#include "levels/convex_hull.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>
#include <string>
#include <vector>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace scatter::levels {
namespace {

/// Sets no thicker than this share of their extent count as flat.
constexpr double kFlatness = 1e-6;

/// Takes qhull's messages, which would otherwise go to stderr.
class MessageSink {
 public:
  MessageSink() : file_(open_memstream(&text_, &size_)) {}
  MessageSink(const MessageSink&) = delete;
  MessageSink& operator=(const MessageSink&) = delete;
  ~MessageSink() {
    if (file_ != nullptr) std::fclose(file_);
    std::free(text_);
  }

  [[nodiscard]] FILE* file() const { return file_; }

 private:
  char* text_ = nullptr;
  std::size_t size_ = 0;
  FILE* file_ = nullptr;
};

/// One run of qhull and its memory.
class HullRun {
 public:
  HullRun() { qh_zero(&state_, sink_.file()); }
  HullRun(const HullRun&) = delete;
  HullRun& operator=(const HullRun&) = delete;
  ~HullRun() {
    qh_freeqhull(&state_, False);
    int blocks = 0;
    int bytes = 0;
    qh_memfreeshort(&state_, &blocks, &bytes);
  }

  bool run(std::vector<double>& coordinates, const char* options) {
    if (sink_.file() == nullptr) return false;
    std::string command = options;
    const int count = static_cast<int>(coordinates.size() / 3);
    return qh_new_qhull(&state_, 3, count, coordinates.data(), False, command.data(), nullptr,
                        sink_.file()) == 0;
  }

  [[nodiscard]] Polytope polytope(std::span<const glm::dvec3> points) {
    Polytope result;
    std::vector<std::uint32_t> indices(points.size(), std::numeric_limits<std::uint32_t>::max());
    for (const vertexT* vertex = state_.vertex_list; vertex != nullptr && vertex->next != nullptr;
         vertex = vertex->next) {
      const std::size_t point = pointOf(vertex);
      indices[point] = result.addVertex(points[point]);
    }
    for (const facetT* facet = state_.facet_list; facet != nullptr && facet->next != nullptr;
         facet = facet->next) {
      addFacet(*facet, indices, result);
    }
    return result;
  }

 private:
  std::size_t pointOf(const vertexT* vertex) {
    return static_cast<std::size_t>(qh_pointid(&state_, vertex->point));
  }

  void addFacet(const facetT& facet, const std::vector<std::uint32_t>& indices, Polytope& result) {
    if (facet.normal == nullptr || facet.vertices == nullptr) return;
    std::vector<std::uint32_t> members;
    for (const setelemT* element = facet.vertices->e; element->p != nullptr; ++element) {
      members.push_back(indices[pointOf(static_cast<const vertexT*>(element->p))]);
    }
    HalfSpace plane{{facet.normal[0], facet.normal[1], facet.normal[2]}, 0.0};
    plane.normal = glm::normalize(plane.normal);
    // The plane must hold all vertices, although merged facets are only flat to within rounding.
    plane.offset = -std::numeric_limits<double>::infinity();
    for (const glm::dvec3& vertex : result.vertices()) {
      plane.offset = std::max(plane.offset, glm::dot(plane.normal, vertex));
    }
    result.addFace(plane, std::move(members));
  }

  MessageSink sink_;
  qhT state_{};
};

/// The point with the largest value of `measure`.
template <class Measure>
glm::dvec3 extreme(std::span<const glm::dvec3> points, const Measure& measure) {
  return *std::max_element(
      points.begin(), points.end(),
      [&measure](const glm::dvec3& a, const glm::dvec3& b) { return measure(a) < measure(b); });
}

bool isFlat(std::span<const glm::dvec3> points, double rounding) {
  const glm::dvec3 a = points.front();
  const glm::dvec3 b = extreme(points, [&a](const glm::dvec3& p) { return glm::length(p - a); });
  const double length = glm::length(b - a);
  const double least = kFlatness * length + rounding;
  if (length <= least) return true;

  const glm::dvec3 along = (b - a) / length;
  const glm::dvec3 c =
      extreme(points, [&](const glm::dvec3& p) { return glm::length(glm::cross(along, p - a)); });
  const glm::dvec3 across = glm::cross(along, c - a);
  if (glm::length(across) <= least) return true;

  const glm::dvec3 normal = glm::normalize(across);
  const glm::dvec3 d =
      extreme(points, [&](const glm::dvec3& p) { return std::abs(glm::dot(normal, p - a)); });
  return std::abs(glm::dot(normal, d - a)) <= least;
}

}  // namespace

Result<Polytope> convexHull(std::span<const glm::dvec3> points, double rounding) {
  const std::string count = "its " + std::to_string(points.size()) + " vertices ";
  if (points.size() < 4) return fail(count + "are fewer than 4");
  if (isFlat(points, rounding)) return fail(count + "lie in one plane");

  std::vector<double> coordinates;
  coordinates.reserve(3 * points.size());
  for (const glm::dvec3& p : points) {
    for (int axis = 0; axis < 3; ++axis) coordinates.push_back(p[axis] - points.front()[axis]);
  }
  // Joggled input (QJ) is the way out of degeneracies that merging facets cannot mend.
  for (const char* options : {"qhull Pp", "qhull QJ Pp"}) {
    HullRun hull;
    if (!hull.run(coordinates, options)) continue;
    Polytope polytope = hull.polytope(points);
    if (!polytope.isEmpty() && polytope.moments().volume > 0.0) return polytope;
  }
  return fail(count + "have no hull that rounding leaves intact");
}

}  // namespace scatter::levels
