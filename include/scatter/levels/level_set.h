#pragma once

#include <scatter/levels/convex_part.h>
#include <scatter/levels/mass_properties.h>
#include <scatter/result.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace scatter {

/// One encapsulation level: a union of convex parts in the model's frame.
struct Level {
  std::vector<ConvexPart> parts;
};

/// What a LevelSet is made of.
struct LevelSetDef {
  std::string name;

  /// levels[0] is level 1, the coarsest; the last one is level n, the finest. Each lies inside the
  /// one before it.
  std::vector<Level> levels;

  /// Collision margin around convex hulls, metres. Boxes, spheres, capsules and cylinders have none.
  float hullMargin = 0.02F;

  /// Of what the finest level's parts fill together, if absent; buildLevels() gives a closed mesh's.
  std::optional<MassProperties> mass;
};

/// Nested collision shapes of a model (report, section 3.4.2). Immutable, shared by all bodies of the
/// model, safe to read from any thread.
class LevelSet {
 public:
  /// Fails on an empty level, a part without volume, a value that is not finite, or levels that are
  /// not nested; the message names the level, the part and by how many metres it sticks out,
  /// levels and parts counted from 1.
  [[nodiscard]] static Result<std::shared_ptr<const LevelSet>> create(LevelSetDef definition);

  [[nodiscard]] const std::string& name() const { return def_.name; }
  [[nodiscard]] int count() const { return static_cast<int>(def_.levels.size()); }

  /// `index` counts from 1, the coarsest, to count(), the finest.
  [[nodiscard]] const Level& level(int index) const {
    return def_.levels[static_cast<std::size_t>(index) - 1];
  }
  [[nodiscard]] const Level& coarsest() const { return def_.levels.front(); }
  [[nodiscard]] const Level& finest() const { return def_.levels.back(); }

  [[nodiscard]] float hullMargin() const { return def_.hullMargin; }

  /// The same at every level.
  [[nodiscard]] const MassProperties& mass() const { return *def_.mass; }

 private:
  explicit LevelSet(LevelSetDef definition) : def_(std::move(definition)) {}

  LevelSetDef def_;
};

/// While one of these exists, LevelSet::create() on this thread takes levels that are not nested, so that a
/// program can read a file and say what is wrong with it. Bodies must not be made from such levels.
class NestingUnchecked {
 public:
  NestingUnchecked();
  NestingUnchecked(const NestingUnchecked&) = delete;
  NestingUnchecked& operator=(const NestingUnchecked&) = delete;
  ~NestingUnchecked();
};

}  // namespace scatter
