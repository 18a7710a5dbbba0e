#include "viewer/mesh_refinement.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <map>
#include <utility>
#include <vector>

namespace scatter::viewer {
namespace {

using Corners = std::array<std::uint32_t, 3>;

class Refiner {
 public:
  Refiner(const MeshData& mesh, float longest, std::size_t maxTriangles)
      : longest_(longest), maxTriangles_(maxTriangles) {
    result_.positions = mesh.positions;
    result_.normals = mesh.normals;
    result_.twoSided = mesh.twoSided;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
      open_.push_back({mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]});
  }

  MeshData run() {
    std::size_t done = 0;
    while (!open_.empty()) {
      Corners triangle = open_.back();
      open_.pop_back();
      turnLongestFirst(triangle);
      const auto [a, b, c] = triangle;
      if (lengthOf(a, b) <= longest_ || done + open_.size() >= maxTriangles_) {
        result_.indices.insert(result_.indices.end(), {a, b, c});
        ++done;
        continue;
      }
      const std::uint32_t middle = middleOf(a, b);
      open_.push_back({a, middle, c});
      open_.push_back({middle, b, c});
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] float lengthOf(std::uint32_t a, std::uint32_t b) const {
    return glm::distance(result_.positions[a], result_.positions[b]);
  }

  /// So that the first edge is the longest.
  void turnLongestFirst(Corners& triangle) const {
    for (int turn = 0; turn < 2; ++turn) {
      const auto [a, b, c] = triangle;
      if (lengthOf(a, b) >= std::max(lengthOf(b, c), lengthOf(c, a))) return;
      triangle = {b, c, a};
    }
  }

  /// Both triangles of an edge get the same.
  std::uint32_t middleOf(std::uint32_t a, std::uint32_t b) {
    const auto next = static_cast<std::uint32_t>(result_.positions.size());
    const auto [known, isNew] = middles_.try_emplace(std::minmax(a, b), next);
    if (!isNew) return known->second;
    const Vec3 sum = result_.normals[a] + result_.normals[b];
    const float length = glm::length(sum);
    result_.positions.push_back(0.5F * (result_.positions[a] + result_.positions[b]));
    result_.normals.push_back(length > 0.0F ? sum / length : result_.normals[a]);
    return next;
  }

  float longest_;
  std::size_t maxTriangles_;
  MeshData result_;
  std::vector<Corners> open_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles_;
};

}  // namespace

MeshData refined(const MeshData& mesh, float longest, std::size_t maxTriangles) {
  return Refiner(mesh, longest, maxTriangles).run();
}

}  // namespace scatter::viewer
