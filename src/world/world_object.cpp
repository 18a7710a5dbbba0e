#include <scatter/world/world_object.h>

namespace scatter {

WorldObject::WorldObject(Physics& physics, BodyId body, BodyDef def)
    : physics_(physics), body_(body), def_(std::move(def)) {}

}  // namespace scatter
