#pragma once

#include <scatter/world/physics.h>
#include <scatter/world/world.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace scatter::test {

/// A world that a scene has to run well in.
struct WorldCase {
  const char* name;
  PhysicsDef def;
};

void PrintTo(const WorldCase& world, std::ostream* out);

/// The standard world, and hybrid worlds with everything at level n and with everything at level 1.
[[nodiscard]] std::vector<WorldCase> everyWorld();
[[nodiscard]] PhysicsDef coarsestWorld();

/// The names of the dynamic objects whose centre of mass is outside of a room around the origin with its
/// floor at height zero, by more than `depth`: in the step in which something fast hits a wall, it goes into
/// it.
[[nodiscard]] std::vector<std::string> objectsOutside(const World& world, float halfWidth, float height,
                                                      float depth = 0.2F);

}  // namespace scatter::test
