#include "level_bench.h"

#include <scatter/lab/environment.h>
#include <scatter/levels/build_levels.h>
#include <scatter/levels/level_check.h>
#include <scatter/levels/measure_levels.h>
#include <spdlog/fmt/fmt.h>

#include <ctime>
#include <memory>
#include <utility>
#include <variant>

#include "decomposition.h"
#include "level_pile.h"
#include "scenes/shape_measures.h"

namespace scatter::app {
namespace {

struct MadeLevels {
  std::shared_ptr<const LevelSet> levels;
  double seconds = 0.0;  ///< Processor time.
};

Result<MadeLevels> makeByOthers(const SurfaceMesh& mesh, const LevelMethod& method, int limitSeconds) {
  const auto parts = decompose(mesh, {method.command, method.parts.back(), method.maxVertices, limitSeconds});
  if (!parts) return fail(method.name + " " + parts.error().message);
  LevelSetDef def{.name = method.name, .levels = {parts->level}, .hullMargin = 0.0F, .mass = {}};
  return LevelSet::create(std::move(def)).map([&](auto levels) {
    return MadeLevels{std::move(levels), parts->seconds};
  });
}

Result<MadeLevels> makeOurs(const SurfaceMesh& mesh, const LevelMethod& method,
                            const std::function<void()>& tick) {
  LevelBuildDef def;
  def.partCounts = method.parts;
  def.maxVertices = method.maxVertices;
  const std::clock_t start = std::clock();
  auto built = buildLevels(mesh, def, [&tick](std::string_view, double) { tick(); });
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  if (!built) return fail(built.error().message);
  return MadeLevels{built->levels, seconds};
}

const std::string kLevelColumns =
    "mesh,triangles,method,max_vertices,levels,level,parts,vertices,build_cpu_s,passes,triangles_outside,"
    "area_outside_percent,furthest_outside_percent,volume_ratio,mean_gap_percent,p95_gap_percent,"
    "max_gap_percent,overlap,commit,compiler,flags,cpu\n";

struct JudgedLevels {
  LevelCheck check;
  LevelMeasures measures;
};

Result<JudgedLevels> judgeLevels(const SurfaceMesh& mesh, const MadeLevels& made) {
  std::vector<Level> levels;
  for (int i = 1; i <= made.levels->count(); ++i) levels.push_back(made.levels->level(i));
  auto check = checkLevels(levels, made.levels->hullMargin(), &mesh);
  if (!check) return fail(check.error().message);
  auto measures = measureLevels(*made.levels, mesh);
  if (!measures) return fail(measures.error().message);
  return JudgedLevels{std::move(*check), std::move(*measures)};
}

std::string verticesText(const LevelMethod& method) {
  return method.maxVertices > 0 ? std::to_string(method.maxVertices) : "any";
}

/// Commit, compiler, flags and processor.
std::string originText() {
  const BuildInfo build = buildInfo();
  return fmt::format("{},{},{},{}", build.commit, build.compiler, build.flags, machineInfo().cpu);
}

/// A row for each level; percentages are of the diagonal, but for the area.
std::string levelRows(const MeshFile& file, const LevelMethod& method, const MadeLevels& made,
                      const JudgedLevels& judged) {
  const double percent = 100.0 / judged.measures.diagonal;
  const auto& mesh = *judged.check.mesh;
  const double furthest = mesh.worst ? mesh.worst->distance : 0.0;
  const std::string origin = originText();
  std::string rows;
  for (std::size_t i = 0; i < judged.measures.levels.size(); ++i) {
    const LevelFigures& level = judged.measures.levels[i];
    rows += fmt::format(
        "{},{},{},{},{},{},{},{},{:.2f},{},{},{:.3f},{:.4f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{}\n",
        file.name, file.mesh.triangles.size(), method.name, verticesText(method),
        judged.measures.levels.size(), i + 1, level.parts, level.vertices, made.seconds,
        judged.check.passed() ? "yes" : "no", mesh.outside, 100.0 * mesh.areaOutside, percent * furthest,
        level.volumeRatio, percent * level.meanGap, percent * level.p95Gap, percent * level.maxGap,
        level.overlap(), origin);
  }
  return rows;
}

const std::string kPileColumns =
    "mesh,triangles,method,max_vertices,parts,vertices,bytes,build_cpu_s,area_outside_percent,"
    "p95_gap_percent,max_gap_percent,overlap,bullet_ms,bullet_ms_least,bullet_ms_most,bullet_contacts,"
    "bullet_manifolds,ours_ms,ours_ms_least,ours_ms_most,ours_contacts,ours_manifolds,commit,compiler,flags,"
    "cpu\n";

/// What has been made of a mesh in one way, and its row until the costs.
struct Piled {
  PiledBody body;
  std::string row;
};

/// Of all levels: three floats a hull's vertex; of other parts what they and their pose are.
std::size_t bytesOf(const LevelSet& levels) {
  constexpr std::size_t kPrimitiveBytes = 40;
  std::size_t bytes = 0;
  for (int i = 1; i <= levels.count(); ++i) {
    for (const ConvexPart& part : levels.level(i).parts) {
      const auto* hull = std::get_if<ConvexHull>(&part.shape);
      bytes += hull == nullptr ? kPrimitiveBytes : hull->vertices.size() * sizeof(Vec3);
    }
  }
  return bytes;
}

/// About the model's origin, where scaledPart() leaves the middle of a hull in its place.
ConvexPart scaled(const ConvexPart& part, float scale) {
  ConvexPart result = part;
  if (auto* hull = std::get_if<ConvexHull>(&result.shape)) {
    for (Vec3& vertex : hull->vertices) vertex *= scale;
  } else {
    result = scaledPart(part, scale);
  }
  result.pose.position *= scale;
  return result;
}

Level scaled(const Level& level, float scale) {
  Level result;
  for (const ConvexPart& part : level.parts) result.parts.push_back(scaled(part, scale));
  return result;
}

/// As large for the pile as all others: 2 m, and with the margin that ours have.
Result<std::shared_ptr<const LevelSet>> forPile(const LevelSet& levels, double diagonal, bool isOurs) {
  constexpr double kDiagonal = 2.0;
  constexpr double kMargin = 0.001;
  const auto scale = static_cast<float>(kDiagonal / diagonal);
  LevelSetDef def{.name = levels.name(), .levels = {}, .hullMargin = 0.0F, .mass = {}};
  for (int i = 1; i <= levels.count(); ++i) def.levels.push_back(scaled(levels.level(i), scale));
  def.hullMargin = isOurs ? levels.hullMargin() * scale : static_cast<float>(kMargin);
  return LevelSet::create(std::move(def));
}

/// Ours are piled up with several numbers of parts.
std::string labelOf(const LevelMethod& method) {
  return method.command.empty() ? fmt::format("{}-{}", method.name, method.parts.back()) : method.name;
}

Result<Piled> pileOf(const MeshFile& file, const LevelMethod& method, const MadeLevels& made,
                     const JudgedLevels& judged) {
  const LevelFigures& finest = judged.measures.levels.back();
  const double percent = 100.0 / judged.measures.diagonal;
  auto levels = forPile(*made.levels, judged.measures.diagonal, method.command.empty());
  if (!levels) return fail(levels.error().message);
  return Piled{{labelOf(method), std::move(*levels)},
               fmt::format("{},{},{},{},{},{},{},{:.2f},{:.3f},{:.3f},{:.3f},{:.3f}", file.name,
                           file.mesh.triangles.size(), labelOf(method), verticesText(method), finest.parts,
                           finest.vertices, bytesOf(*made.levels), made.seconds,
                           100.0 * judged.check.mesh->areaOutside, percent * finest.p95Gap,
                           percent * finest.maxGap, finest.overlap())};
}

std::string costText(const PileCost& cost) {
  const Spread& ms = cost.milliseconds;
  return fmt::format("{:.3f},{:.3f},{:.3f},{:.1f},{:.1f}", ms.median, ms.min, ms.max, cost.contacts,
                     cost.manifolds);
}

std::string costLine(const std::string& label, const PileCosts& cost) {
  return fmt::format(
      "  pile of 30, {:<10}  plain Bullet {:7.2f} ms, {:6.0f} contacts   ours {:7.2f} ms, {:6.0f} contacts",
      label, cost.bullet.milliseconds.median, cost.bullet.contacts, cost.ours.milliseconds.median,
      cost.ours.contacts);
}

Result<void> addPiles(const std::vector<Piled>& piled, const LevelBenchDef& definition, std::string& rows,
                      const std::function<void(const std::string& line)>& print) {
  std::vector<PiledBody> bodies;
  for (const Piled& each : piled) bodies.push_back(each.body);
  const auto costs = pileUp(bodies, definition.repeat, definition.piling);
  if (!costs) return fail(costs.error().message);
  for (std::size_t i = 0; i < piled.size(); ++i) {
    const PileCosts& cost = costs->at(i);
    rows +=
        fmt::format("{},{},{},{}\n", piled[i].row, costText(cost.bullet), costText(cost.ours), originText());
    print(costLine(piled[i].body.label, cost));
  }
  return {};
}

/// For the eye: the finest level.
std::string levelLine(const MeshFile& file, const LevelMethod& method, const MadeLevels& made,
                      const JudgedLevels& judged) {
  const LevelFigures& finest = judged.measures.levels.back();
  const double percent = 100.0 / judged.measures.diagonal;
  return fmt::format(
      "{:<16} {:>7} {:<8} {:>4} {:>2} levels {:>3} parts {:>7.2f} s  passes {:<3}  "
      "outside {:>7.3f} % of area  p95 {:>6.3f} %  max {:>6.3f} %  overlap {:.2f}",
      file.name, file.mesh.triangles.size(), method.name, verticesText(method), judged.measures.levels.size(),
      finest.parts, made.seconds, judged.check.passed() ? "yes" : "no",
      100.0 * judged.check.mesh->areaOutside, percent * finest.p95Gap, percent * finest.maxGap,
      finest.overlap());
}

std::string failedRow(const MeshFile& file, const LevelMethod& method) {
  return fmt::format("{},{},{},{},1,1,{},,,failed,,,,,,,,,,,\n", file.name, file.mesh.triangles.size(),
                     method.name, verticesText(method), method.parts.back());
}

}  // namespace

LevelBenchTables::LevelBenchTables() : levels(kLevelColumns), piles(kPileColumns) {}

std::vector<LevelMethod> ownLevelMethods() {
  return {{"scatter", {1, 6, 32}, 16, true},
          {"scatter", {1, 8, 64}, 16, true},
          {"scatter", {1, 4, 8, 16, 32, 64}}};
}

Result<void> benchLevels(const MeshFile& file, const LevelBenchDef& definition, LevelBenchTables& tables,
                         const std::function<void(const std::string& line)>& print) {
  std::vector<Piled> piled;
  for (const LevelMethod& method : definition.methods) {
    const bool isOurs = method.command.empty();
    definition.tick();
    const auto made = isOurs ? makeOurs(file.mesh, method, definition.tick)
                             : makeByOthers(file.mesh, method, definition.limitSeconds);
    const auto judged =
        made.and_then([&](const MadeLevels& result) { return judgeLevels(file.mesh, result); });
    if (!judged && isOurs) return fail(file.name + ": " + judged.error().message);
    if (!judged) {
      print(fmt::format("{:<16} {:>7} {:<8} {:>3} parts: {}", file.name, file.mesh.triangles.size(),
                        method.name, method.parts.back(), judged.error().message));
      tables.levels += failedRow(file, method);
      continue;
    }
    tables.passed = tables.passed && (!isOurs || judged->check.passed());
    tables.levels += levelRows(file, method, *made, *judged);
    print(levelLine(file, method, *made, *judged));
    if (!method.isPiled || !definition.piles) continue;
    auto body = pileOf(file, method, *made, *judged);
    if (!body) return fail(file.name + ", " + method.name + ": " + body.error().message);
    piled.push_back(std::move(*body));
  }
  if (piled.empty()) return {};
  auto added = addPiles(piled, definition, tables.piles, print);
  return added ? std::move(added) : fail(file.name + ": " + added.error().message);
}

}  // namespace scatter::app
