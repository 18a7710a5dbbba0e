#include "bullet/physics/fidelity.h"

#include <BulletHybrid/btHybridFidelity.h>

#include "bullet/physics/body.h"

namespace scatter {

namespace {

/// Knows the levels of bodies that cannot switch, in a standard world.
class LevelSetFidelity final : public btHybridFidelity {
 public:
  using btHybridFidelity::btHybridFidelity;
  int getNumLevels(const btCollisionObject* object) const override {
    return BulletBody::of(*object).levelCount();
  }
};

}  // namespace

FidelitySample measureBulletFidelity(const btCollisionWorld& world) {
  const btHybridFidelitySample measured = LevelSetFidelity(&world).measure();
  FidelitySample sample;
  sample.touchingPairs = static_cast<std::uint32_t>(measured.m_touchingPairs);
  sample.visibleOverlapPairs = static_cast<std::uint32_t>(measured.m_visibleOverlapPairs);
  for (int i = 0; i < measured.m_touchingByLevel.size(); ++i) {
    sample.touchingByLevel.push_back(static_cast<std::uint32_t>(measured.m_touchingByLevel[i]));
  }
  for (int i = 0; i < measured.m_contactGaps.size(); ++i) {
    sample.contactGaps.push_back(measured.m_contactGaps[i]);
  }
  return sample;
}

}  // namespace scatter
