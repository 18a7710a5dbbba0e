#include "levels/mesh/work_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <utility>

#include "levels/part_check.h"
#include "levels/text.h"

namespace scatter::levels {
namespace {

constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();

/// Sizes, in metres, for which volumes and moments of parts fit into a float.
constexpr double kSmallest = 1e-6;
constexpr double kLargest = 1e9;

/// Sizes, in metres, that few objects have.
constexpr double kUnlikelySmall = 1e-3;
constexpr double kUnlikelyLarge = 1e4;

/// A mesh further from zero than this many diagonals is moved there.
constexpr double kFar = 2.0;

std::string countText(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

Result<void> checkTriangles(const SurfaceMesh& mesh) {
  if (mesh.triangles.empty()) return fail("the mesh has no triangles");
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const std::uint32_t vertex : mesh.triangles[i]) {
      if (vertex >= mesh.vertices.size()) {
        return fail("triangle " + std::to_string(i + 1) + " refers to vertex " + std::to_string(vertex + 1) +
                    ", but the mesh has " + std::to_string(mesh.vertices.size()));
      }
      if (isFinite(mesh.vertices[vertex])) continue;
      return fail("vertex " + std::to_string(vertex + 1) + " " + toText(mesh.vertices[vertex]) +
                  " is not finite");
    }
  }
  return {};
}

/// For each vertex the index among those that differ, in the order of their first use; kUnused if no
/// triangle uses it.
std::vector<std::uint32_t> weldedIndices(const SurfaceMesh& mesh, std::vector<std::uint32_t>& kept) {
  std::vector<std::uint32_t> order(mesh.vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](std::uint32_t i) {
    const Vec3& v = mesh.vertices[i];
    return std::array<float, 3>{v.x, v.y, v.z};
  };
  std::vector<bool> isUsed(mesh.vertices.size(), false);
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle) isUsed[vertex] = true;
  }
  std::erase_if(order, [&](std::uint32_t i) { return !isUsed[i]; });
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t i, std::uint32_t j) { return std::pair(key(i), i) < std::pair(key(j), j); });

  std::vector<std::uint32_t> first(mesh.vertices.size(), kUnused);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool isSame = i > 0 && key(order[i]) == key(order[i - 1]);
    first[order[i]] = isSame ? first[order[i - 1]] : order[i];
  }
  std::vector<std::uint32_t> indices(mesh.vertices.size(), kUnused);
  for (std::uint32_t i = 0; i < first.size(); ++i) {
    if (first[i] == kUnused) continue;
    if (first[i] == i) {
      indices[i] = static_cast<std::uint32_t>(kept.size());
      kept.push_back(i);
    }
    indices[i] = indices[first[i]];
  }
  return indices;
}

Triangle sorted(Triangle triangle) {
  std::sort(triangle.begin(), triangle.end());
  return triangle;
}

bool isPoint(const Triangle& t) {
  return t[0] == t[1] && t[1] == t[2];
}
bool isDegenerate(const Triangle& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// Leaves out triangles with the corners of another one; gives their number.
std::size_t dropRepeated(std::vector<Triangle>& triangles) {
  std::vector<std::pair<Triangle, std::uint32_t>> order;
  order.reserve(triangles.size());
  for (const Triangle& triangle : triangles)
    order.emplace_back(sorted(triangle), static_cast<std::uint32_t>(order.size()));
  std::sort(order.begin(), order.end());
  std::vector<bool> isRepeated(triangles.size(), false);
  for (std::size_t i = 1; i < order.size(); ++i) {
    isRepeated[order[i].second] = order[i].first == order[i - 1].first;
  }
  std::size_t next = 0;
  return std::erase_if(triangles, [&](const Triangle&) { return isRepeated[next++]; });
}

/// Leaves out triangles without area that are an edge or a corner of another one; gives their number. Those
/// that stand alone are kept: they must be enclosed, too.
std::size_t dropDegenerate(std::vector<Triangle>& triangles, std::size_t vertexCount) {
  if (std::none_of(triangles.begin(), triangles.end(), isDegenerate)) return 0;
  using Segment = std::array<std::uint32_t, 2>;
  std::vector<Segment> edges;
  std::vector<bool> isCorner(vertexCount, false);
  for (const Triangle& t : triangles) {
    if (isDegenerate(t)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      edges.push_back({std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])});
      isCorner[t[k]] = true;
    }
  }
  std::sort(edges.begin(), edges.end());
  return std::erase_if(triangles, [&](const Triangle& t) {
    if (!isDegenerate(t)) return false;
    if (isPoint(t)) return static_cast<bool>(isCorner[t[0]]);
    const Triangle s = sorted(t);
    return std::binary_search(edges.begin(), edges.end(), Segment{s.front(), s.back()});
  });
}

/// Fails on sizes that have no useful levels; notes those that a wrong unit could explain.
Result<void> checkSize(WorkMesh& work) {
  const std::string size = "the mesh is " + toText(work.diagonal) + " m across";
  if (!(work.diagonal > 0.0)) return fail("all vertices of the mesh are at one point");
  if (work.diagonal < kSmallest || work.diagonal > kLargest) {
    return fail(size + "; levels are made for 1e-6 to 1e9 m: scale it");
  }
  if (work.diagonal < kUnlikelySmall || work.diagonal > kUnlikelyLarge) {
    work.notes.push_back(size + "; if its unit is not the metre, scale it");
  }
  return {};
}

void placeVertices(const SurfaceMesh& mesh, const std::vector<std::uint32_t>& kept, WorkMesh& work) {
  DoubleBounds bounds;
  for (const std::uint32_t i : kept) bounds.add(glm::dvec3(mesh.vertices[i]));
  work.diagonal = glm::length(bounds.max - bounds.min);
  const glm::dvec3 middle = 0.5 * (bounds.min + bounds.max);
  if (glm::length(middle) > kFar * work.diagonal) {
    work.origin = Vec3(middle);
    work.notes.push_back("the mesh is far from the origin: the parts are placed at " + toText(work.origin));
  }
  work.vertices.reserve(kept.size());
  for (const std::uint32_t i : kept) {
    work.vertices.push_back(glm::dvec3(mesh.vertices[i]) - glm::dvec3(work.origin));
    work.bounds.add(work.vertices.back());
  }
}

}  // namespace

Result<WorkMesh> makeWorkMesh(const SurfaceMesh& mesh) {
  if (const Result<void> sound = checkTriangles(mesh); !sound) return fail(sound.error().message);
  WorkMesh work;
  std::vector<std::uint32_t> kept;
  const std::vector<std::uint32_t> indices = weldedIndices(mesh, kept);
  placeVertices(mesh, kept, work);
  if (const Result<void> sound = checkSize(work); !sound) return fail(sound.error().message);

  work.triangles.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles)
    work.triangles.push_back({indices[t[0]], indices[t[1]], indices[t[2]]});
  const auto used = static_cast<std::size_t>(
      std::count_if(indices.begin(), indices.end(), [](auto i) { return i != kUnused; }));
  if (used > kept.size())
    work.notes.push_back(std::to_string(used - kept.size()) + " repeated vertices welded");
  if (const std::size_t count = dropRepeated(work.triangles); count > 0) {
    work.notes.push_back(countText(count, "repeated triangle") + " left out");
  }
  if (const std::size_t count = dropDegenerate(work.triangles, kept.size()); count > 0) {
    work.notes.push_back(countText(count, "triangle") + " without area left out: others hold them");
  }
  return work;
}

}  // namespace scatter::levels
