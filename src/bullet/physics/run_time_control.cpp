#include <BulletHybrid/btHybridDynamicsWorld.h>

#include "bullet/physics/bullet_physics.h"
#include "bullet/physics/observer.h"

namespace scatter {

bool BulletPhysics::switchesByPair() const {
  return engine_.switching() != nullptr && def_.switching.switching == Switching::kPair;
}

bool BulletPhysics::setBudget(const BudgetDef& budget) {
  if (!switchesByPair()) return false;
  if (!engine_.setBudget(budget)) return false;
  def_.switching.budget = budget;
  return true;
}

Result<void> BulletPhysics::setPolicies(Policy policy, const std::vector<std::string>& policies) {
  if (engine_.switching() == nullptr) return Physics::setPolicies(policy, policies);
  if (auto set = engine_.setPolicies(policy, policies); !set) return set;
  def_.switching.policy = policy;
  def_.switching.policies = policies;
  if (!switchesByPair()) askAllBodies();
  return {};
}

/// With body switching most policies are requests to all.
void BulletPhysics::askAllBodies() {
  if (def_.switching.policy == Policy::kProximity) return;
  for (const auto& body : bodies_) {
    if (!body || body->switching() == nullptr) continue;
    const int level = def_.switching.policy == Policy::kCoarsest && !body->isHeld() ? 1 : body->levelCount();
    engine_.switching()->requestLevel(body->switching(), level, BT_HYBRID_GLOBAL);
  }
}

Result<void> BulletPhysics::setSwitching(Switching switching) {
  if (engine_.switching() == nullptr) return Physics::setSwitching(switching);
  if (switching == def_.switching.switching) return {};
  SwitchingDef changed = def_.switching;
  changed.switching = switching;
  if (auto set = engine_.setSwitching(changed); !set) return set;
  def_.switching = std::move(changed);
  budgetUnits_ = 0.0;
  if (switchesByPair()) {
    applyFocus();
  } else {
    askAllBodies();
  }
  return {};
}

bool BulletPhysics::setFrozen(BodyId body, bool frozen) {
  BulletBody& target = at(body);
  if (!target.isDynamic()) return false;
  if (target.isFrozen() == frozen) return true;
  if (frozen) {
    target.freeze();
    engine_.forgetStillContacts(target.rigid());
  } else {
    engine_.wakeNeighbours(target.rigid());
    target.thaw();
    // While it was frozen it had no pairs with what it came to lie on.
    engine_.world().refreshBroadphaseProxy(&target.rigid());
  }
  return true;
}

bool BulletPhysics::setHeld(BodyId body, bool held) {
  BulletBody& target = at(body);
  if (engine_.switching() == nullptr) return false;
  if (target.isHeld() == held) return true;
  target.setHeld(held);
  engine_.switching()->setHeld(&target.rigid(), held);
  const bool goesBack = !held && !switchesByPair() && def_.switching.policy == Policy::kCoarsest;
  if (goesBack && target.switching() != nullptr) {
    engine_.switching()->requestLevel(target.switching(), 1, BT_HYBRID_GLOBAL);
  }
  return true;
}

void BulletPhysics::setFocus(const std::optional<ViewFocus>& focus) {
  focus_ = focus;
  applyFocus();
}

void BulletPhysics::applyFocus() {
  if (switchesByPair()) engine_.setFocus(focus_);
}

void BulletPhysics::observe(const ObservationParts& parts, Observation& out) const {
  out.clear();
  BulletObserver(engine_.world(), engine_.switching(), bodies_).observe(parts, out);
}

}  // namespace scatter
