#include <scatter/world/physics.h>

#include <bit>

namespace scatter {

namespace {

/// Has no state, so that all engines may share it, whatever thread they are in.
LevelSwitching& noSwitching() {
  static LevelSwitching none;
  return none;
}

std::array<std::uint32_t, 3> bitsOf(const Vec3& v) {
  return {std::bit_cast<std::uint32_t>(v.x), std::bit_cast<std::uint32_t>(v.y),
          std::bit_cast<std::uint32_t>(v.z)};
}

}  // namespace

StateBits Physics::stateBits(BodyId body) const {
  const BodyState state = this->state(body);
  StateBits bits;
  bits.position = bitsOf(state.pose.position);
  for (int i = 0; i < 4; ++i) {
    bits.orientation[static_cast<std::size_t>(i)] = std::bit_cast<std::uint32_t>(state.pose.rotation[i]);
  }
  bits.linearVelocity = bitsOf(state.linearVelocity);
  bits.angularVelocity = bitsOf(state.angularVelocity);
  return bits;
}

LevelSwitching& Physics::switching() {
  return noSwitching();
}

const LevelSwitching& Physics::switching() const {
  return noSwitching();
}

const PhysicsDiagnostics& Physics::diagnostics() const {
  static const PhysicsDiagnostics none;
  return none;
}

}  // namespace scatter
