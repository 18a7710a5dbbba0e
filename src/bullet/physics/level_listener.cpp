#include "bullet/physics/level_listener.h"

#include <BulletHybrid/btHybridRigidBody.h>

#include "bullet/physics/body.h"

namespace scatter {

void LevelListener::add(LevelEventKind kind, const btHybridRigidBody& body, const btHybridRequest& request) {
  LevelEvent event{kind, request.m_scope, BulletBody::of(body).id(), body.getLevel(), request.m_targetLevel};
  event.policy = request.m_byProximity ? "proximity" : "program";
  open_.push_back(event);
}

void LevelListener::requested(btHybridRigidBody* body, const btHybridRequest& request) {
  add(LevelEventKind::kRequested, *body, request);
}

void LevelListener::acknowledged(btHybridRigidBody* body, const btHybridRequest& request) {
  add(LevelEventKind::kAcknowledged, *body, request);
}

void LevelListener::blocked(btHybridRigidBody* body, const btHybridRequest& request) {
  add(LevelEventKind::kBlocked, *body, request);
}

void LevelListener::switched(btHybridRigidBody* body, int from, int to, const btHybridRequest& request) {
  add(LevelEventKind::kSwitched, *body, request);
  open_.back().from = from;
  open_.back().to = to;
}

void LevelListener::retracted(btHybridRigidBody* body, const btHybridRequest& request, btHybridRetraction) {
  add(LevelEventKind::kRetracted, *body, request);
}

void LevelListener::pairEvent(const btHybridPairEvent& event) {
  open_.push_back({.kind = event.m_kind,
                   .scope = event.m_scope,
                   .body = BulletBody::of(*event.m_objectA).id(),
                   .from = event.m_fromLevel,
                   .to = event.m_toLevel,
                   .other = BulletBody::of(*event.m_objectB).id(),
                   .onCredit = event.m_onCredit,
                   .policy = event.m_policy});
}

void LevelListener::endSpan() {
  std::swap(ended_, open_);
  open_.clear();
}

}  // namespace scatter
