#include "bullet/physics/level_listener.h"

#include <BulletHybrid/btHybridRigidBody.h>

#include "bullet/physics/body.h"

namespace scatter {

namespace {

Scope scopeOf(const btHybridRequest& request) {
  switch (request.m_scope) {
    case BT_HYBRID_GROUP:
      return Scope::kGroup;
    case BT_HYBRID_GLOBAL:
      return Scope::kGlobal;
    case BT_HYBRID_LOCAL:
      break;
  }
  return Scope::kLocal;
}

}  // namespace

void LevelListener::add(LevelEventKind kind, const btHybridRigidBody& body, const btHybridRequest& request) {
  open_.push_back(
      {kind, scopeOf(request), BulletBody::of(body).id(), body.getLevel(), request.m_targetLevel});
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
  open_.push_back({LevelEventKind::kSwitched, scopeOf(request), BulletBody::of(*body).id(), from, to});
}

void LevelListener::retracted(btHybridRigidBody* body, const btHybridRequest& request, btHybridRetraction) {
  add(LevelEventKind::kRetracted, *body, request);
}

void LevelListener::endSpan() {
  std::swap(ended_, open_);
  open_.clear();
}

}  // namespace scatter
