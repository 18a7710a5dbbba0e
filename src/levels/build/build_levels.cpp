#include <scatter/levels/build_levels.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "levels/build/distance_grid.h"
#include "levels/build/greedy_merge.h"
#include "levels/build/level_assembly.h"
#include "levels/build/merge_tree.h"
#include "levels/build/pre_merge.h"
#include "levels/build/symmetric_mesh.h"
#include "levels/mesh/region_map.h"
#include "levels/mesh/shells.h"
#include "levels/mesh/work_mesh.h"
#include "levels/text.h"

namespace scatter {
namespace levels {
namespace {

constexpr int kFewestVertices = 8;
constexpr int kMostVertices = 64;
constexpr int kMostLevels = 32;
constexpr int kMostParts = 4096;

constexpr int kGridCells = 64;
constexpr int kFineGridCells = 128;
/// Gaps below this share of the diagonal need the finer grid.
constexpr double kSmallGap = 0.01;

constexpr std::size_t kFewestPatches = 1024;
constexpr std::size_t kPatchesPerPart = 16;
constexpr std::size_t kMostPatches = 4096;

// A body stands by its margin above the floor, and with what else is off by less than 0.1 % of its diagonal.
// Detection costs no more than with larger ones (docs/levels.md, margins), but would where cores always
// overlap.
constexpr double kDefaultMargin = 0.02;
constexpr double kDefaultMarginShare = 5e-4;
// Of the gap that is asked for, so that parts have the most of it.
constexpr double kDefaultMarginOfGap = 0.25;

// Of the diagonal: thicker plates would no longer look like sheets.
constexpr double kSheetThicknessShare = 0.05;
constexpr double kThicknessOfGap = 0.5;

Result<void> checkCounts(const std::vector<int>& counts) {
  int last = 0;
  for (const int count : counts) {
    if (count <= last) {
      return fail("part counts must be positive and increase from the coarsest level to the finest; " +
                  std::to_string(count) + " does not follow " + std::to_string(last));
    }
    last = count;
  }
  if (last <= kMostParts) return {};
  return fail("part count " + std::to_string(last) + " exceeds " + std::to_string(kMostParts));
}

Result<void> checkRange(const std::string& what, int value, int low, int high) {
  if (value >= low && value <= high) return {};
  return fail(what + " must be " + std::to_string(low) + " to " + std::to_string(high) + ", not " +
              std::to_string(value));
}

Result<void> checkGap(const std::optional<float>& gap) {
  if (!gap || (std::isfinite(*gap) && *gap > 0.0F)) return {};
  return fail("the gap of the finest level must be positive and finite, not " +
              toText(static_cast<double>(*gap)));
}

Result<void> checkDefinition(const LevelBuildDef& definition) {
  std::vector<Result<void>> checks{
      checkCounts(definition.partCounts),
      checkRange("the number of levels", definition.levels, 1, kMostLevels),
      checkRange("the parts of the finest level", definition.finestParts, 1, kMostParts),
      checkRange("the most parts of a level", definition.maxParts, 1, kMostParts),
      checkRange("the vertices of a hull", definition.maxVertices, kFewestVertices, kMostVertices)};
  if (definition.finestGap) {
    checks.push_back(checkGap(definition.finestGap->metres));
    checks.push_back(checkGap(definition.finestGap->ofDiagonal));
    if (!definition.partCounts.empty())
      checks.emplace_back(fail("give either part counts or a gap, not both"));
    if (definition.finestGap->metres.has_value() == definition.finestGap->ofDiagonal.has_value()) {
      checks.emplace_back(fail("give the gap of the finest level either in metres or as a share"));
    }
  }
  if (definition.hullMargin && !(std::isfinite(*definition.hullMargin) && *definition.hullMargin >= 0.0F)) {
    checks.emplace_back(fail("the hull margin must be finite and not negative, not " +
                             toText(static_cast<double>(*definition.hullMargin))));
  }
  if (definition.thickness && !(std::isfinite(*definition.thickness) && *definition.thickness >= 0.0F)) {
    checks.emplace_back(fail("the thickness of sheets must be finite and not negative, not " +
                             toText(static_cast<double>(*definition.thickness))));
  }
  if (definition.maxTriangles == 0) checks.emplace_back(fail("the most triangles must be at least 1"));
  for (Result<void>& check : checks) {
    if (!check) return std::move(check);
  }
  return {};
}

/// Counts from 1 to `finest` in equal ratios, without repeats.
std::vector<int> countsUpTo(int finest, int levels) {
  if (levels == 1) return {finest};
  std::vector<int> counts;
  for (int i = 0; i < levels; ++i) {
    const double exponent = static_cast<double>(i) / (levels - 1);
    const int count = static_cast<int>(std::lround(std::pow(finest, exponent)));
    const int next = counts.empty() ? 1 : counts.back() + 1;
    counts.push_back(std::max(count, next));
  }
  while (counts.size() > 1 && counts[counts.size() - 2] >= finest) counts.pop_back();
  counts.back() = finest;
  return counts;
}

class Build {
 public:
  Build(const LevelBuildDef& definition, const BuildProgress& progress)
      : definition_(definition), progress_(progress) {}

  Result<BuiltLevels> run(const SurfaceMesh& mesh) {
    if (Result<void> sound = checkDefinition(definition_); !sound) return fail(sound.error().message);
    Result<WorkMesh> work = makeWorkMesh(mesh);
    if (!work) return fail(work.error().message);
    report("shells", 0.0);
    if (Result<void> found = findSymmetry(*work); !found) return fail(found.error().message);
    Result<RegionMap> regions = RegionMap::create(definition_.regions, mesh, *work);
    if (!regions) return fail(regions.error().message);
    regions_ = std::move(*regions);
    if (mirror_) regions_.countOnBothSides(mirror_->axis, kBulgeTolerance * work->diagonal);
    if (Result<void> fits = checkMargin(work->diagonal); !fits) return fail(fits.error().message);
    const MeshSpace space = makeMeshSpace(std::move(*work), definition_.interior);
    if (space.wasInsideOut && definition_.interior == MeshInterior::kAutomatic) {
      return fail(
          "the mesh is inside out, like a room that is seen from within: say whether its interior is solid, "
          "which turns it, or a surface, which keeps it open");
    }
    notes_ = space.mesh.notes;
    const std::vector<LevelAssembler::Draft> drafts = assemble(space);
    return finish(space, drafts);
  }

 private:
  void report(std::string_view stage, double share) const {
    if (progress_) progress_(stage, share);
  }

  /// Of a symmetric mesh whose levels are to be symmetric, the plane goes through zero then.
  Result<void> findSymmetry(WorkMesh& work) {
    const bool isWanted = definition_.symmetry != MeshSymmetry::kIgnore;
    if (!isWanted && work.triangles.size() > definition_.maxTriangles) return {};
    const std::optional<MirrorPlane> plane = findMirrorPlane(work);
    if (!plane && definition_.symmetry == MeshSymmetry::kRequired) {
      return fail("the mesh is not symmetric about a plane across x, y or z through its middle, to within " +
                  toText(kSymmetryTolerance * work.diagonal) + " m");
    }
    if (!plane) return {};
    if (isWanted) mirror_ = moveToPlane(*plane, work);
    const double offset = static_cast<double>(work.origin[plane->axis]) + (isWanted ? 0.0 : plane->offset);
    symmetry_ = SymmetryPlane{plane->axis, static_cast<float>(offset)};
    return {};
  }

  [[nodiscard]] double gapLimit(double diagonal) const {
    if (!definition_.finestGap) return 0.0;
    const GapLimit& gap = *definition_.finestGap;
    return gap.metres ? static_cast<double>(*gap.metres) : static_cast<double>(*gap.ofDiagonal) * diagonal;
  }

  /// Where gaps weigh most.
  [[nodiscard]] double leastGap(double diagonal) const {
    return gapLimit(diagonal) / regions_.largestWeight();
  }

  [[nodiscard]] double margin(double diagonal) const {
    if (definition_.hullMargin) return static_cast<double>(*definition_.hullMargin);
    const double least = std::min(kDefaultMargin, kDefaultMarginShare * diagonal);
    return definition_.finestGap ? std::min(least, kDefaultMarginOfGap * leastGap(diagonal)) : least;
  }

  [[nodiscard]] double thickness(const MeshSpace& space) const {
    if (space.isSolid) return 0.0;
    if (definition_.thickness) return static_cast<double>(*definition_.thickness);
    const double diagonal = space.mesh.diagonal;
    const double least = std::min(static_cast<double>(kSheetThickness), kSheetThicknessShare * diagonal);
    return definition_.finestGap ? std::min(least, kThicknessOfGap * leastGap(diagonal)) : least;
  }

  [[nodiscard]] Result<void> checkMargin(double diagonal) const {
    if (!definition_.finestGap || margin(diagonal) < leastGap(diagonal)) return {};
    return fail("a gap of " + toText(leastGap(diagonal)) + " m cannot be kept with a hull margin of " +
                toText(margin(diagonal)) + " m, which counts in it: give a smaller margin or a larger gap");
  }

  [[nodiscard]] FinestDef finestDef(double diagonal) const {
    if (definition_.finestGap) return {static_cast<std::size_t>(definition_.maxParts), gapLimit(diagonal)};
    const int parts =
        definition_.partCounts.empty() ? definition_.finestParts : definition_.partCounts.back();
    return {static_cast<std::size_t>(parts), 0.0};
  }

  std::vector<LevelAssembler::Draft> assemble(const MeshSpace& space) {
    const double diagonal = space.mesh.diagonal;
    const FinestDef finest = finestDef(diagonal);
    const bool isFine = finest.gap > 0.0 && leastGap(diagonal) < kSmallGap * diagonal;
    const DistanceGrid grid(space, regions_, isFine ? kFineGridCells : kGridCells,
                            [this](double share) { report("distances", share); });
    const std::size_t patchCount =
        std::clamp(kPatchesPerPart * finest.maxParts, kFewestPatches, kMostPatches);
    report("patches", 0.0);
    TriangleRegions regions = regionsOfTriangles(space.mesh, regions_);
    std::optional<SymmetricMesh> symmetric;
    if (mirror_) {
      symmetric = makeSymmetric(space.mesh, *mirror_);
      regions = symmetric->regions(regions);
    }
    const SymmetricMesh* symmetry = symmetric ? &*symmetric : nullptr;
    // A patch of one side stands for two.
    Patches patches = symmetric ? symmetric->patches(regions, patchCount / 2, definition_.maxTriangles / 2)
                                : preMerge(space.mesh, regions, patchCount, definition_.maxTriangles);
    if (patches.isGrouped) {
      notes_.push_back(std::to_string(space.mesh.triangles.size()) + " triangles are more than " +
                       std::to_string(definition_.maxTriangles) +
                       ": grouped by cell and facing; all of them are enclosed");
    }
    const MergeTree tree = mergeGreedily(
        symmetric ? symmetric->mesh : space.mesh, grid, regions, std::move(patches),
        {definition_.maxVertices, [this](double share) { report("merging", share); }, symmetry});
    LevelAssembler assembler(
        space, grid, regions, tree,
        {definition_.maxVertices, margin(diagonal), definition_.fitPrimitives, thickness(space), symmetry});
    std::vector<LevelAssembler::Draft> drafts;
    drafts.push_back(assembler.finest(finest, [this](double share) { report("parts", share); }));
    noteFinest(drafts.front(), finest);
    addCoarser(assembler, drafts);
    noteThickness(thickness(space));
    return drafts;
  }

  /// Adds the coarser levels behind the finest one.
  void addCoarser(LevelAssembler& assembler, std::vector<LevelAssembler::Draft>& drafts) {
    const int finestCount = static_cast<int>(drafts.front().parts.size());
    std::vector<int> counts = definition_.partCounts;
    if (counts.empty()) counts = countsUpTo(finestCount, definition_.levels);
    const std::size_t wanted =
        definition_.partCounts.empty() ? static_cast<std::size_t>(definition_.levels) : counts.size();
    std::erase_if(counts, [finestCount](int count) { return count >= finestCount; });
    for (auto count = counts.rbegin(); count != counts.rend(); ++count) {
      report("levels", static_cast<double>(drafts.size()) / static_cast<double>(counts.size() + 1));
      LevelAssembler::Draft coarser = assembler.coarser(drafts.back(), static_cast<std::size_t>(*count));
      // Where parts come in pairs, one less may not be to be had.
      if (coarser.parts.size() < drafts.back().parts.size()) drafts.push_back(std::move(coarser));
    }
    if (drafts.size() <= counts.size()) {
      notes_.push_back(std::to_string(drafts.size()) + " of " + std::to_string(wanted) +
                       " levels made: their parts come in pairs, and others would have as many");
    } else if (drafts.size() < wanted) {
      notes_.push_back(std::to_string(drafts.size()) + " of " + std::to_string(wanted) +
                       " levels made: the finest has only " + std::to_string(finestCount) +
                       (finestCount == 1 ? " part" : " parts"));
    }
  }

  // Who makes a bowl of a sheet wants to know what it holds.
  void noteThickness(double thickness) {
    if (!(thickness > 0.0) || thickness >= static_cast<double>(kSheetThickness)) return;
    constexpr double kBall = 0.015;
    constexpr double kStepsPerSecond = 60.0;
    notes_.push_back("its plates are " + toText(thickness) +
                     " m thick: a ball of 3 cm passes through them above " +
                     toText(std::round(10.0 * (0.5 * thickness + kBall) * kStepsPerSecond) / 10.0) +
                     " m/s in steps of 1/60 s; a thickness of " +
                     toText(static_cast<double>(kSheetThickness)) + " m stops it at 7 m/s");
  }

  void noteFinest(const LevelAssembler::Draft& finest, const FinestDef& wanted) {
    double gap = 0.0;
    bool isMixed = false;
    for (const PartDraft& part : finest.parts) {
      gap = std::max(gap, part.gap);
      isMixed = isMixed || part.isMixed;
    }
    const std::string parts = std::to_string(finest.parts.size());
    if (isMixed) {
      notes_.push_back(parts + (finest.parts.size() == 1 ? " part does" : " parts do") +
                       " not suffice to keep all regions apart");
    }
    if (wanted.gap > 0.0 && gap > wanted.gap) {
      notes_.push_back("the gap of the finest level" + std::string(regions_.isEmpty() ? "" : ", weighed,") +
                       " is " + toText(gap) + " m instead of " + toText(wanted.gap) + " m: " + parts +
                       " parts are the most that were allowed or could be made");
    } else if (wanted.gap <= 0.0 && finest.parts.size() < wanted.maxParts) {
      notes_.push_back("the finest level has " + parts + (finest.parts.size() == 1 ? " part" : " parts") +
                       " instead of " + std::to_string(wanted.maxParts) +
                       ": more would not be nearer to the mesh");
    }
  }

  Result<BuiltLevels> finish(const MeshSpace& space, const std::vector<LevelAssembler::Draft>& drafts) {
    report("check", 0.0);
    LevelSetDef set;
    set.name = definition_.name;
    set.hullMargin = static_cast<float>(margin(space.mesh.diagonal));
    for (const auto& draft : drafts) {
      Level level;
      for (const PartDraft& part : draft.parts) level.parts.push_back(part.part);
      set.levels.push_back(std::move(level));
    }
    std::reverse(set.levels.begin(), set.levels.end());
    setMass(space, set);
    const bool hasMassOfMesh = set.mass.has_value();
    if (mirror_) makeMassSymmetric(space, set);
    auto levels = LevelSet::create(std::move(set));
    if (!levels) return fail(levels.error().message);
    return BuiltLevels{std::move(*levels), space.isSolid, hasMassOfMesh, symmetry_, std::move(notes_)};
  }

  // Of the mesh where that has an inside; bodies must not weigh what levels fill besides.
  void setMass(const MeshSpace& space, LevelSetDef& set) {
    const bool isHollow = space.isClosed && !space.isSolid;
    const Result<SolidMass> mass = isHollow ? fail("the mesh is a surface") : massOfMesh(space);
    if (mass) {
      set.mass = mass->properties;
    } else {
      notes_.push_back("mass properties are those of the finest level: " + mass.error().message);
    }
  }

  // What is integrated along columns would pull a little to one side.
  void makeMassSymmetric(const MeshSpace& space, LevelSetDef& set) const {
    if (!set.mass) {
      const Result<MassProperties> finest = massProperties(set.levels.back().parts);
      if (!finest) return;  // LevelSet::create() tells why.
      set.mass = *finest;
    }
    const int axis = mirror_->axis;
    set.mass->centerOfMass[axis] = space.mesh.origin[axis];
    for (int other = 0; other < 3; ++other) {
      if (other != axis) set.mass->inertia[axis][other] = set.mass->inertia[other][axis] = 0.0F;
    }
  }

  const LevelBuildDef& definition_;
  const BuildProgress& progress_;
  RegionMap regions_;
  std::optional<SymmetryPlane> symmetry_;
  std::optional<Mirror> mirror_;  ///< If levels are to be symmetric.
  std::vector<std::string> notes_;
};

}  // namespace
}  // namespace levels

Result<BuiltLevels> buildLevels(const SurfaceMesh& mesh, const LevelBuildDef& definition,
                                const BuildProgress& progress) {
  return levels::Build(definition, progress).run(mesh);
}

}  // namespace scatter
