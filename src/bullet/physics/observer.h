#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <BulletHybrid/btHybridObservation.h>
#include <scatter/world/observation.h>

#include <memory>
#include <span>

#include "bullet/physics/body.h"

class btHybridDynamicsWorld;

namespace scatter {

/// Reads a Bullet world whose objects are all BulletBodies, between two steps. Changes nothing.
class BulletObserver {
 public:
  /// `switching`: the same world; null in a standard one. `bodies`: by id, which is one more than the index.
  BulletObserver(const btDiscreteDynamicsWorld& world, const btHybridDynamicsWorld* switching,
                 std::span<const std::unique_ptr<BulletBody>> bodies)
      : world_(world), switching_(switching), bodies_(bodies) {}

  /// Adds to `out`, which is empty.
  void observe(const ObservationParts& parts, Observation& out) const;

 private:
  [[nodiscard]] std::span<const btBroadphasePair> pairs() const;
  [[nodiscard]] ObservedBody bodyOf(const BulletBody& body) const;
  void addBodies(Observation& out) const;
  void numberIslands(Observation& out) const;
  void findLevelsInUse(Observation& out) const;
  void addPairs(const ObservationParts& parts, Observation& out) const;
  [[nodiscard]] ObservedPair pairOf(const btBroadphasePair& pair,
                                    const btAlignedObjectArray<btHybridManifoldView>& manifolds) const;

  const btDiscreteDynamicsWorld& world_;
  const btHybridDynamicsWorld* switching_;
  std::span<const std::unique_ptr<BulletBody>> bodies_;
};

}  // namespace scatter
