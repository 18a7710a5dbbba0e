#include "scenes/anchor.h"

#include <utility>

namespace scatter {

Result<WorldObject*> addAnchor(World& world) {
  BodyDef anchor;
  anchor.name = "world";
  anchor.shape = Sphere{0.01F};
  anchor.motion = Motion::kStatic;
  anchor.sensor = true;
  anchor.group = 0;
  anchor.collidesWith = 0;
  return world.add(std::move(anchor));
}

}  // namespace scatter
