#include <scatter/levels/containment.h>
#include <scatter/levels/level_check.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <string>
#include <utility>
#include <variant>

#include "levels/check/mesh_enclosure.h"
#include "levels/check/solid_part.h"
#include "levels/part_check.h"
#include "levels/part_geometry.h"
#include "levels/text.h"

namespace scatter {
namespace levels {
namespace {

constexpr double kRelativeTolerance = 1e-5;
constexpr double kResolution = 1e-4;

using Solids = std::vector<SolidPart>;

/// How far the coarse part would have to grow to hold the fine one, margins counted; negative if it does.
double excess(const SolidPart& coarse, double coarseMargin, const RoundedHull& fine) {
  // A margin at most the coarse part's own cancels against it; what is left of it rounds the fine part.
  const double own = std::max(0.0, fine.radius - coarseMargin);
  return coarse.depthOutside(fine.points) + own;
}

/// Whether each part of a level lies in the coarser one.
Result<EnclosureCheck> checkPair(const Level& finer, const Level& coarser, const Solids& coarseSolids,
                                 float hullMargin, double tolerance) {
  const auto margin = static_cast<double>(hullMargin);
  EnclosureCheck result;
  result.count = finer.parts.size();
  double clearance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < finer.parts.size(); ++i) {
    const RoundedHull fine = roundedHull(finer.parts[i], margin);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < coarseSolids.size(); ++k) {
      least = std::min(least, excess(coarseSolids[k], marginOf(coarser.parts[k], margin), fine));
    }
    if (least <= tolerance) {
      clearance = std::min(clearance, -least);
      continue;
    }
    const auto gap =
        findContainmentGap(Level{{finer.parts[i]}}, coarser, hullMargin, static_cast<float>(tolerance));
    if (!gap) return fail(gap.error().message);
    ++(gap->has_value() ? result.outside : result.shared);
    if (!gap->has_value()) continue;
    const auto distance = static_cast<double>((*gap)->distance);
    if (!result.worst || distance > result.worst->distance) {
      result.worst = Protrusion{i, (*gap)->point, distance};
    }
  }
  result.clearance = clearance < std::numeric_limits<double>::infinity() ? clearance : 0.0;
  return result;
}

double diagonalOf(const Solids& solids) {
  DoubleBounds bounds;
  for (const SolidPart& solid : solids) {
    bounds.add(solid.bounds().min);
    bounds.add(solid.bounds().max);
  }
  return glm::length(bounds.max - bounds.min);
}

Result<void> checkMesh(const SurfaceMesh& mesh) {
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      if (corner >= mesh.vertices.size()) {
        return fail("mesh: a triangle names vertex " + std::to_string(corner) + " of " +
                    std::to_string(mesh.vertices.size()));
      }
      if (!isFinite(mesh.vertices[corner])) {
        return fail("mesh: vertex " + std::to_string(corner) + " is not finite");
      }
    }
  }
  return {};
}

Result<void> checkNumber(double value, const char* name) {
  if (std::isfinite(value) && value >= 0.0) return {};
  return fail(std::string(name) + " " + toText(value) + " must be finite and not negative");
}

Result<std::vector<Solids>> allSolids(const std::vector<Level>& levels) {
  std::vector<Solids> all;
  for (const Level& level : levels) {
    const std::string where = "level " + std::to_string(all.size() + 1);
    if (level.parts.empty()) return fail(where + " has no parts; give at least one");
    Result<Solids> solids = solidParts(level.parts);
    if (!solids) return fail(where + ", " + solids.error().message);
    all.push_back(std::move(*solids));
  }
  return all;
}

}  // namespace
}  // namespace levels

bool LevelCheck::passed() const {
  const auto holds = [](const EnclosureCheck& check) { return check.outside == 0; };
  return (!mesh || holds(*mesh)) && std::all_of(levels.begin(), levels.end(), holds);
}

Result<LevelCheck> checkLevels(const std::vector<Level>& levels, float hullMargin, const SurfaceMesh* mesh,
                               const LevelCheckDef& definition) {
  using namespace levels;
  if (levels.empty()) return fail("has no levels; give at least one");
  if (auto sound = checkNumber(static_cast<double>(hullMargin), "hull margin"); !sound)
    return fail(sound.error().message);
  if (auto sound = checkNumber(definition.tolerance.value_or(0.0), "tolerance"); !sound)
    return fail(sound.error().message);
  const Result<std::vector<Solids>> solids = allSolids(levels);
  if (!solids) return fail(solids.error().message);

  const double diagonal = diagonalOf(solids->back());
  LevelCheck result;
  result.tolerance = definition.tolerance.value_or(kRelativeTolerance * diagonal);
  if (mesh != nullptr) {
    if (auto sound = checkMesh(*mesh); !sound) return fail(sound.error().message);
    // Cutting without any tolerance would leave slivers of rounding.
    const double tolerance = std::max(result.tolerance, 1e-12 * diagonal);
    result.mesh =
        checkMeshInside(*mesh, solids->back(), tolerance, std::max(tolerance, kResolution * diagonal));
  }
  for (std::size_t i = 1; i < levels.size(); ++i) {
    auto pair = checkPair(levels[i], levels[i - 1], (*solids)[i - 1], hullMargin, result.tolerance);
    if (!pair)
      return fail("level " + std::to_string(i + 1) + " in level " + std::to_string(i) + ": " +
                  pair.error().message);
    result.levels.push_back(*pair);
  }
  return result;
}

}  // namespace scatter
