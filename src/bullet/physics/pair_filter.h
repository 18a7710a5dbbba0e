#pragma once

#include <BulletCollision/BroadphaseCollision/btOverlappingPairCache.h>

namespace scatter {

/// Lets pairs through whose groups agree and of which at least one body is dynamic.
class BulletPairFilter final : public btOverlapFilterCallback {
 public:
  bool needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const override;
};

}  // namespace scatter
