#include "pairs/level_look.h"

#include "pairs/child_pass.h"
#include "pairs/contact_recycling.h"

namespace scatter::pairs {

bool mayRecycle(const Pair& pair, const PairSteps& steps) {
  return steps.recycling > 0.0F && pair.parts.touches() && pair.credit.kind == CreditKind::kNone &&
         pair.held.empty();
}

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

// Whether the pair is done.
bool LevelLook::recycle(const PlacedBodies& bodies) {
  pair_.origin = ContactOrigin::kRecycled;
  ContactRecycling recycling(pair_.parts, bodies, steps_.recycling, scratch_.recycling);
  const bool isDone = recycling.look([this](void* contact) { return engine_.carry(contact); },
                                     [this](const void* contact) { engine_.prefetch(contact); });
  recycling.settle([this](void* contact) { engine_.release(contact); });
  if (isDone) endRecycled(scratch_.recycling.touching);
  return isDone;
}

void LevelLook::endRecycled(const std::vector<int>& touching) {
  scratch_.looked = touching;
  ++work_.pairs;
  work_.recycled += static_cast<int>(touching.size());
}

bool LevelLook::advance(PartPair& parts, const PlacedBodies& bodies) {
  scratch_.parts.keeper = &engine_;
  const bool isAwake = parts.advance(*bodies.a, *bodies.b, steps_, scratch_.parts, work_);
  scratch_.parts.keeper = nullptr;
  for (void* manifold : scratch_.parts.dropped) engine_.release(manifold);
  return isAwake;
}

void LevelLook::atLevel(int level, bool returns, float auditsFrom) {
  scratch_.looked.clear();
  PlacedBodies bodies;
  if (!place(level, bodies)) return;
  if (!pair_.isOf(bodies)) {
    pair_.dropContacts(engine_);
    restart(pair_.parts);
    for (int i = 0; i < 2; ++i) pair_.versions[i] = bodies.versions[i];
  }
  if (pair_.foresight != nullptr) {
    useForesight(bodies, auditsFrom);
    return;
  }
  pair_.parts.followWholeBodies(pair_.credit.isCoarser());
  const bool recycles = !returns && mayRecycle(pair_, steps_);
  if (recycles && recycle(bodies)) return;
  const bool isAwake = advance(pair_.parts, bodies);
  if (returns) {
    pair_.held.giveBack(pair_.parts.children(), engine_);
    pair_.parts.forgetWakeful();
  }
  if (!isAwake) return;
  ChildPass(pair_.parts, bodies, steps_, engine_, work_, coarserCredit(), auditsFrom, recycles)
      .run(scratch_.looked);
  pair_.parts.settle(*bodies.a, *bodies.b, steps_);
}

const CreditState* LevelLook::coarserCredit() const {
  return pair_.credit.isCoarser() ? &pair_.credit : nullptr;
}

// The step of a pair of which advance() has been done already.
void LevelLook::useForesight(const PlacedBodies& bodies, float auditsFrom) {
  const Foresight& foresight = *pair_.foresight;
  if (foresight.recycles) pair_.origin = ContactOrigin::kRecycled;
  pair_.closeForesight(engine_);
  work_ += foresight.work;
  if (foresight.isDone) {
    endRecycled(foresight.awake);
    return;
  }
  if (!foresight.isAwake || foresight.isSettled) return;
  ChildPass(pair_.parts, bodies, steps_, engine_, work_, coarserCredit(), auditsFrom, foresight.recycles,
            &foresight)
      .run(scratch_.looked);
  pair_.parts.settle(*bodies.a, *bodies.b, steps_);
}

void LevelLook::atFinest(int level) {
  PlacedBodies bodies;
  if (!place(level, bodies)) return;
  PartPair& parts = scratch_.audit;
  restart(parts);
  if (advance(parts, bodies)) {
    ChildPass(parts, bodies, steps_, engine_, work_, nullptr, lod::lateness::kNever, false)
        .run(scratch_.looked);
    parts.settle(*bodies.a, *bodies.b, steps_);
  }
  pair_.held.gather(parts.children(), engine_.pointDistance(), engine_, scratch_.held);
  for (const ChildPair& child : parts.children()) {
    if (child.contact != nullptr) engine_.release(child.contact);
  }
}

}  // namespace scatter::pairs
