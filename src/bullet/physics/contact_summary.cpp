#include "bullet/physics/contact_summary.h"

#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>

namespace scatter {

namespace {

float deepestIn(const btPersistentManifold& manifold) {
  float deepest = 0.0F;
  for (int i = 0; i < manifold.getNumContacts(); ++i) {
    deepest = std::max(deepest, -manifold.getContactPoint(i).getDistance());
  }
  return deepest;
}

}  // namespace

ContactSummary summarizeContacts(btDispatcher& dispatcher) {
  ContactSummary summary;
  const int count = dispatcher.getNumManifolds();
  summary.manifolds = static_cast<std::uint32_t>(count);
  btPersistentManifold* const* const manifolds =
      count > 0 ? dispatcher.getInternalManifoldPointer() : nullptr;
  for (int i = 0; i < count; ++i) {
    const btPersistentManifold& manifold = *manifolds[i];
    if (manifold.getNumContacts() == 0) continue;
    summary.contacts += static_cast<std::uint32_t>(manifold.getNumContacts());
    if (!dispatcher.needsResponse(manifold.getBody0(), manifold.getBody1())) continue;
    summary.deepest = std::max(summary.deepest, deepestIn(manifold));
  }
  return summary;
}

}  // namespace scatter
