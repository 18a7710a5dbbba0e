#pragma once

#include <scatter/world/diagnostics.h>

#include "bullet/physics/bodies.h"
#include "bullet/physics/engine.h"

namespace scatter {

/// What a BulletPhysics tells of its world.
class BulletDiagnostics final : public PhysicsDiagnostics {
 public:
  /// Both outlive it.
  BulletDiagnostics(const BulletEngine& engine, const BulletBodies& bodies)
      : engine_(engine), bodies_(bodies) {}

  void observe(const ObservationParts& parts, Observation& out) const override;
  [[nodiscard]] FidelitySample measureFidelity() const override;
  [[nodiscard]] ContactReport contactReport() const override;
  [[nodiscard]] CollisionMemory collisionMemory() const override;

 private:
  const BulletEngine& engine_;
  const BulletBodies& bodies_;
};

}  // namespace scatter
