#include "bullet/physics/bullet_switching.h"

#include <BulletHybrid/btHybridDynamicsWorld.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "bullet/physics/switching_report.h"

namespace scatter {

BulletSwitching::BulletSwitching(SwitchingDef def, BulletEngine& engine, BulletBodies& bodies)
    : def_(std::move(def)), engine_(engine), bodies_(bodies) {
  if (engine_.switching() != nullptr) engine_.switching()->setListener(&listener_);
}

BulletSwitching::~BulletSwitching() {
  if (engine_.switching() != nullptr) engine_.switching()->setListener(nullptr);
}

bool BulletSwitching::switchesByPair() const {
  return engine_.switching() != nullptr && def_.switching == Switching::kPair;
}

LevelStart BulletSwitching::levelStart() const {
  LevelStart start;
  start.switches = engine_.switching() != nullptr;
  if (def_.switching == Switching::kBody && def_.policy == Policy::kCoarsest) start.level = 1;
  return start;
}

void BulletSwitching::beginStep(const StepCounters& before) {
  if (auto* hybrid = engine_.switching()) {
    hybrid->setLoadIsFine(before.narrowphasePairs < def_.loadFinePairs);
  }
}

void BulletSwitching::endStep(StepCounters& counters) {
  listener_.endSpan();
  const btHybridDynamicsWorld* hybrid = engine_.switching();
  if (hybrid == nullptr) return;
  addBodyCounts(hybrid->getStepInfo(), counters);
  if (switchesByPair()) {
    const btHybridPairStepInfo info = hybrid->getPairStepInfo();
    addPairCounts(info, counters);
    budgetUnits_ = info.budgetUnits;
    const BudgetState state = hybrid->getBudgetState();
    counters.budgetVerdict = static_cast<std::uint32_t>(state.verdict);
    counters.reachableUnits = static_cast<std::uint32_t>(std::lround(state.reachable));
    counters.withheldPairs = static_cast<std::uint32_t>(state.withheldPairs);
    counters.overduePairs = static_cast<std::uint32_t>(state.overduePairs);
  }
}

BudgetState BulletSwitching::budgetState() const {
  const btHybridDynamicsWorld* hybrid = engine_.switching();
  return hybrid != nullptr ? hybrid->getBudgetState() : BudgetState();
}

int BulletSwitching::level(BodyId body) const {
  return bodies_.at(body).level();
}

int BulletSwitching::levelCount(BodyId body) const {
  return bodies_.at(body).levelCount();
}

void BulletSwitching::coarsestLevels(std::vector<std::uint8_t>& levels) const {
  levels.clear();
  if (!switchesByPair()) return;
  levels.push_back(0);
  for (const auto& body : bodies_.all()) {
    levels.push_back(static_cast<std::uint8_t>(body ? body->levelCount() : 0));
  }
  btAlignedObjectArray<btHybridCoarserObject> coarser;
  engine_.switching()->viewCoarserObjects(coarser);
  for (int i = 0; i < coarser.size(); ++i) {
    const BulletBody& body = BulletBody::of(*coarser[i].m_object);
    // Bodies without levels that switch take part with their finest.
    if (body.switching() == nullptr) continue;
    std::uint8_t& coarsest = levels[static_cast<std::size_t>(body.id())];
    coarsest = std::min(coarsest, static_cast<std::uint8_t>(coarser[i].m_level));
  }
}

bool BulletSwitching::requestLevel(BodyId body, int level, Scope scope) {
  const BulletBody& asked = bodies_.at(body);
  if (asked.switching() == nullptr) return false;
  return engine_.switching()->requestLevel(asked.switching(), level, scope);
}

void BulletSwitching::retractRequest(BodyId body) {
  const BulletBody& asked = bodies_.at(body);
  if (asked.switching() != nullptr) engine_.switching()->retractRequest(asked.switching());
}

void BulletSwitching::retractAllRequests() {
  if (engine_.switching() != nullptr) engine_.switching()->retractAllRequests();
}

int BulletSwitching::pairLevel(BodyId a, BodyId b) const {
  const btHybridDynamicsWorld* hybrid = engine_.switching();
  return hybrid != nullptr ? hybrid->getPairLevel(&bodies_.at(a).rigid(), &bodies_.at(b).rigid()) : 0;
}

bool BulletSwitching::setBudget(const BudgetDef& budget) {
  if (!switchesByPair()) return false;
  if (!engine_.setBudget(budget)) return false;
  def_.budget = budget;
  return true;
}

Result<void> BulletSwitching::setPolicies(Policy policy, const std::vector<std::string>& policies) {
  if (engine_.switching() == nullptr) return LevelSwitching::setPolicies(policy, policies);
  if (auto set = engine_.setPolicies(policy, policies); !set) return set;
  def_.policy = policy;
  def_.policies = policies;
  if (!switchesByPair()) askAllBodies();
  return {};
}

/// With body switching most policies are requests to all.
void BulletSwitching::askAllBodies() {
  if (def_.policy == Policy::kProximity) return;
  for (const auto& body : bodies_.all()) {
    if (!body || body->switching() == nullptr) continue;
    const int level = def_.policy == Policy::kCoarsest && !body->isHeld() ? 1 : body->levelCount();
    engine_.switching()->requestLevel(body->switching(), level, BT_HYBRID_GLOBAL);
  }
}

Result<void> BulletSwitching::setSwitching(Switching switching) {
  if (engine_.switching() == nullptr) return LevelSwitching::setSwitching(switching);
  if (switching == def_.switching) return {};
  SwitchingDef changed = def_;
  changed.switching = switching;
  if (auto set = engine_.setSwitching(changed); !set) return set;
  def_ = std::move(changed);
  budgetUnits_ = {};
  if (switchesByPair()) {
    applyFocus();
  } else {
    askAllBodies();
  }
  return {};
}

bool BulletSwitching::setHeld(BodyId body, bool held) {
  BulletBody& target = bodies_.at(body);
  if (engine_.switching() == nullptr) return false;
  if (target.isHeld() == held) return true;
  target.setHeld(held);
  engine_.switching()->setHeld(&target.rigid(), held);
  const bool goesBack = !held && !switchesByPair() && def_.policy == Policy::kCoarsest;
  if (goesBack && target.switching() != nullptr) {
    engine_.switching()->requestLevel(target.switching(), 1, BT_HYBRID_GLOBAL);
  }
  return true;
}

void BulletSwitching::setFocus(const std::optional<ViewFocus>& focus) {
  focus_ = focus;
  applyFocus();
}

void BulletSwitching::applyFocus() {
  if (switchesByPair()) engine_.setFocus(focus_);
}

}  // namespace scatter
