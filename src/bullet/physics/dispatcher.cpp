#include "bullet/physics/dispatcher.h"

#include <BulletCollision/BroadphaseCollision/btOverlappingPairCache.h>

#include <atomic>

#include "bullet/physics/body.h"

namespace scatter {

namespace {

// A world that has threads counts on all of them.
constinit std::atomic<std::uint32_t> newContacts = 0;

bool contactAdded(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
                  const btCollisionObjectWrapper*, int, int) {
  if (point.m_lifeTime == 0) {
    newContacts.fetch_add(1, std::memory_order_relaxed);
    point.m_lifeTime = 1;
  }
  return false;
}

const btCollisionObject& objectOf(const btBroadphaseProxy* proxy) {
  return *static_cast<const btCollisionObject*>(proxy->m_clientObject);
}

bool isFinest(const btCollisionObject& object) {
  const btHybridRigidBody* const hybrid = BulletBody::switchingOf(object);
  return hybrid == nullptr || hybrid->getLevel() == hybrid->getFinestLevel();
}

}  // namespace

void BulletDispatcher::dispatchAllCollisionPairs(btOverlappingPairCache* pairs, const btDispatcherInfo& info,
                                                 btDispatcher* dispatcher) {
  const btBroadphasePair* const first = pairs->getOverlappingPairArrayPtr();
  for (int i = 0; i < pairs->getNumOverlappingPairs(); ++i) count(first[i]);
  btCollisionDispatcher::dispatchAllCollisionPairs(pairs, info, dispatcher);
}

void BulletDispatcher::count(const btBroadphasePair& pair) {
  // Of the objects alone, which Bullet is going to look at: in a pile, all else would have to be fetched.
  const btCollisionObject& a = objectOf(pair.m_pProxy0);
  const btCollisionObject& b = objectOf(pair.m_pProxy1);
  if (!needsCollision(&a, &b)) return;
  ++counts_.all;
  if (BulletBody::isHybrid(a) || BulletBody::isHybrid(b)) ++counts_.withHybrid;
  if (isFinest(a) && isFinest(b)) ++counts_.finest;
}

NewContactCounter::NewContactCounter() : before_(gContactAddedCallback) {
  newContacts = 0;
  gContactAddedCallback = contactAdded;
}

NewContactCounter::~NewContactCounter() {
  gContactAddedCallback = before_;
}

std::uint32_t NewContactCounter::count() {
  return newContacts;
}

}  // namespace scatter
