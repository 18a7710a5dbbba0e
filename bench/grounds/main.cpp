#include <scatter/io/file.h>
#include <scatter/lab/environment.h>

#include <spdlog/fmt/fmt.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <string>

#include "worlds.h"

// What bodies of many hulls, and bare ones, cost on everything that they may lie on: plain Bullet against the
// pair algorithm in worlds of every kind.

namespace scatter::bench {
namespace {

struct Arguments {
  int repeat = 5;
  int steps = 600;
  std::uint64_t seed = 1;
  std::string only;
  std::string csv;
  bool contacts = false;
  bool oneFriction = false;
};

struct Scene {
  const char* name;
  Trial trial;
};

struct World {
  WorldKind kind;
  const char* name;
  std::size_t base;  ///< The world of its kind in which Bullet is alone.
};

constexpr World kWorlds[] = {{WorldKind::kPlain, "plain", 0},
                             {WorldKind::kInstalled, "installed", 0},
                             {WorldKind::kHybrid, "hybrid", 0},
                             {WorldKind::kMultiBody, "multi", 3},
                             {WorldKind::kMultiBodyInstalled, "multi+in.", 3}};

std::vector<Scene> scenesOf(const Arguments& arguments) {
  using enum GroundKind;
  std::vector<Scene> scenes{{"ships-mesh", {BodyKind::kShip, 300, kMesh, 4.0F}},
                            {"ships-field", {BodyKind::kShip, 300, kHeightField, 4.0F}},
                            {"ships-box", {BodyKind::kShip, 300, kBox}},
                            {"wheels-mesh", {BodyKind::kWheel, 80, kMesh, 0.0F}},
                            {"wheels-hills", {BodyKind::kWheel, 80, kMesh, 3.0F}},
                            {"wheels-plane", {BodyKind::kWheel, 80, kPlane}},
                            {"wheels-box", {BodyKind::kWheel, 80, kBox}},
                            {"wheels-hull", {BodyKind::kWheel, 80, kHull}},
                            {"plates-mesh", {BodyKind::kPlate, 300, kMesh, 4.0F}},
                            {"plates-flat", {BodyKind::kPlate, 300, kMesh, 0.0F}},
                            {"plates-field", {BodyKind::kPlate, 300, kHeightField, 4.0F}},
                            {"rocks-mesh", {BodyKind::kRock, 600, kMesh, 4.0F}},
                            {"rocks-field", {BodyKind::kRock, 600, kHeightField, 4.0F}},
                            {"rocks-plane", {BodyKind::kRock, 600, kPlane}},
                            {"rocks-box", {BodyKind::kRock, 600, kBox}},
                            {"crates-mesh", {BodyKind::kCrate, 600, kMesh, 4.0F}},
                            {"crates-field", {BodyKind::kCrate, 600, kHeightField, 4.0F}},
                            {"crates-plane", {BodyKind::kCrate, 600, kPlane}}};
  for (Scene& scene : scenes) {
    scene.trial.steps = arguments.steps;
    scene.trial.seed = arguments.seed;
    scene.trial.oneFriction = arguments.oneFriction;
  }
  return scenes;
}

/// A ratio to Bullet alone in the same repeat, over all repeats.
struct Spread {
  double median = 0.0;
  double least = 0.0;
  double most = 0.0;
};

template <class Value>
Spread spreadOf(const std::vector<std::vector<Cost>>& costs, std::size_t world, const Value& value) {
  std::vector<double> ratios;
  for (const auto& repeat : costs)
    ratios.push_back(value(repeat[world]) / value(repeat[kWorlds[world].base]));
  std::sort(ratios.begin(), ratios.end());
  return {ratios[ratios.size() / 2], ratios.front(), ratios.back()};
}

struct Row {
  const char* scene = "";
  const char* world = "";
  Cost last;
  Spread total;
  Spread p99;
  Spread detection;
  Spread awake;
};

Row rowOf(const char* scene, const std::vector<std::vector<Cost>>& costs, std::size_t world) {
  const auto spread = [&](const auto& value) { return spreadOf(costs, world, value); };
  return {scene,
          kWorlds[world].name,
          costs.back()[world],
          spread([](const Cost& cost) { return cost.total; }),
          spread([](const Cost& cost) { return cost.p99; }),
          spread([](const Cost& cost) { return cost.detection; }),
          spread([](const Cost& cost) { return cost.total / cost.bodySteps; })};
}

void print(const Row& row) {
  std::printf("%-12s %-9s %8.0f %6.3f %6.3f-%5.3f %6.3f %6.3f %6.3f %7.0f %6.2f %6.1f %5d\n", row.scene,
              row.world, row.last.total, row.total.median, row.total.least, row.total.most, row.p99.median,
              row.detection.median, row.awake.median, row.last.contacts, row.last.asked / row.last.bodySteps,
              1e3 * static_cast<double>(row.last.deepest), row.last.sunk);
  std::fflush(stdout);
}

const std::string kHeader =
    "scene,world,seed,steps,repeats,one_friction,total_ms,total_ratio,total_ratio_min,total_ratio_max,p99_"
    "ratio,"
    "p99_ratio_min,p99_ratio_max,detection_ratio,detection_ratio_min,detection_ratio_max,awake_ratio,"
    "awake_ratio_min,awake_ratio_max,contacts,deepest_m,sunk,commit,compiler,flags,cpu\n";

std::string csvOf(const Row& row, const Arguments& arguments) {
  const BuildInfo build = buildInfo();
  std::string text =
      fmt::format("{},{},{},{},{},{},{}", row.scene, row.world, arguments.seed, arguments.steps,
                  arguments.repeat, arguments.oneFriction ? 1 : 0, row.last.total);
  for (const Spread& spread : {row.total, row.p99, row.detection, row.awake})
    text += fmt::format(",{},{},{}", spread.median, spread.least, spread.most);
  return text + fmt::format(",{},{},{},{},{},{},{}\n", row.last.contacts, row.last.deepest, row.last.sunk,
                            build.commit, build.compiler, build.flags, machineInfo().cpu);
}

// Of several seeds, as one pile has few parts on the ground.
void compareAll(const Arguments& arguments) {
  std::printf("%-12s %5s %7s %7s %7s %7s %8s %8s %9s %8s %5s\n", "scene", "seed", "parts", "same", "missed",
              "deep", "extra", "p99 mm", "less mm", "true mm", "sunk");
  for (Scene scene : scenesOf(arguments)) {
    if (!arguments.only.empty() && std::string(scene.name).find(arguments.only) == std::string::npos)
      continue;
    for (int i = 0; i < arguments.repeat; ++i) {
      scene.trial.seed = arguments.seed + static_cast<std::uint64_t>(i);
      const Contacts c = compareContacts(scene.trial);
      const double same = 100.0 * c.sameCount / std::max(c.parts, 1);
      std::printf("%-12s %5d %7d %6.2f%% %7d %7d %8d %8.4f %9.4f %8.4f %5d\n", scene.name,
                  static_cast<int>(scene.trial.seed), c.parts, same, c.missed, c.missedDeep, c.extra,
                  c.depthP99, c.shallower, c.trueDepth, c.sunk);
      std::fflush(stdout);
    }
  }
}

int runAll(const Arguments& arguments) {
  std::string csv = kHeader;
  std::printf("%-12s %-9s %8s %6s %12s %6s %6s %6s %7s %6s %6s %5s\n", "scene", "world", "total ms", "total",
              "from-to", "p99", "detect", "awake", "points", "asked", "mm", "sunk");
  for (const Scene& scene : scenesOf(arguments)) {
    if (!arguments.only.empty() && std::string(scene.name).find(arguments.only) == std::string::npos)
      continue;
    std::vector<std::vector<Cost>> costs;
    for (int i = 0; i < arguments.repeat; ++i) {
      costs.emplace_back();
      for (const World& world : kWorlds) costs.back().push_back(bench::run(scene.trial, world.kind));
    }
    for (std::size_t world = 0; world < std::size(kWorlds); ++world) {
      const Row row = rowOf(scene.name, costs, world);
      print(row);
      csv += csvOf(row, arguments);
    }
    // What there is by now, in case that it is cut short.
    if (arguments.csv.empty()) continue;
    if (auto written = writeFile(arguments.csv, csv); !written) {
      std::fprintf(stderr, "ground_bench: %s\n", written.error().message.c_str());
      return 2;
    }
  }
  return 0;
}

}  // namespace
}  // namespace scatter::bench

int main(int argc, char** argv) {
  scatter::bench::Arguments arguments;
  CLI::App app("What bodies of many hulls cost on grounds of every kind, as ratios to plain Bullet");
  app.add_option("--repeat", arguments.repeat, "Runs of each world, interleaved")->check(CLI::Range(1, 100));
  app.add_option("--steps", arguments.steps, "Steps of each run")->check(CLI::Range(1, 100000));
  app.add_option("--seed", arguments.seed, "Of bodies and ground");
  app.add_option("--only", arguments.only, "Part of a scene's name");
  app.add_option("--csv", arguments.csv, "Write a row for each scene and world to this file");
  app.add_flag("--one-friction", arguments.oneFriction,
               "Multi-body worlds solve one direction of friction, as discrete ones do, in the place of two");
  app.add_flag("--contacts", arguments.contacts,
               "Instead: compare contacts where the bodies end, in fresh worlds");
  CLI11_PARSE(app, argc, argv);
  if (arguments.contacts) {
    scatter::bench::compareAll(arguments);
    return 0;
  }
  return scatter::bench::runAll(arguments);
}
