#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/gltf/notes.h"
#include "io/gltf/shapes.h"

namespace scatter::io {
namespace {

/// A part under the scale of its node. Nothing if that cannot be done exactly.
std::optional<ConvexPart> readPart(GltfFile& file, const JsonPlace& place, const glm::dmat3& stretch) {
  const auto shape = readGltfShape(file, place);
  if (!shape) {
    return std::nullopt;
  }
  GltfPlacement base;
  base.stretch = stretch;
  GltfPlacement local;
  const Transform pose = readTransform(place);
  local.position = pose.position;
  local.rotation = pose.rotation;
  const GltfPlacement placement = base * local;
  auto scaled = scaleShape(*shape, placement.stretch);
  if (!scaled || !scaled->note.empty() || !std::holds_alternative<ConvexShape>(scaled->geometry)) {
    return std::nullopt;
  }
  return ConvexPart{std::get<ConvexShape>(std::move(scaled->geometry)), placement.rigid()};
}

std::optional<Level> readLevel(GltfFile& file, const JsonPlace& parts, const glm::dmat3& stretch) {
  Level level;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    auto part = readPart(file, parts[i], stretch);
    if (!part) {
      file.warn(parts[i],
                "is not convex, or the scale of its node changes its kind; the levels are left out");
      return std::nullopt;
    }
    level.parts.push_back(std::move(*part));
  }
  return level;
}

MassProperties readMassProperties(const JsonPlace& place) {
  constexpr double kLargest = 1e30;
  MassProperties mass;
  mass.volume = static_cast<float>(place.at("volume").number(0.0, kLargest));
  mass.centerOfMass = Vec3(place.at("centerOfMass").vector());
  const JsonPlace inertia = place.at("inertia");
  constexpr std::size_t kEntries = 9;
  if (inertia.size() != kEntries) {
    inertia.fail("should hold 9 numbers");
  }
  for (std::size_t i = 0; i < kEntries; ++i) {
    const double value = inertia[i].number(-kLargest, kLargest);
    mass.inertia[static_cast<int>(i / 3)][static_cast<int>(i % 3)] = static_cast<float>(value);
  }
  return mass;
}

}  // namespace

std::shared_ptr<const LevelSet> readLevels(GltfFile& file, const JsonPlace& levels,
                                           const std::string& modelName,
                                           const std::vector<ConvexPart>& finest, const glm::dmat3& stretch) {
  LevelSetDef definition;
  const auto name = levels.find("name");
  definition.name = name ? name->text() : modelName;
  definition.hullMargin = static_cast<float>(levels.at("hullMargin").size(0.0));
  const JsonPlace list = levels.at("levels");
  for (std::size_t i = 0; i < list.size(); ++i) {
    auto level = readLevel(file, list[i], stretch);
    if (!level) {
      return nullptr;
    }
    definition.levels.push_back(std::move(*level));
  }
  if (const auto own = levels.find("finest")) {
    auto level = readLevel(file, *own, stretch);
    if (!level) {
      return nullptr;
    }
    definition.levels.push_back(std::move(*level));
  } else {
    definition.levels.push_back({finest});
  }
  if (const auto mass = levels.find("mass")) {
    definition.mass = readMassProperties(*mass);
  }
  file.budget().spend(levelCost(definition.levels), levels);
  auto made = LevelSet::create(std::move(definition));
  if (!made) {
    levels.fail(made.error().message);
  }
  return *made;
}

}  // namespace scatter::io
