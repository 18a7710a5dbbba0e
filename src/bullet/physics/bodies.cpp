#include "bullet/physics/bodies.h"

#include <cassert>
#include <utility>

namespace scatter {

BulletBody& BulletBodies::make(const BodyDef& def, std::shared_ptr<const BulletShape> shape,
                               LevelStart start) {
  const BodyId id{static_cast<std::uint32_t>(bodies_.size() + 1)};
  bodies_.push_back(std::make_unique<BulletBody>(id, def, std::move(shape), start));
  BulletBody& body = *bodies_.back();
  ++count_;
  if (body.isHybrid()) ++hybridCount_;
  return body;
}

void BulletBodies::destroy(BodyId body) {
  --count_;
  if (at(body).isHybrid()) --hybridCount_;
  bodies_[static_cast<std::size_t>(body) - 1].reset();
}

BulletBody& BulletBodies::at(BodyId body) {
  const auto index = static_cast<std::size_t>(body) - 1;
  assert(index < bodies_.size() && bodies_[index] && "unknown body");
  return *bodies_[index];
}

const BulletBody& BulletBodies::at(BodyId body) const {
  return const_cast<BulletBodies*>(this)->at(body);
}

}  // namespace scatter
