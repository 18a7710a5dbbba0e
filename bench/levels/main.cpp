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
#include <optional>
#include <string>
#include <vector>

#include "hacd_parts.h"

namespace scatter::bench {
namespace {

/// One way to make levels.
struct Method {
  std::string name;
  std::vector<int> parts;  ///< Coarsest first.
  int maxVertices = 16;
  bool hacd = false;
};

std::vector<Method> methods(const std::string& kind) {
  std::vector<Method> all{{"scatter", {1, 6, 32}, 16, false},
                          {"scatter", {1, 8, 64}, 16, false},
                          {"scatter", {1, 4, 8, 16, 32, 64}, 16, false},
                          {"hacd", {32}, 16, true},
                          {"hacd", {32}, 0, true},
                          {"hacd", {64}, 0, true}};
  std::erase_if(all, [&kind](const Method& method) { return kind != "both" && method.name != kind; });
  return all;
}

struct Arguments {
  std::vector<std::string> meshes;
  std::string csv;
  std::string method = "both";
  int hacdSeconds = 120;
};

struct Made {
  std::shared_ptr<const LevelSet> levels;
  double seconds = 0.0;  ///< Processor time.
};

Result<Made> make(const SurfaceMesh& mesh, const Method& method, int limitSeconds) {
  if (method.hacd) {
    auto parts = decompose(mesh, method.parts.back(), method.maxVertices, limitSeconds);
    if (!parts) return fail(parts.error().message);
    LevelSetDef def{.name = "hacd", .levels = {parts->level}, .hullMargin = 0.0F, .mass = {}};
    return LevelSet::create(std::move(def)).map([&](auto levels) {
      return Made{std::move(levels), parts->seconds};
    });
  }
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

/// A row for each level; percentages are of the diagonal, but for the area.
Result<std::string> rowsOf(const MeshFile& file, const Method& method, const Made& made) {
  std::vector<Level> levels;
  for (int i = 1; i <= made.levels->count(); ++i) levels.push_back(made.levels->level(i));
  const auto check = checkLevels(levels, made.levels->hullMargin(), &file.mesh);
  if (!check) return fail(check.error().message);
  const auto measures = measureLevels(*made.levels, file.mesh);
  if (!measures) return fail(measures.error().message);
  const double percent = 100.0 / measures->diagonal;
  const double furthest = check->mesh->worst ? check->mesh->worst->distance : 0.0;
  const BuildInfo build = buildInfo();
  std::string rows;
  for (std::size_t i = 0; i < measures->levels.size(); ++i) {
    const LevelFigures& level = measures->levels[i];
    rows += fmt::format(
        "{},{},{},{},{},{},{},{},{:.2f},{},{},{:.3f},{:.4f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{},{},{},{}\n",
        file.name, file.mesh.triangles.size(), method.name,
        method.maxVertices > 0 ? std::to_string(method.maxVertices) : "any", measures->levels.size(), i + 1,
        level.parts, level.vertices, made.seconds, check->passed() ? "yes" : "no", check->mesh->outside,
        100.0 * check->mesh->areaOutside, percent * furthest, level.volumeRatio, percent * level.meanGap,
        percent * level.p95Gap, percent * level.maxGap, level.overlap(), build.commit, build.compiler,
        build.flags, machineInfo().cpu);
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

int run(const Arguments& arguments) {
  std::string csv = kHeader;
  for (const std::string& path : arguments.meshes) {
    const auto file = readMesh(path);
    if (!file) {
      fmt::print(stderr, "levels_bench: {}\n", file.error().message);
      return 2;
    }
    for (const Method& method : methods(arguments.method)) {
      const auto made = make(file->mesh, method, arguments.hacdSeconds);
      const auto rows = made.and_then([&](const Made& result) { return rowsOf(*file, method, result); });
      if (!rows) {
        fmt::print("{:<16} {:>7} {:<8} {:>3} parts: {}\n", file->name, file->mesh.triangles.size(),
                   method.name, method.parts.back(), rows.error().message);
        csv += fmt::format("{},{},{},{},1,1,{},,,{},,,,,,,,,,,\n", file->name, file->mesh.triangles.size(),
                           method.name, method.maxVertices > 0 ? std::to_string(method.maxVertices) : "any",
                           method.parts.back(), "failed");
        continue;
      }
      csv += *rows;
      const std::size_t last = rows->rfind('\n', rows->size() - 2);
      print(*file, method, rows->substr(last == std::string::npos ? 0 : last + 1));
    }
    if (arguments.csv.empty()) continue;
    if (auto written = writeFile(arguments.csv, csv); !written) {
      fmt::print(stderr, "levels_bench: {}\n", written.error().message);
      return 2;
    }
  }
  return 0;
}

}  // namespace
}  // namespace scatter::bench

int main(int argc, char** argv) {
  CLI::App program{
      "Builds levels of well-known meshes, proves and measures them, and does the same with HACD's parts"};
  scatter::bench::Arguments arguments;
  program.add_option("MESH", arguments.meshes, "Mesh files")->required();
  program.add_option("--csv", arguments.csv, "Write a row for each level to this file");
  program.add_option("--method", arguments.method, "Which of them to run")
      ->check(CLI::IsMember({"both", "scatter", "hacd"}))
      ->capture_default_str();
  program.add_option("--hacd-seconds", arguments.hacdSeconds, "Processor time for each decomposition")
      ->capture_default_str();
  CLI11_PARSE(program, argc, argv);
  return scatter::bench::run(arguments);
}
