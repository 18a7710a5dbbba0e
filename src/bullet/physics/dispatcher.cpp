#include "bullet/physics/dispatcher.h"

#include "bullet/physics/body.h"

namespace scatter {

namespace {

constinit thread_local std::uint32_t newContacts = 0;

bool contactAdded(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
                  const btCollisionObjectWrapper*, int, int) {
  if (point.m_lifeTime == 0) {
    ++newContacts;
    point.m_lifeTime = 1;
  }
  return false;
}

const BulletBody& bodyOf(const btBroadphaseProxy* proxy) {
  return BulletBody::of(*static_cast<const btCollisionObject*>(proxy->m_clientObject));
}

}  // namespace

BulletDispatcher::BulletDispatcher(btCollisionConfiguration* configuration)
    : btCollisionDispatcher(configuration) {
  setNearCallback(count);
}

void BulletDispatcher::count(btBroadphasePair& pair, btCollisionDispatcher& dispatcher,
                             const btDispatcherInfo& info) {
  const BulletBody& a = bodyOf(pair.m_pProxy0);
  const BulletBody& b = bodyOf(pair.m_pProxy1);
  if (!dispatcher.needsCollision(&a.rigid(), &b.rigid())) return;
  PairCounts& counts = static_cast<BulletDispatcher&>(dispatcher).counts_;
  ++counts.all;
  if (a.isHybrid() || b.isHybrid()) ++counts.withHybrid;
  if (a.level() == a.levelCount() && b.level() == b.levelCount()) ++counts.finest;
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
