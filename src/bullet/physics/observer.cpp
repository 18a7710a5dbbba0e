#include "bullet/physics/observer.h"

#include <BulletHybrid/btHybridDynamicsWorld.h>

#include <algorithm>
#include <vector>

#include "bullet/physics/level_listener.h"
#include "bullet/shapes/conversions.h"
#include "lod/cost_model.h"

namespace scatter {

namespace {

/// Metres; as the counters have it.
constexpr float kTouching = 0.01F;

using Manifolds = btAlignedObjectArray<btHybridManifoldView>;

const BulletBody& bodyOfProxy(const btBroadphaseProxy* proxy) {
  return BulletBody::of(*static_cast<const btCollisionObject*>(proxy->m_clientObject));
}

std::optional<ObservedRequest> requestOf(const btHybridRequestView& view, bool rests) {
  if (view.m_targetLevel == 0) return std::nullopt;
  ObservedRequest request;
  request.target = view.m_targetLevel;
  request.scope = view.m_scope;
  request.policy = view.m_policy;
  request.waitingSteps = static_cast<std::uint32_t>(view.m_waitingSteps);
  if (view.m_blockedBy != nullptr) request.blockedBy = BulletBody::of(*view.m_blockedBy).id();
  if (rests) {
    request.state = RequestState::kAsleep;
  } else if (view.m_tried) {
    request.state = RequestState::kBlocked;
    request.retrySteps = static_cast<std::uint32_t>(view.m_retrySteps);
  }
  return request;
}

/// Of a pair whose work nobody has counted: with what found its contacts.
float unitsOf(const Manifolds& manifolds) {
  lod::LooseContacts contacts;
  contacts.manifolds = manifolds.size();
  for (int i = 0; i < manifolds.size(); ++i) contacts.points += manifolds[i].m_manifold->getNumContacts();
  return static_cast<float>(lod::CostModel(lod::CostWeights()).units(contacts));
}

Nearness nearnessOf(const Manifolds& manifolds) {
  Nearness nearness = Nearness::kApart;
  for (int i = 0; i < manifolds.size(); ++i) {
    const btPersistentManifold& manifold = *manifolds[i].m_manifold;
    for (int k = 0; k < manifold.getNumContacts(); ++k) {
      if (manifold.getContactPoint(k).getDistance() < kTouching) return Nearness::kTouching;
      nearness = Nearness::kNear;
    }
  }
  return nearness;
}

void addContacts(const btHybridManifoldView& view, std::vector<ObservedContact>& contacts) {
  const btPersistentManifold& manifold = *view.m_manifold;
  for (int k = 0; k < manifold.getNumContacts(); ++k) {
    const btManifoldPoint& point = manifold.getContactPoint(k);
    contacts.push_back({.a = BulletBody::of(*manifold.getBody0()).id(),
                        .b = BulletBody::of(*manifold.getBody1()).id(),
                        .pointA = fromBullet(point.getPositionWorldOnA()),
                        .pointB = fromBullet(point.getPositionWorldOnB()),
                        .normal = fromBullet(point.m_normalWorldOnB),
                        .distance = point.getDistance(),
                        .credit = view.m_credit,
                        .kept = view.m_isHeld,
                        .impulse = point.getAppliedImpulse()});
  }
}

}  // namespace

void BulletObserver::observe(const ObservationParts& parts, Observation& out) const {
  if (parts.bodies) addBodies(out);
  if (parts.pairs || parts.contacts) addPairs(parts, out);
}

std::span<const btBroadphasePair> BulletObserver::pairs() const {
  const btOverlappingPairCache& cache = *world_.getBroadphase()->getOverlappingPairCache();
  const int count = cache.getNumOverlappingPairs();
  if (count == 0) return {};
  return {cache.getOverlappingPairArrayPtr(), static_cast<std::size_t>(count)};
}

void BulletObserver::addBodies(Observation& out) const {
  for (const auto& body : bodies_) {
    if (body) out.bodies.push_back(bodyOf(*body));
  }
  numberIslands(out);
  if (switching_ != nullptr && switching_->getSwitchingMode() == BT_HYBRID_PAIR_SWITCHING)
    findLevelsInUse(out);
}

ObservedBody BulletObserver::bodyOf(const BulletBody& body) const {
  const btBroadphaseProxy& proxy = *body.rigid().getBroadphaseHandle();
  ObservedBody observed;
  observed.body = body.id();
  observed.boundsMin = fromBullet(proxy.m_aabbMin);
  observed.boundsMax = fromBullet(proxy.m_aabbMax);
  observed.asleep = body.isAsleep();
  observed.frozen = body.isFrozen();
  observed.held = body.isHeld();
  observed.coarsestLevel = observed.finestLevel = body.level();
  if (body.switching() != nullptr) {
    observed.request = requestOf(switching_->viewRequest(body.switching()), !body.rigid().isActive());
  }
  return observed;
}

void BulletObserver::numberIslands(Observation& out) const {
  // By the engine's number, which follows its own order; bodies come in the order of their ids.
  std::vector<std::int64_t> first;
  for (ObservedBody& observed : out.bodies) {
    const auto id = static_cast<std::int64_t>(observed.body);
    const btRigidBody& rigid = bodies_[static_cast<std::size_t>(observed.body) - 1]->rigid();
    if (rigid.isStaticOrKinematicObject()) continue;
    observed.island = id;
    // New, or thawed, since the last step.
    if (rigid.getIslandTag() < 0) continue;
    const auto tag = static_cast<std::size_t>(rigid.getIslandTag());
    if (tag >= first.size()) first.resize(tag + 1, -1);
    if (first[tag] < 0) first[tag] = id;
    observed.island = first[tag];
  }
}

void BulletObserver::findLevelsInUse(Observation& out) const {
  for (ObservedBody& observed : out.bodies) {
    observed.coarsestLevel = bodies_[static_cast<std::size_t>(observed.body) - 1]->levelCount();
    observed.finestLevel = 0;
  }
  for (const btBroadphasePair& pair : pairs()) {
    const int level = switching_->viewPair(pair).m_level;
    for (const btBroadphaseProxy* proxy : {pair.m_pProxy0, pair.m_pProxy1}) {
      const BulletBody& body = bodyOfProxy(proxy);
      const auto found = std::lower_bound(out.bodies.begin(), out.bodies.end(), body.id(),
                                          [](const ObservedBody& one, BodyId id) { return one.body < id; });
      // Bodies with fewer levels than the pair take part with their finest.
      const int own = body.switching() != nullptr ? std::min(level, body.levelCount()) : body.levelCount();
      found->coarsestLevel = std::min(found->coarsestLevel, own);
      found->finestLevel = std::max(found->finestLevel, own);
    }
  }
  for (ObservedBody& observed : out.bodies) {
    if (observed.finestLevel == 0) observed.finestLevel = observed.coarsestLevel;
  }
}

void BulletObserver::addPairs(const ObservationParts& parts, Observation& out) const {
  Manifolds manifolds;
  for (const btBroadphasePair& pair : pairs()) {
    manifolds.resizeNoInitialize(0);
    btHybridGetManifolds(pair, manifolds);
    if (parts.pairs) {
      out.pairs.push_back(pairOf(pair, manifolds));
    }
    if (!parts.contacts) continue;
    for (int i = 0; i < manifolds.size(); ++i) addContacts(manifolds[i], out.contacts);
  }
}

ObservedPair BulletObserver::pairOf(const btBroadphasePair& pair, const Manifolds& manifolds) const {
  const BulletBody& a = bodyOfProxy(pair.m_pProxy0);
  const BulletBody& b = bodyOfProxy(pair.m_pProxy1);
  ObservedPair observed;
  observed.a = a.id();
  observed.b = b.id();
  observed.nearness = nearnessOf(manifolds);
  const bool rests = !a.rigid().isActive() && !b.rigid().isActive();
  if (!rests) observed.units = unitsOf(manifolds);
  if (switching_ == nullptr) return observed;
  const btHybridPairView view = switching_->viewPair(pair);
  observed.level = view.m_level;
  observed.levelCount = view.m_finestLevel;
  observed.credited = view.m_credited;
  observed.request = requestOf(view.m_request, rests);
  if (view.m_units >= 0) observed.units = view.m_units;
  return observed;
}

}  // namespace scatter
