#include "levels/check/mesh_enclosure.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "levels/check/furthest_outside.h"
#include "levels/check/surface_pieces.h"

namespace scatter::levels {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

class MeshEnclosure {
 public:
  MeshEnclosure(const SurfaceMesh& mesh, std::span<const SolidPart> parts, double tolerance,
                double resolution)
      : mesh_(mesh), parts_(parts), tolerance_(tolerance), resolution_(resolution) {}

  EnclosureCheck check() {
    EnclosureCheck result;
    double area = 0.0;
    double areaOutside = 0.0;
    double clearance = kUnbounded;
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
      const Piece triangle = triangleAt(i);
      area += areaOf(triangle);
      const double depth = leastDepth(triangle);
      if (depth <= tolerance_) {
        clearance = std::min(clearance, -depth);
        continue;
      }
      const std::vector<Piece> left = cutAway(triangle, near_, tolerance_, resolution_);
      if (left.empty()) {
        ++result.shared;
        continue;
      }
      ++result.outside;
      for (const Piece& piece : left) areaOutside += areaOf(piece);
      note(i, left, result);
    }
    result.count = mesh_.triangles.size();
    result.clearance = clearance < kUnbounded ? clearance : 0.0;
    result.areaOutside = area > 0.0 ? std::min(1.0, areaOutside / area) : 0.0;
    return result;
  }

 private:
  [[nodiscard]] Piece triangleAt(std::size_t i) const {
    Piece corners;
    for (const std::uint32_t corner : mesh_.triangles[i]) corners.emplace_back(mesh_.vertices[corner]);
    return corners;
  }

  /// How far the part that holds the triangle best would have to grow. Leaves the parts near it in near_.
  double leastDepth(const Piece& triangle) {
    DoubleBounds bounds;
    for (const glm::dvec3& corner : triangle) bounds.add(corner);
    near_.clear();
    double least = kUnbounded;
    for (const SolidPart& part : parts_) {
      if (!part.bounds().overlaps(bounds, tolerance_)) continue;
      near_.push_back(&part);
      least = std::min(least, part.depthOutside(triangle));
    }
    return least;
  }

  void note(std::size_t triangle, const std::vector<Piece>& left, EnclosureCheck& result) {
    const double before = furthest_.distance;
    findFurthest(left, parts_, 0.01 * tolerance_, furthest_);
    if (furthest_.distance > before) {
      result.worst = Protrusion{triangle, Vec3(furthest_.point), furthest_.distance};
    }
  }

  const SurfaceMesh& mesh_;
  std::span<const SolidPart> parts_;
  double tolerance_;
  double resolution_;
  std::vector<const SolidPart*> near_;
  FarPoint furthest_;
};

}  // namespace

EnclosureCheck checkMeshInside(const SurfaceMesh& mesh, std::span<const SolidPart> parts, double tolerance,
                               double resolution) {
  return MeshEnclosure(mesh, parts, tolerance, resolution).check();
}

}  // namespace scatter::levels
