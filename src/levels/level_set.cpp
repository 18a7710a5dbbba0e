#include <scatter/levels/containment.h>
#include <scatter/levels/level_set.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "levels/part_check.h"
#include "levels/text.h"

namespace scatter {
namespace {

/// How many NestingUnchecked there are.
thread_local int uncheckedDepth = 0;

std::string levelText(std::size_t index) {
  return "level " + std::to_string(index + 1);
}

Result<void> checkParts(const std::vector<Level>& levels) {
  if (levels.empty()) return fail("has no levels; give at least one");
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (levels[i].parts.empty()) return fail(levelText(i) + " has no parts; give at least one");
    const Result<void> sound = levels::checkVolumes(levels[i].parts);
    if (!sound) return fail(levelText(i) + ", " + sound.error().message);
  }
  return {};
}

Result<void> checkMass(const MassProperties& mass) {
  bool sound = std::isfinite(mass.volume) && mass.volume > 0.0F && levels::isFinite(mass.centerOfMass);
  for (int axis = 0; axis < 3; ++axis) {
    sound = sound && levels::isFinite(Vec3(mass.inertia[axis])) && mass.inertia[axis][axis] > 0.0F;
  }
  if (sound) return {};
  return fail("mass properties must be finite, with a positive volume and inertia");
}

/// That of the finest level, if none is given.
Result<void> completeMass(LevelSetDef& definition) {
  if (!definition.mass) {
    const Result<MassProperties> finest = massProperties(definition.levels.back().parts);
    if (!finest) return fail(levelText(definition.levels.size() - 1) + ", " + finest.error().message);
    definition.mass = *finest;
  }
  return checkMass(*definition.mass);
}

Result<void> checkNesting(const std::vector<Level>& levels, float hullMargin) {
  for (std::size_t i = 1; i < levels.size(); ++i) {
    const auto gap = findContainmentGap(levels[i], levels[i - 1], hullMargin);
    if (!gap) return fail(levelText(i) + " and " + levelText(i - 1) + ": " + gap.error().message);
    if (!gap->has_value()) continue;
    const ContainmentGap& worst = **gap;
    return fail(levelText(i) + ", part " + std::to_string(worst.part + 1) + " sticks out of " +
                levelText(i - 1) + " by " + levels::toText(static_cast<double>(worst.distance)) + " m at " +
                levels::toText(worst.point) + "; enlarge " + levelText(i - 1) + " there or move the part");
  }
  return {};
}

Result<void> complete(LevelSetDef& definition) {
  if (!std::isfinite(definition.hullMargin) || definition.hullMargin < 0.0F) {
    return fail("hull margin " + levels::toText(static_cast<double>(definition.hullMargin)) +
                " must be finite and not negative");
  }
  if (auto sound = checkParts(definition.levels); !sound) return sound;
  if (auto sound = completeMass(definition); !sound) return sound;
  return uncheckedDepth > 0 ? Result<void>() : checkNesting(definition.levels, definition.hullMargin);
}

}  // namespace

NestingUnchecked::NestingUnchecked() {
  ++uncheckedDepth;
}

NestingUnchecked::~NestingUnchecked() {
  --uncheckedDepth;
}

Result<std::shared_ptr<const LevelSet>> LevelSet::create(LevelSetDef definition) {
  if (const Result<void> done = complete(definition); !done) {
    return fail("model \"" + definition.name + "\": " + done.error().message);
  }
  return std::shared_ptr<const LevelSet>(new LevelSet(std::move(definition)));
}

}  // namespace scatter
