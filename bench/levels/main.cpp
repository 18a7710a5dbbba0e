#include <scatter/io/file.h>
#include <scatter/io/mesh_file.h>
#include <scatter/lab/environment.h>
#include <scatter/levels/build_levels.h>
#include <scatter/levels/level_check.h>
#include <scatter/levels/measure_levels.h>
#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "parts.h"
#include "pile.h"

namespace scatter::bench {
namespace {

/// One way to make levels.
struct Method {
  std::string name;
  std::vector<int> parts;    ///< Coarsest first.
  int maxVertices = 16;      ///< 0: any number.
  bool isPiled = false;      ///< Whether its bodies are piled up, too.
  std::string command = "";  ///< Of a program.
};

struct Arguments {
  std::vector<std::string> meshes;
  std::string csv;
  std::string pilesCsv;
  int repeat = 3;
  std::vector<std::string> methods;
  std::vector<std::string> programs;
  int limitSeconds = 120;
};

/// NAME=COMMAND.
Result<Method> parseProgram(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string::npos || text.find("{mesh}") == std::string::npos ||
      text.find("{hulls}") == std::string::npos) {
    return fail("--program: \"" + text + "\" is no NAME=COMMAND with {mesh} and {hulls} in it");
  }
  return Method{text.substr(0, equals), {64}, 0, true, text.substr(equals + 1)};
}

Result<std::vector<Method>> methodsOf(const Arguments& arguments) {
  std::vector<Method> all{{"scatter", {1, 6, 32}},
                          {"scatter", {1, 8, 64}, 16, true},
                          {"scatter", {1, 4, 8, 16, 32, 64}},
                          {"hacd", {32}},
                          {"hacd", {32}, 0},
                          {"hacd", {64}, 0, true}};
  for (const std::string& text : arguments.programs) {
    const auto program = parseProgram(text);
    if (!program) return fail(program.error().message);
    all.push_back(*program);
  }
  const std::vector<std::string>& wanted = arguments.methods;
  std::erase_if(all, [&wanted](const Method& method) {
    return !wanted.empty() && std::find(wanted.begin(), wanted.end(), method.name) == wanted.end();
  });
  if (all.empty())
    return fail("--methods: none of them is known; there are scatter, hacd and those of --program");
  return all;
}

struct Made {
  std::shared_ptr<const LevelSet> levels;
  double seconds = 0.0;  ///< Processor time.
};

Result<Made> makeByOthers(const SurfaceMesh& mesh, const Method& method, int limitSeconds) {
  const DecompositionDef wanted{method.parts.back(), method.maxVertices, limitSeconds};
  const auto parts = method.command.empty() ? decomposeByHacd(mesh, wanted)
                                            : decomposeByProgram(method.command, mesh, wanted);
  if (!parts) return fail(method.name + " " + parts.error().message);
  LevelSetDef def{.name = method.name, .levels = {parts->level}, .hullMargin = 0.0F, .mass = {}};
  return LevelSet::create(std::move(def)).map([&](auto levels) {
    return Made{std::move(levels), parts->seconds};
  });
}

Result<Made> make(const SurfaceMesh& mesh, const Method& method, int limitSeconds) {
  if (method.name != "scatter") return makeByOthers(mesh, method, limitSeconds);
  LevelBuildDef def;
  def.partCounts = method.parts;
  def.maxVertices = method.maxVertices;
  const std::clock_t start = std::clock();
  auto built = buildLevels(mesh, def);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  if (!built) return fail(built.error().message);
  return Made{built->levels, seconds};
}

const std::string kHeader =
    "mesh,triangles,method,max_vertices,levels,level,parts,vertices,build_cpu_s,passes,triangles_outside,"
    "area_outside_percent,"
    "furthest_outside_percent,volume_ratio,mean_gap_percent,p95_gap_percent,max_gap_percent,overlap,commit,"
    "compiler,"
    "flags,cpu\n";

struct Judged {
  LevelCheck check;
  LevelMeasures measures;
};

Result<Judged> judge(const SurfaceMesh& mesh, const Made& made) {
  std::vector<Level> levels;
  for (int i = 1; i <= made.levels->count(); ++i) levels.push_back(made.levels->level(i));
  auto check = checkLevels(levels, made.levels->hullMargin(), &mesh);
  if (!check) return fail(check.error().message);
  auto measures = measureLevels(*made.levels, mesh);
  if (!measures) return fail(measures.error().message);
  return Judged{std::move(*check), std::move(*measures)};
}

std::string verticesText(const Method& method) {
  return method.maxVertices > 0 ? std::to_string(method.maxVertices) : "any";
}

/// Commit, compiler, flags and processor.
std::string originText() {
  const BuildInfo build = buildInfo();
  return fmt::format("{},{},{},{}", build.commit, build.compiler, build.flags, machineInfo().cpu);
}

/// A row for each level; percentages are of the diagonal, but for the area.
std::string rowsOf(const MeshFile& file, const Method& method, const Made& made, const Judged& judged) {
  const double percent = 100.0 / judged.measures.diagonal;
  const auto& mesh = *judged.check.mesh;
  const double furthest = mesh.worst ? mesh.worst->distance : 0.0;
  std::string rows;
  for (std::size_t i = 0; i < judged.measures.levels.size(); ++i) {
    const LevelFigures& level = judged.measures.levels[i];
    rows += fmt::format(
        "{},{},{},{},{},{},{},{},{:.2f},{},{},{:.3f},{:.4f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{}\n",
        file.name, file.mesh.triangles.size(), method.name, verticesText(method),
        judged.measures.levels.size(), i + 1, level.parts, level.vertices, made.seconds,
        judged.check.passed() ? "yes" : "no", mesh.outside, 100.0 * mesh.areaOutside, percent * furthest,
        level.volumeRatio, percent * level.meanGap, percent * level.p95Gap, percent * level.maxGap,
        level.overlap(), originText());
  }
  return rows;
}

const std::string kPilesHeader =
    "mesh,triangles,method,max_vertices,parts,vertices,bytes,build_cpu_s,area_outside_percent,p95_gap_"
    "percent,"
    "max_gap_percent,overlap,bullet_ms,bullet_ms_least,bullet_ms_most,bullet_contacts,bullet_manifolds,ours_"
    "ms,"
    "ours_ms_least,ours_ms_most,ours_contacts,ours_manifolds,commit,compiler,flags,cpu\n";

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

ConvexPart scaled(ConvexPart part, float scale) {
  part.pose.position *= scale;
  if (auto* box = std::get_if<Box>(&part.shape)) box->halfExtents *= scale;
  if (auto* sphere = std::get_if<Sphere>(&part.shape)) sphere->radius *= scale;
  if (auto* capsule = std::get_if<Capsule>(&part.shape)) {
    capsule->radius *= scale;
    capsule->halfHeight *= scale;
  }
  if (auto* cylinder = std::get_if<Cylinder>(&part.shape)) {
    cylinder->radius *= scale;
    cylinder->halfHeight *= scale;
  }
  if (auto* hull = std::get_if<ConvexHull>(&part.shape)) {
    for (Vec3& vertex : hull->vertices) vertex *= scale;
  }
  return part;
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

Result<Piled> pileOf(const MeshFile& file, const Method& method, const Made& made, const Judged& judged) {
  const LevelFigures& finest = judged.measures.levels.back();
  const double percent = 100.0 / judged.measures.diagonal;
  auto levels = forPile(*made.levels, judged.measures.diagonal, method.name == "scatter");
  if (!levels) return fail(levels.error().message);
  return Piled{{method.name, std::move(*levels)},
               fmt::format("{},{},{},{},{},{},{},{:.2f},{:.3f},{:.3f},{:.3f},{:.3f}", file.name,
                           file.mesh.triangles.size(), method.name, verticesText(method), finest.parts,
                           finest.vertices, bytesOf(*made.levels), made.seconds,
                           100.0 * judged.check.mesh->areaOutside, percent * finest.p95Gap,
                           percent * finest.maxGap, finest.overlap())};
}

std::string costText(const PileCost& cost) {
  const Spread& ms = cost.milliseconds;
  return fmt::format("{:.3f},{:.3f},{:.3f},{:.1f},{:.1f}", ms.median, ms.min, ms.max, cost.contacts,
                     cost.manifolds);
}

/// The rows of a mesh.
Result<std::string> pileRows(const std::vector<Piled>& piled, int repeat) {
  std::vector<PiledBody> bodies;
  for (const Piled& each : piled) bodies.push_back(each.body);
  const auto costs = pileUp(bodies, repeat);
  if (!costs) return fail(costs.error().message);
  std::string rows;
  for (std::size_t i = 0; i < piled.size(); ++i) {
    const PileCosts& cost = costs->at(i);
    rows +=
        fmt::format("{},{},{},{}\n", piled[i].row, costText(cost.bullet), costText(cost.ours), originText());
    fmt::print(
        "  pile of 30, {:<8}  plain Bullet {:7.2f} ms, {:6.0f} contacts   ours {:7.2f} ms, {:6.0f} "
        "contacts\n",
        piled[i].body.label, cost.bullet.milliseconds.median, cost.bullet.contacts,
        cost.ours.milliseconds.median, cost.ours.contacts);
  }
  return rows;
}

/// A line for the eye: the finest level.
void print(const MeshFile& file, const Method& method, const std::string& row) {
  std::vector<std::string> cells;
  std::string cell;
  for (const char c : row + ",") {
    if (c == ',') {
      cells.push_back(cell);
      cell.clear();
    } else {
      cell += c;
    }
  }
  fmt::print(
      "{:<16} {:>7} {:<8} {:>4} {:>2} levels {:>3} parts {:>8} s  passes {:<3}  outside {:>7} % of area  p95 "
      "{:>7} %  max {:>7} %\n",
      file.name, file.mesh.triangles.size(), method.name, cells.at(3), cells.at(4), cells.at(6), cells.at(8),
      cells.at(9), cells.at(11), cells.at(15), cells.at(16));
  std::fflush(stdout);
}

struct Tables {
  std::string levels = kHeader;
  std::string piles = kPilesHeader;
};

Result<void> addMesh(const MeshFile& file, const std::vector<Method>& methods, const Arguments& arguments,
                     Tables& tables) {
  std::vector<Piled> piled;
  for (const Method& method : methods) {
    const auto made = make(file.mesh, method, arguments.limitSeconds);
    const auto judged = made.and_then([&](const Made& result) { return judge(file.mesh, result); });
    if (!judged) {
      fmt::print("{:<16} {:>7} {:<8} {:>3} parts: {}\n", file.name, file.mesh.triangles.size(), method.name,
                 method.parts.back(), judged.error().message);
      tables.levels +=
          fmt::format("{},{},{},{},1,1,{},,,{},,,,,,,,,,,\n", file.name, file.mesh.triangles.size(),
                      method.name, verticesText(method), method.parts.back(), "failed");
      continue;
    }
    const std::string rows = rowsOf(file, method, *made, *judged);
    tables.levels += rows;
    const std::size_t last = rows.rfind('\n', rows.size() - 2);
    print(file, method, rows.substr(last == std::string::npos ? 0 : last + 1));
    if (!method.isPiled || arguments.pilesCsv.empty()) continue;
    auto body = pileOf(file, method, *made, *judged);
    if (!body) return fail(file.name + ", " + method.name + ": " + body.error().message);
    piled.push_back(std::move(*body));
  }
  if (piled.empty()) return {};
  const auto rows = pileRows(piled, arguments.repeat);
  if (!rows) return fail(file.name + ": " + rows.error().message);
  tables.piles += *rows;
  return {};
}

Result<void> write(const Arguments& arguments, const Tables& tables) {
  if (!arguments.csv.empty()) {
    if (auto written = writeFile(arguments.csv, tables.levels); !written) return written;
  }
  return arguments.pilesCsv.empty() ? Result<void>{} : writeFile(arguments.pilesCsv, tables.piles);
}

int refuse(const std::string& message) {
  fmt::print(stderr, "levels_bench: {}\n", message);
  return 2;
}

int run(const Arguments& arguments) {
  const auto methods = methodsOf(arguments);
  if (!methods) return refuse(methods.error().message);
  Tables tables;
  for (const std::string& path : arguments.meshes) {
    const auto file = readMesh(path);
    if (!file) return refuse(file.error().message);
    if (auto added = addMesh(*file, *methods, arguments, tables); !added)
      return refuse(added.error().message);
    if (auto written = write(arguments, tables); !written) return refuse(written.error().message);
  }
  return 0;
}

}  // namespace
}  // namespace scatter::bench

int main(int argc, char** argv) {
  CLI::App program{
      "Builds levels of well-known meshes, proves and measures them, and does the same with others' parts"};
  scatter::bench::Arguments arguments;
  program.add_option("MESH", arguments.meshes, "Mesh files")->required();
  program.add_option("--csv", arguments.csv, "Write a row for each level to this file");
  program.add_option(
      "--piles", arguments.pilesCsv,
      "Pile thirty bodies of 64 parts up, in plain Bullet and in ours, and write a row for each way");
  program.add_option("--repeat", arguments.repeat, "Runs of each pile")
      ->check(CLI::Range(1, 99))
      ->capture_default_str();
  program
      .add_option("--methods", arguments.methods,
                  "Which of them to run: scatter, hacd, those of --program [all]")
      ->delimiter(',');
  program
      .add_option(
          "--program", arguments.programs,
          "NAME=COMMAND: one that is installed. The shell runs it in an empty folder; it reads {mesh} and "
          "writes {hulls}, .obj files, the second with an object for each hull, about {parts} of them. "
          "Several times for several programs")
      ->allow_extra_args(false);
  program.add_option("--seconds", arguments.limitSeconds, "Processor time for each decomposition by others")
      ->capture_default_str();
  CLI11_PARSE(program, argc, argv);
  return scatter::bench::run(arguments);
}
