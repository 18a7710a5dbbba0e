#include "scenes/worlds.h"

#include <algorithm>
#include <cmath>
#include <ostream>

namespace scatter::test {

void PrintTo(const WorldCase& world, std::ostream* out) {
  *out << world.name;
}

PhysicsDef coarsestWorld() {
  PhysicsDef def;
  def.world = WorldKind::kHybrid;
  def.switching.policy = Policy::kCoarsest;
  def.switching.switching = Switching::kBody;
  return def;
}

std::vector<WorldCase> everyWorld() {
  PhysicsDef finest;
  finest.world = WorldKind::kHybrid;
  finest.switching.policy = Policy::kFinest;
  return {{"standard", PhysicsDef{}}, {"finest", finest}, {"coarsest", coarsestWorld()}};
}

std::vector<std::string> objectsOutside(const World& world, float halfWidth, float height, float depth) {
  std::vector<std::string> outside;
  for (const auto& object : world.objects()) {
    if (object->def().motion != Motion::kDynamic) continue;
    const Vec3 at = object->state().centerOfMass;
    const bool inside =
        std::max(std::abs(at.x), std::abs(at.z)) < halfWidth + depth && at.y > -depth && at.y < height;
    if (!inside) outside.push_back(object->name());
  }
  return outside;
}

}  // namespace scatter::test
