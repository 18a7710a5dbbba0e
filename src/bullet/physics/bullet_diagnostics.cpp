#include "bullet/physics/bullet_diagnostics.h"

#include <BulletHybrid/btHybridDynamicsWorld.h>

#include "bullet/physics/collision_report.h"
#include "bullet/physics/fidelity.h"
#include "bullet/physics/observer.h"

namespace scatter {

void BulletDiagnostics::observe(const ObservationParts& parts, Observation& out) const {
  out.clear();
  BulletObserver(engine_.world(), engine_.switching(), bodies_.all()).observe(parts, out);
}

FidelitySample BulletDiagnostics::measureFidelity() const {
  return measureBulletFidelity(engine_.world());
}

ContactReport BulletDiagnostics::contactReport() const {
  const btHybridDynamicsWorld* hybrid = engine_.switching();
  return hybrid != nullptr ? fromBullet(hybrid->getContactReport()) : ContactReport{};
}

CollisionMemory BulletDiagnostics::collisionMemory() const {
  const btHybridDynamicsWorld* hybrid = engine_.switching();
  return hybrid != nullptr ? fromBullet(hybrid->getCollisionMemory()) : CollisionMemory{};
}

}  // namespace scatter
