#pragma once

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/BroadphaseCollision/btOverlappingPairCache.h>

namespace scatter {

/// Lets pairs through whose groups agree and of which at least one body is dynamic.
class BulletPairFilter final : public btOverlapFilterCallback {
 public:
  bool needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const override;
};

/// Bullet's dynamic-tree broadphase with the same results in every run.
///
/// btDbvt::optimizeIncremental() orders tree nodes by their address, so the trees, the order of pairs and
/// with it the whole simulation depend on where the heap happened to place them. Here leaves are taken
/// out and inserted again at the same rate, without that ordering.
class BulletBroadphase final : public btDbvtBroadphase {
 public:
  BulletBroadphase();

  void calculateOverlappingPairs(btDispatcher* dispatcher) override;

 private:
  BulletPairFilter filter_;
};

}  // namespace scatter
