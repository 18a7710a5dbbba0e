#include "bullet/physics/state_hash.h"

#include <bit>

namespace scatter {

namespace {

std::array<std::uint32_t, 3> bitsOf(const btVector3& v) {
  return {std::bit_cast<std::uint32_t>(v.x()), std::bit_cast<std::uint32_t>(v.y()),
          std::bit_cast<std::uint32_t>(v.z())};
}

}  // namespace

StateBits stateBitsOf(const BulletBody& body) {
  const btTransform& pose = body.rigid().getWorldTransform();
  StateBits bits;
  bits.position = bitsOf(pose.getOrigin());
  for (std::size_t row = 0; row < 3; ++row) {
    const auto words = bitsOf(pose.getBasis().getRow(static_cast<int>(row)));
    for (std::size_t i = 0; i < 3; ++i) bits.orientation[3 * row + i] = words[i];
  }
  bits.linearVelocity = bitsOf(body.rigid().getLinearVelocity());
  bits.angularVelocity = bitsOf(body.rigid().getAngularVelocity());
  return bits;
}

void StateHash::add(std::uint32_t word) {
  constexpr std::uint64_t kPrime = 0x100000001b3U;
  hash_ = (hash_ ^ word) * kPrime;
  hash_ ^= hash_ >> 29U;
}

void StateHash::add(const BulletBody& body) {
  const StateBits bits = stateBitsOf(body);
  add(static_cast<std::uint32_t>(body.id()));
  for (const std::uint32_t word : bits.position) add(word);
  for (const std::uint32_t word : bits.orientation) add(word);
  for (const std::uint32_t word : bits.linearVelocity) add(word);
  for (const std::uint32_t word : bits.angularVelocity) add(word);
  add(static_cast<std::uint32_t>(body.level()));
}

}  // namespace scatter
