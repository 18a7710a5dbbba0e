#include "bullet/physics/dispatcher.h"

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

BulletDispatcher::BulletDispatcher(btCollisionConfiguration* configuration)
    : btCollisionDispatcher(configuration) {
  setNearCallback(count);
}

void BulletDispatcher::count(btBroadphasePair& pair, btCollisionDispatcher& dispatcher,
                             const btDispatcherInfo& info) {
  // Of the objects alone, which Bullet is going to look at: in a pile, all else would have to be fetched.
  const btCollisionObject& a = objectOf(pair.m_pProxy0);
  const btCollisionObject& b = objectOf(pair.m_pProxy1);
  if (!dispatcher.needsCollision(&a, &b)) return;
  PairCounts& counts = static_cast<BulletDispatcher&>(dispatcher).counts_;
  ++counts.all;
  if (BulletBody::isHybrid(a) || BulletBody::isHybrid(b)) ++counts.withHybrid;
  if (isFinest(a) && isFinest(b)) ++counts.finest;
  defaultNearCallback(pair, dispatcher, info);
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
