#include "viewer/level_looks.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "levels/measure/gap_over_mesh.h"
#include "viewer/drawing/surface_shading.h"
#include "viewer/mesh_refinement.h"
#include "viewer/palette.h"
#include "viewer/shape_mesh.h"

namespace scatter::viewer {
namespace {

constexpr float kEdgesPerDiagonal = 60.0F;
constexpr double kLeastScale = 0.01;
constexpr std::size_t kMostTriangles = 80'000;

/// A triangle whose longest edge is cut in two until it is short enough has at least this share of its
/// square.
constexpr float kLeastShare = 0.125F;

struct Extent {
  Vec3 low{std::numeric_limits<float>::infinity()};
  Vec3 high{-std::numeric_limits<float>::infinity()};

  void add(const MeshData& mesh) {
    for (const Vec3& position : mesh.positions) {
      low = glm::min(low, position);
      high = glm::max(high, position);
    }
  }
  [[nodiscard]] Vec3 middle() const { return 0.5F * (low + high); }
};

float areaOf(const MeshData& mesh) {
  float sum = 0.0F;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Vec3& corner = mesh.positions[mesh.indices[i]];
    sum += 0.5F * glm::length(glm::cross(mesh.positions[mesh.indices[i + 1]] - corner,
                                         mesh.positions[mesh.indices[i + 2]] - corner));
  }
  return sum;
}

/// The mesh, fine enough for colours.
MeshData paintable(const SurfaceMesh& mesh, double diagonal) {
  MeshData shaded = shadeSurface(mesh);
  shaded.twoSided = true;
  const float fewest = std::sqrt(areaOf(shaded) / (kLeastShare * static_cast<float>(kMostTriangles)));
  const float longest = std::max(static_cast<float>(diagonal) / kEdgesPerDiagonal, fewest);
  return refined(shaded, longest, std::max(kMostTriangles, shaded.indices.size()));
}

/// Does `work` for all numbers below `count`, on two threads.
template <class Work>
void onTwoThreads(std::size_t count, const Work& work) {
  const auto half = [&work](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) work(i);
  };
  const std::future<void> other = std::async(std::launch::async, half, count / 2, count);
  half(0, count / 2);
}

std::vector<glm::dvec3> outwardNormals(const MeshData& mesh, const levels::MeshSpace& space) {
  std::vector<glm::dvec3> normals(mesh.normals.size());
  onTwoThreads(normals.size(), [&](std::size_t i) {
    normals[i] = levels::outward(space, glm::dvec3(mesh.positions[i]), glm::dvec3(mesh.normals[i]));
  });
  return normals;
}

/// One value a vertex.
std::vector<double> gapsOver(const MeshData& mesh, const std::vector<glm::dvec3>& normals,
                             const levels::GapOverMesh& gap) {
  std::vector<double> gaps(mesh.positions.size());
  onTwoThreads(gaps.size(),
               [&](std::size_t i) { gaps[i] = gap.at(glm::dvec3(mesh.positions[i]), normals[i]); });
  return gaps;
}

MeshId paint(Renderer& renderer, MeshData& mesh, const std::vector<double>& gaps, double end) {
  mesh.colors.clear();
  for (const double gap : gaps) mesh.colors.emplace_back(gapColor(static_cast<float>(gap / end)));
  return renderer.addMesh(mesh);
}

LevelLook lookOf(Renderer& renderer, const Level& level) {
  LevelLook look;
  for (const ConvexPart& part : level.parts) {
    MeshData mesh = meshOf(Level{{part}});
    Extent extent;
    extent.add(mesh);
    for (Vec3& position : mesh.positions) position -= extent.middle();
    look.parts.push_back(
        {renderer.addMesh(mesh), extent.middle(), 0.5F * glm::distance(extent.low, extent.high)});
  }
  look.whole = renderer.addMesh(meshOf(level));
  return look;
}

}  // namespace

Result<LevelLooks> LevelLooks::create(Renderer& renderer, const ShownModel& model) {
  LevelLooks looks;
  const LevelSet& set = *model.levels;
  Extent extent;
  for (int i = 1; i <= set.count(); ++i) {
    looks.levels_.push_back(lookOf(renderer, set.level(i)));
    extent.add(meshOf(set.level(i)));
  }
  looks.middle_ = extent.middle();
  if (model.mesh.triangles.empty()) return looks;

  Result<LevelMeasures> measures = measureLevels(set, model.mesh, {});
  if (!measures) return fail(model.name + ": " + measures.error().message);
  auto work = levels::makeWorkMesh(model.mesh);
  if (!work) return fail(model.name + ": " + work.error().message);
  const levels::MeshSpace space = levels::makeMeshSpace(std::move(*work), MeshInterior::kAutomatic);
  looks.diagonal_ = measures->diagonal;
  MeshData mesh = paintable(model.mesh, looks.diagonal_);
  const std::vector<glm::dvec3> normals = outwardNormals(mesh, space);
  std::vector<std::vector<double>> gaps;
  for (int i = 1; i <= set.count(); ++i) {
    LevelLook& look = looks.levels_[static_cast<std::size_t>(i - 1)];
    look.measured = measures->levels[static_cast<std::size_t>(i - 1)];
    gaps.push_back(gapsOver(mesh, normals,
                            levels::GapOverMesh(set.level(i), static_cast<double>(set.hullMargin()), space)));
    look.scaleEnd = std::max(look.measured->maxGap, kLeastScale * looks.diagonal_);
    looks.scaleEnd_ = std::max(looks.scaleEnd_, look.scaleEnd);
    look.gaps = paint(renderer, mesh, gaps.back(), look.scaleEnd);
  }
  for (std::size_t i = 0; i < gaps.size(); ++i)
    looks.levels_[i].gapsOnOneScale = paint(renderer, mesh, gaps[i], looks.scaleEnd_);
  return looks;
}

float LevelLooks::reach(float apart) const {
  float reach = 0.0F;
  for (const LevelLook& level : levels_) {
    for (const LevelLook::Part& part : level.parts)
      reach = std::max(reach, (1.0F + apart) * glm::distance(part.center, middle_) + part.radius);
  }
  return reach;
}

}  // namespace scatter::viewer
