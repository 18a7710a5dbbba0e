#include "bullet/physics/state_hash.h"

#include <bit>

namespace scatter {

void StateHash::add(std::uint32_t word) {
  constexpr std::uint64_t kPrime = 0x100000001b3U;
  hash_ = (hash_ ^ word) * kPrime;
  hash_ ^= hash_ >> 29U;
}

void StateHash::add(float value) {
  add(std::bit_cast<std::uint32_t>(value));
}

void StateHash::add(const btVector3& v) {
  add(v.x());
  add(v.y());
  add(v.z());
}

void StateHash::add(const BulletBody& body) {
  const btTransform& pose = body.rigid().getWorldTransform();
  add(static_cast<std::uint32_t>(body.id()));
  add(pose.getOrigin());
  for (int row = 0; row < 3; ++row) add(pose.getBasis().getRow(row));
  add(body.rigid().getLinearVelocity());
  add(body.rigid().getAngularVelocity());
  add(static_cast<std::uint32_t>(body.level()));
}

}  // namespace scatter
