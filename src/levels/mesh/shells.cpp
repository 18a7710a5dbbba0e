#include "levels/mesh/shells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <string>
#include <utility>
#include <vector>

#include "levels/mesh/even_points.h"
#include "levels/mesh/triangle.h"

namespace scatter::levels {
namespace {

/// How far beside a triangle its sides are looked at, as a share of the diagonal.
constexpr double kBeside = 1e-3;

/// A side is told apart if its winding number is this close to a whole number.
constexpr double kClear = 0.25;

/// Share of the area whose sides must be told apart in a solid mesh.
constexpr double kSolidShare = 0.8;
constexpr std::size_t kSideSamples = 1000;

/// An edge of a triangle; `isForward` if the triangle runs from the lower to the higher vertex.
struct Edge {
  std::uint32_t low = 0;
  std::uint32_t high = 0;
  std::uint32_t triangle = 0;
  bool isForward = false;
};

std::vector<Edge> sortedEdges(const WorkMesh& mesh) {
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle& t = mesh.triangles[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = t[k];
      const std::uint32_t to = t[(k + 1) % 3];
      if (from != to) edges.push_back({std::min(from, to), std::max(from, to), i, from < to});
    }
  }
  const auto ends = [](const Edge& edge) { return std::uint64_t{edge.low} << 32U | edge.high; };
  std::sort(edges.begin(), edges.end(), [&ends](const Edge& a, const Edge& b) {
    return ends(a) != ends(b) ? ends(a) < ends(b) : a.triangle < b.triangle;
  });
  return edges;
}

/// Calls `visit` with each run of edges between the same vertices.
template <class Visit>
void forEachEdge(const std::vector<Edge>& edges, const Visit& visit) {
  for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
    while (last < edges.size() && edges[last].low == edges[first].low &&
           edges[last].high == edges[first].high) {
      ++last;
    }
    visit(first, last);
  }
}

bool isClosed(const std::vector<Edge>& edges) {
  bool isBalanced = true;
  forEachEdge(edges, [&](std::size_t first, std::size_t last) {
    std::ptrdiff_t balance = 0;
    for (std::size_t i = first; i < last; ++i) balance += edges[i].isForward ? 1 : -1;
    isBalanced = isBalanced && balance == 0;
  });
  return isBalanced;
}

/// Triangles that hang together through edges of two.
struct Shell {
  std::vector<std::uint32_t> triangles;
  double volume = 0.0;  ///< Signed; of an open shell, closed by a fan to the middle of the mesh.
};

struct Link {
  std::uint32_t triangle = 0;
  bool isTurned = false;  ///< The two triangles run along their edge the same way.
};

std::vector<std::vector<Link>> linkTriangles(const std::vector<Edge>& edges, std::size_t triangleCount) {
  std::vector<std::vector<Link>> links(triangleCount);
  forEachEdge(edges, [&](std::size_t first, std::size_t last) {
    if (last - first != 2) return;
    const Edge& a = edges[first];
    const Edge& b = edges[first + 1];
    links[a.triangle].push_back({b.triangle, a.isForward == b.isForward});
    links[b.triangle].push_back({a.triangle, a.isForward == b.isForward});
  });
  return links;
}

class Orienter {
 public:
  explicit Orienter(WorkMesh& mesh) : mesh_(mesh) {}

  /// Splits the mesh into shells and turns their triangles to agree with most of their area.
  std::vector<Shell> agree() {
    const std::size_t count = mesh_.triangles.size();
    links_ = linkTriangles(sortedEdges(mesh_), count);
    isSeen_.assign(count, false);
    isTurned_.assign(count, false);
    std::vector<Shell> shells;
    for (std::uint32_t i = 0; i < count; ++i) {
      if (!isSeen_[i]) shells.push_back(gather(i));
    }
    return shells;
  }

  void turn(const Shell& shell) {
    for (const std::uint32_t i : shell.triangles) std::swap(mesh_.triangles[i][1], mesh_.triangles[i][2]);
  }

  [[nodiscard]] std::size_t turnedTriangles() const { return turnedTriangles_; }

 private:
  Shell gather(std::uint32_t start) {
    Shell shell;
    shell.triangles.push_back(start);
    isSeen_[start] = true;
    double turnedArea = 0.0;
    double area = 0.0;
    for (std::size_t next = 0; next < shell.triangles.size(); ++next) {
      const std::uint32_t i = shell.triangles[next];
      const double own = glm::length(vectorOf(i));
      area += own;
      if (isTurned_[i]) turnedArea += own;
      for (const Link& link : links_[i]) {
        if (isSeen_[link.triangle]) continue;
        isSeen_[link.triangle] = true;
        isTurned_[link.triangle] = isTurned_[i] != link.isTurned;
        shell.triangles.push_back(link.triangle);
      }
    }
    const bool isMostTurned = turnedArea > 0.5 * area;
    for (const std::uint32_t i : shell.triangles) {
      if (isTurned_[i] != isMostTurned) {
        std::swap(mesh_.triangles[i][1], mesh_.triangles[i][2]);
        ++turnedTriangles_;
      }
      shell.volume += glm::dot(vectorOf(i), mesh_.vertices[mesh_.triangles[i][0]] - middle_) / 3.0;
    }
    return shell;
  }

  [[nodiscard]] glm::dvec3 vectorOf(std::uint32_t i) const {
    const Triangle& t = mesh_.triangles[i];
    return areaVector(mesh_.vertices[t[0]], mesh_.vertices[t[1]], mesh_.vertices[t[2]]);
  }

  WorkMesh& mesh_;
  glm::dvec3 middle_ = 0.5 * (mesh_.bounds.min + mesh_.bounds.max);
  std::vector<std::vector<Link>> links_;
  std::vector<bool> isSeen_;
  std::vector<bool> isTurned_;
  std::size_t turnedTriangles_ = 0;
};

/// The winding numbers on the two sides of a triangle.
struct Sides {
  double front = 0.0;
  double back = 0.0;
  double area = 0.0;
};

/// At a point of a triangle as evenInTriangle() gives it.
Sides sidesOf(const WorkMesh& mesh, const MeshTree& tree, std::uint32_t triangle,
              const glm::dvec2& at = glm::dvec2(1.0 / 3.0)) {
  const Triangle& t = mesh.triangles[triangle];
  const glm::dvec3& a = mesh.vertices[t[0]];
  const glm::dvec3& b = mesh.vertices[t[1]];
  const glm::dvec3& c = mesh.vertices[t[2]];
  const glm::dvec3 vector = areaVector(a, b, c);
  const double area = glm::length(vector);
  if (!(area > 0.0)) return {};
  const double beside = std::min(kBeside * mesh.diagonal, 0.1 * std::sqrt(area));
  const glm::dvec3 step = vector * (beside / area);
  const glm::dvec3 point = a + at.x * (b - a) + at.y * (c - a);
  return {tree.winding(point + step), tree.winding(point - step), area};
}

std::uint32_t largestTriangle(const WorkMesh& mesh, const Shell& shell) {
  std::uint32_t largest = shell.triangles.front();
  double most = -1.0;
  for (const std::uint32_t i : shell.triangles) {
    const Triangle& t = mesh.triangles[i];
    const double area = triangleArea(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
    if (area > most) {
      most = area;
      largest = i;
    }
  }
  return largest;
}

/// Whether both sides of most of the area are clearly inside or outside.
bool enclosesVolume(const WorkMesh& mesh, const MeshTree& tree) {
  const std::size_t stride = std::max<std::size_t>(1, mesh.triangles.size() / kSideSamples);
  double clear = 0.0;
  double total = 0.0;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += stride) {
    const Sides sides = sidesOf(mesh, tree, static_cast<std::uint32_t>(i));
    total += sides.area;
    const bool isClear = std::abs(sides.back - std::round(sides.back)) < kClear && sides.back > 0.5;
    if (isClear) clear += sides.area;
  }
  return total > 0.0 && clear >= kSolidShare * total;
}

/// What was turned.
struct Turned {
  bool isAll = false;      ///< Every shell, before single ones were.
  std::size_t shells = 0;  ///< How many, all in all.
};

/// Turns the shells whose outside is not inside of others.
Turned turnInsideOut(WorkMesh& mesh, Orienter& orienter, const std::vector<Shell>& shells) {
  double volume = 0.0;
  for (const Shell& shell : shells) volume += shell.volume;
  Turned turned;
  const bool isAllTurned = volume < 0.0;
  if (isAllTurned) {
    for (const Shell& shell : shells) orienter.turn(shell);
    turned = {true, shells.size()};
  }
  const auto isNegative = [&](const Shell& shell) {
    return (isAllTurned ? -shell.volume : shell.volume) <
           -1e-12 * mesh.diagonal * mesh.diagonal * mesh.diagonal;
  };
  if (std::none_of(shells.begin(), shells.end(), isNegative)) return turned;
  // The normals of a cavity point into it, away from the material around it.
  const MeshTree tree(mesh);
  for (const Shell& shell : shells) {
    if (!isNegative(shell) || sidesOf(mesh, tree, largestTriangle(mesh, shell)).back > 0.5) continue;
    orienter.turn(shell);
    ++turned.shells;
  }
  return turned;
}

void noteOrientation(WorkMesh& mesh, std::size_t triangles, std::size_t shells) {
  if (triangles > 0)
    mesh.notes.push_back(std::to_string(triangles) + " triangles turned to face as their neighbours");
  if (shells > 0) mesh.notes.push_back(std::to_string(shells) + " inside-out shells turned");
}

/// Shells that are covered by others but for what stands on or leans against their sides.
std::size_t countSwallowed(const WorkMesh& mesh, const MeshTree& tree, const std::vector<Shell>& shells) {
  constexpr std::size_t kLooks = 24;
  constexpr double kCovered = 0.8;
  return static_cast<std::size_t>(std::count_if(shells.begin(), shells.end(), [&](const Shell& shell) {
    if (!(shell.volume > 0.0) || shells.size() < 2) return false;
    const std::size_t stride = 1 + shell.triangles.size() / kLooks;
    double covered = 0.0;
    double looked = 0.0;
    for (std::size_t i = 0; i < shell.triangles.size(); i += stride) {
      looked += 1.0;
      if (sidesOf(mesh, tree, shell.triangles[i]).front > 0.5) covered += 1.0;
    }
    return covered >= kCovered * looked;
  }));
}

}  // namespace

double MeshSpace::distance(const glm::dvec3& point) const {
  return isInside(point) ? 0.0 : tree.distance(point);
}

bool MeshSpace::isSimple() const {
  // Of the area: triangles whose sides are too near to others to be told apart.
  constexpr double kDoubt = 0.002;
  // Of a large mesh, and more of its larger triangles.
  constexpr double kSamples = 4000.0;
  double total = 0.0;
  for (const Triangle& t : mesh.triangles)
    total += triangleArea(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
  double due = 0.0;
  double within = 0.0;
  double looked = 0.0;
  std::size_t sample = 0;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle& t = mesh.triangles[i];
    due += kSamples * triangleArea(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]) / total;
    for (; due >= 1.0; due -= 1.0) {
      const Sides sides = sidesOf(mesh, tree, i, evenInTriangle(sample++));
      looked += 1.0;
      if (sides.front > 0.5 && sides.back > 0.5) within += 1.0;
    }
  }
  return within <= kDoubt * looked;
}

bool MeshSpace::isInside(const glm::dvec3& point) const {
  return isSolid && tree.winding(point) > 0.5;
}

MeshSpace makeMeshSpace(WorkMesh mesh, MeshInterior interior) {
  Orienter orienter(mesh);
  const std::vector<Shell> shells = orienter.agree();
  const Turned turned = turnInsideOut(mesh, orienter, shells);
  noteOrientation(mesh, orienter.turnedTriangles(), turned.shells);

  const bool closed = isClosed(sortedEdges(mesh));
  MeshTree tree(mesh);
  bool isSolid = interior == MeshInterior::kSolid;
  if (interior == MeshInterior::kAutomatic) isSolid = closed || enclosesVolume(mesh, tree);
  if (!closed) {
    mesh.notes.emplace_back(isSolid
                                ? "the mesh is not closed, but taken as solid: its holes are bridged"
                                : "the mesh is not closed and taken as a surface: both sides are outside");
  }
  if (const std::size_t swallowed = isSolid ? countSwallowed(mesh, tree, shells) : 0; swallowed > 0) {
    mesh.notes.push_back(
        std::to_string(swallowed) +
        " of its shells lie inside of others, where nothing can touch them; if the mesh is a "
        "room, its interior is a surface");
  }
  const bool wasInsideOut = turned.isAll && (closed || isSolid);
  return {std::move(mesh), std::move(tree), closed, isSolid, wasInsideOut};
}

}  // namespace scatter::levels
