#include "pairs/level_look.h"

#include "pairs/child_pass.h"

namespace scatter::pairs {

void LevelLook::restart(PartPair& parts) const {
  parts.reset(engine_.threshold());
  pair_.restarted = true;
}

bool LevelLook::place(int level, PlacedBodies& bodies) {
  if (engine_.place(level, bodies)) {
    pair_.hasFallenBack = false;
    pair_.restarted = false;
    return true;
  }
  pair_.dropAll(engine_);
  pair_.versions[0] = Pair::kNoParts;
  pair_.hasFallenBack = true;
  engine_.fallBack();
  return false;
}

bool LevelLook::advance(PartPair& parts, const PlacedBodies& bodies) {
  scratch_.parts.keeper = &engine_;
  const bool isAwake = parts.advance(*bodies.a, *bodies.b, steps_, scratch_.parts, work_);
  scratch_.parts.keeper = nullptr;
  for (void* manifold : scratch_.parts.dropped) engine_.release(manifold);
  return isAwake;
}

void LevelLook::atLevel(int level, bool returns, bool mayAudit) {
  scratch_.looked.clear();
  PlacedBodies bodies;
  if (!place(level, bodies)) return;
  if (pair_.versions[0] != bodies.versions[0] || pair_.versions[1] != bodies.versions[1]) {
    pair_.dropContacts(engine_);
    restart(pair_.parts);
    for (int i = 0; i < 2; ++i) pair_.versions[i] = bodies.versions[i];
  }
  const bool isAwake = advance(pair_.parts, bodies);
  if (returns) pair_.held.giveBack(pair_.parts.children(), engine_);
  if (!isAwake) return;
  const CreditState* const credit = pair_.credit.kind == CreditKind::kCoarser ? &pair_.credit : nullptr;
  ChildPass(pair_.parts, bodies, steps_, engine_, work_, credit, mayAudit).run(scratch_.looked);
  pair_.parts.settle(*bodies.a, *bodies.b, steps_);
}

void LevelLook::atFinest(int level) {
  PlacedBodies bodies;
  if (!place(level, bodies)) return;
  PartPair& parts = scratch_.audit;
  restart(parts);
  if (advance(parts, bodies)) {
    ChildPass(parts, bodies, steps_, engine_, work_, nullptr, false).run(scratch_.looked);
    parts.settle(*bodies.a, *bodies.b, steps_);
  }
  pair_.held.gather(parts.children(), engine_.pointDistance(), engine_, scratch_.held);
  for (const ChildPair& child : parts.children()) {
    if (child.contact != nullptr) engine_.release(child.contact);
  }
}

}  // namespace scatter::pairs
