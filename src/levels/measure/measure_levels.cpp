#include <scatter/levels/mass_properties.h>
#include <scatter/levels/measure_levels.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <utility>
#include <variant>

#include "levels/measure/level_surface.h"
#include "levels/mesh/region_map.h"
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
    figures.mass = *mass;
    figures.partVolume = static_cast<double>(mass->properties.volume * (1.0F + mass->shared));
  }
}

/// A point of a level, and how far the mesh is from it.
struct Place {
  glm::dvec3 point{0.0};
  double distance = 0.0;
  double gap = 0.0;  ///< With the margin that reaches further than the point.
};

/// Of the points where a level collides: the surface of its parts, moved out by their margin.
class Gaps {
 public:
  Gaps(const LevelSurface& surface, const MeshSpace& space, double hullMargin)
      : surface_(surface), space_(space), hullMargin_(hullMargin) {}

  /// Those of the samples that are exposed.
  [[nodiscard]] std::vector<Place> at(const std::vector<LevelSurface::Sample>& samples) const {
    std::vector<Place> places;
    for (const LevelSurface::Sample& sample : samples) {
      const double margin = surface_.marginOf(sample.part, hullMargin_);
      const glm::dvec3 point = sample.point + margin * sample.normal;
      // The margin of another part is not counted on to hide a point.
      if (surface_.isCovered(point, kHidden * space_.mesh.diagonal, sample.part)) continue;
      // Around a corner the margin reaches as far in every direction, and so straight away from the mesh.
      const double around = sample.normal == glm::dvec3(0.0) ? margin : 0.0;
      const double distance = space_.tree.distance(point);
      const double gap = (space_.isInside(point) ? -1.0 : 1.0) * distance + around;
      if (gap >= 0.0) places.push_back({point, distance, gap});
    }
    return places;
  }

 private:
  const LevelSurface& surface_;
  const MeshSpace& space_;
  double hullMargin_;
};

/// Which places are looked at.
using Choice = std::function<bool(const Place& place)>;

/// Where a level is compared with the mesh.
struct LevelPlaces {
  std::vector<Place> samples;      ///< Evenly over the exposed surface.
  std::vector<Place> corners;      ///< Exposed. The furthest point of a flat-sided part may be one.
  std::vector<glm::dvec3> filled;  ///< Points that the level fills.
};

/// The largest distance to the mesh of points that a level fills and the mesh does not, where it exceeds
/// `atLeast`.
double deepestHollow(const std::vector<glm::dvec3>& filled, const MeshSpace& space, const Choice& isChosen,
                     double atLeast) {
  double deepest = atLeast;
  for (const glm::dvec3& point : filled) {
    if (space.tree.isWithin(point, deepest)) continue;
    const double distance = space.tree.distance(point);
    if (distance > deepest && !space.isInside(point) && isChosen({point, distance, distance}))
      deepest = distance;
  }
  return deepest;
}

GapFigures measureGaps(const LevelPlaces& places, const MeshSpace& space, const Choice& isChosen) {
  GapFigures figures;
  std::vector<double> gaps;
  for (const Place& place : places.samples) {
    if (isChosen(place)) gaps.push_back(place.gap);
  }
  std::sort(gaps.begin(), gaps.end());
  figures.samples = gaps.size();
  if (!gaps.empty()) {
    for (const double gap : gaps) figures.mean += gap / static_cast<double>(gaps.size());
    figures.p95 = gaps[gaps.size() * 95 / 100];
    figures.max = gaps.back();
  }
  for (const Place& place : places.corners) {
    if (place.gap > figures.max && isChosen(place)) figures.max = place.gap;
  }
  figures.max = deepestHollow(places.filled, space, isChosen, figures.max);
  return figures;
}

/// Of each region, and of what is in none.
std::vector<GapFigures> measureRegions(const LevelPlaces& places, const MeshSpace& space,
                                       const RegionMap& regions) {
  std::vector<GapFigures> all;
  if (regions.isEmpty()) return all;
  for (std::size_t i = 0; i < regions.count(); ++i) {
    all.push_back(measureGaps(places, space, [&regions, i](const Place& place) {
      return regions.holds(i, place.point, place.distance);
    }));
  }
  all.push_back(measureGaps(places, space, [&regions](const Place& place) {
    for (std::size_t i = 0; i < regions.count(); ++i) {
      if (regions.holds(i, place.point, place.distance)) return false;
    }
    return true;
  }));
  return all;
}

// Of an open mesh, whose holes are bridged, about.
double bridgedVolume(const WorkMesh& mesh) {
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
  const Result<RegionMap> regions = RegionMap::create(definition.regions, mesh, *work);
  if (!regions) return fail(regions.error().message);
  const MeshSpace space = makeMeshSpace(std::move(*work), definition.interior);
  LevelMeasures measures;
  measures.diagonal = space.mesh.diagonal;
  measures.isSolid = space.isSolid;
  measures.isInsideOut = space.isSolid && space.wasInsideOut;
  if (const auto mass = massOfMesh(space)) measures.meshMass = *mass;
  if (space.isSolid) {
    measures.meshVolume = measures.meshMass ? static_cast<double>(measures.meshMass->properties.volume)
                                            : bridgedVolume(space.mesh);
  }
  for (int index = 1; index <= levelSet.count(); ++index) {
    const Level& level = levelSet.level(index);
    LevelFigures figures;
    countParts(level, figures);
    const LevelSurface surface(level, glm::dvec3(space.mesh.origin));
    LevelSurface::Filling filling = surface.filling(definition.volumeSamples);
    figures.unionVolume = filling.volume;
    if (measures.meshVolume > 0.0) figures.volumeRatio = figures.unionVolume / measures.meshVolume;
    const Gaps exposed(surface, space, static_cast<double>(levelSet.hullMargin()));
    const LevelPlaces places{exposed.at(surface.samples(definition.surfaceSamples)),
                             exposed.at(surface.corners()), std::move(filling.points)};
    const GapFigures gaps = measureGaps(places, space, [](const Place&) { return true; });
    figures.meanGap = gaps.mean;
    figures.p95Gap = gaps.p95;
    figures.maxGap = gaps.max;
    figures.regionGaps = measureRegions(places, space, *regions);
    measures.levels.push_back(std::move(figures));
  }
  return measures;
}

}  // namespace scatter
