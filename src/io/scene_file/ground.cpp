#include "io/scene_file/ground.h"

#include <cmath>
#include <string>
#include <vector>

#include "io/collada/xml_source.h"

namespace scatter::io {
namespace {

constexpr float kMostCells = 250'000.0F;

/// The two numbers that must be below `key`.
std::array<float, 2> readPair(const SceneTable& table, std::string_view key) {
  std::vector<float> numbers;
  table.need(key, numbers);
  if (numbers.size() == 2) return {numbers[0], numbers[1]};
  table.report(key, inQuotes(key) + " in terrain must be two numbers, along x and along z");
  return {1.0F, 1.0F};
}

}  // namespace

std::string_view staticKind(const SceneFileShape& shape) {
  if (std::holds_alternative<SceneFilePlane>(shape)) return "a plane";
  if (std::holds_alternative<SceneFileMesh>(shape)) return "a mesh";
  if (std::holds_alternative<SceneFileTerrain>(shape)) return "a terrain";
  return {};
}

SceneFileTerrain readTerrain(const SceneTable& object) {
  SceneFileTerrain terrain;
  const auto table = object.table("terrain", "object.terrain");
  if (!table) return terrain;
  terrain.size = readPair(*table, "size");
  const std::array<float, 2> cells = readPair(*table, "cells");
  if (cells[0] != std::floor(cells[0]) || cells[1] != std::floor(cells[1])) {
    table->report("cells", R"("cells" in terrain must be whole numbers)");
  }
  if (cells[0] * cells[1] > kMostCells) {
    table->report("cells",
                  "a terrain of more than " + std::to_string(static_cast<int>(kMostCells)) + " cells");
  }
  terrain.cells = {static_cast<std::uint32_t>(cells[0]), static_cast<std::uint32_t>(cells[1])};
  table->need("relief", terrain.relief);
  table->read("roughness", terrain.roughness);
  table->readWhole("seed", terrain.seed);
  terrain.isHeightField = table->choose("kind", {"mesh", "height_field"}) == std::size_t{1};
  return terrain;
}

}  // namespace scatter::io
