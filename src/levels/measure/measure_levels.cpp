#include <scatter/levels/mass_properties.h>
#include <scatter/levels/measure_levels.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>
#include <variant>

#include "levels/measure/level_surface.h"
#include "levels/mesh/shells.h"
#include "levels/mesh/work_mesh.h"

namespace scatter {
namespace levels {
namespace {

/// A point must be this deep in another part, as a share of the diagonal, not to be exposed: parts that
/// touch do not hide each other's faces.
constexpr double kHidden = 2e-7;

/// A part costs as much as a box if it has as many vertices.
constexpr double kBoxVertices = 8.0;

/// Bodies touch with their surfaces: of n parts, about n^(2/3) are near another body's.
constexpr double kNearParts = 2.0 / 3.0;

int vertexCount(const ConvexPart& part) {
  if (std::holds_alternative<Box>(part.shape)) return static_cast<int>(kBoxVertices);
  const auto* hull = std::get_if<ConvexHull>(&part.shape);
  return hull == nullptr ? 0 : static_cast<int>(hull->vertices.size());
}

void countParts(const Level& level, LevelFigures& figures) {
  double weight = 0.0;
  for (const ConvexPart& part : level.parts) {
    const int count = vertexCount(part);
    figures.vertices += count;
    if (std::holds_alternative<ConvexHull>(part.shape)) {
      figures.mostVertices = std::max(figures.mostVertices, count);
    }
    weight += count == 0 ? 1.0 : 0.5 * (1.0 + count / kBoxVertices);
  }
  figures.parts = static_cast<int>(level.parts.size());
  figures.predictedCost = std::pow(figures.parts, kNearParts) * weight / figures.parts;
  if (const auto mass = massOfUnion(level.parts)) {
    figures.partVolume = static_cast<double>(mass->properties.volume * (1.0F + mass->shared));
  }
}

/// Gaps at all exposed points.
std::vector<double> exposedGaps(const LevelSurface& surface, const MeshSpace& space,
                                const std::vector<LevelSurface::Sample>& samples) {
  std::vector<double> gaps;
  for (const LevelSurface::Sample& sample : samples) {
    if (surface.isCovered(sample.point, kHidden * space.mesh.diagonal, sample.part)) continue;
    if (!space.isInside(sample.point)) gaps.push_back(space.tree.distance(sample.point));
  }
  return gaps;
}

void measureGaps(const LevelSurface& surface, const MeshSpace& space, std::size_t sampleCount,
                 LevelFigures& figures) {
  std::vector<double> gaps = exposedGaps(surface, space, surface.samples(sampleCount));
  std::sort(gaps.begin(), gaps.end());
  if (!gaps.empty()) {
    for (const double gap : gaps) figures.meanGap += gap / static_cast<double>(gaps.size());
    figures.p95Gap = gaps[gaps.size() * 95 / 100];
    figures.maxGap = gaps.back();
  }
  // The furthest point of a flat-sided part from something convex is a corner.
  for (const double gap : exposedGaps(surface, space, surface.corners())) {
    figures.maxGap = std::max(figures.maxGap, gap);
  }
}

// Of an open mesh, whose holes are bridged, about.
double meshVolume(const MeshSpace& space) {
  if (const auto mass = massOfMesh(space)) return static_cast<double>(mass->properties.volume);
  const WorkMesh& mesh = space.mesh;
  double volume = 0.0;
  for (const Triangle& t : mesh.triangles) {
    volume += glm::dot(mesh.vertices[t[0]], glm::cross(mesh.vertices[t[1]], mesh.vertices[t[2]])) / 6.0;
  }
  return std::max(0.0, volume);
}

}  // namespace
}  // namespace levels

Result<LevelMeasures> measureLevels(const LevelSet& levelSet, const SurfaceMesh& mesh,
                                    const MeasureDef& definition) {
  using namespace levels;
  Result<WorkMesh> work = makeWorkMesh(mesh);
  if (!work) return fail(work.error().message);
  const MeshSpace space = makeMeshSpace(std::move(*work), definition.interior);
  LevelMeasures measures;
  measures.diagonal = space.mesh.diagonal;
  measures.isSolid = space.isSolid;
  if (space.isSolid) measures.meshVolume = meshVolume(space);
  for (int index = 1; index <= levelSet.count(); ++index) {
    const Level& level = levelSet.level(index);
    LevelFigures figures;
    countParts(level, figures);
    const LevelSurface surface(level, glm::dvec3(space.mesh.origin));
    figures.unionVolume = surface.unionVolume(definition.volumeSamples);
    if (measures.meshVolume > 0.0) figures.volumeRatio = figures.unionVolume / measures.meshVolume;
    measureGaps(surface, space, definition.surfaceSamples, figures);
    measures.levels.push_back(figures);
  }
  return measures;
}

}  // namespace scatter
