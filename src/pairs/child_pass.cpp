#include "pairs/child_pass.h"

namespace scatter::pairs {

void ChildPass::run(std::vector<int>& awake) {
  PartPair::Children& children = parts_.children();
  findAwake(awake);
  for (const int i : awake) {
    const ChildPair& child = children[static_cast<std::size_t>(i)];
    if (child.touching) engine_.prefetch(child.contact);
  }
  for (std::size_t i = 0; i < awake.size(); ++i)
    collide(children[static_cast<std::size_t>(awake[i])],
            foresight_ != nullptr ? &foresight_->looks[i] : nullptr);
}

void ChildPass::findAwake(std::vector<int>& awake) {
  if (foresight_ != nullptr) {
    awake.assign(foresight_->awake.begin(), foresight_->awake.end());
    return;
  }
  awake.clear();
  parts_.forEachAwake(work_, [&awake](int index) { awake.push_back(index); });
}

bool ChildPass::overlap(const ChildPair& child, const ChildLook* seen) {
  return seen != nullptr ? seen->state != ChildLook::State::kBoundsApart : bounds_.overlap(child.a, child.b);
}

void ChildPass::collide(ChildPair& child, const ChildLook* seen) {
  if (recycles_ && child.touching && !child.stale) {
    ++work_.recycled;
    return;
  }
  if (isExcused(child)) {
    drop(child);
    return;
  }
  // Before the bounds, as it tells for how long they stay apart.
  const bool isToldApart = seen != nullptr ? seen->state == ChildLook::State::kToldApart
                                           : parts_.isToldApart(child, *bodies_.a, *bodies_.b, steps_, work_);
  if (isToldApart) return;
  if (!overlap(child, seen) || !engine_.letsThrough(child)) {
    ++work_.boundsRejected;
    keepOrDrop(child);
    return;
  }
  if (child.touching) child.touching = stillTouches(child);
  const int before = child.contact != nullptr ? engine_.countPoints(child.contact) : 0;
  if (!steps_.lazyManifolds && child.contact == nullptr) child.contact = engine_.newManifold();
  find(child, seen);
  if (child.contact == nullptr) return;
  engine_.looked(child);
  const int points = engine_.countPoints(child.contact);
  child.touching = points > 0;
  child.settled = points <= before;
  child.turnAt = parts_.turn();
  if (!child.touching && steps_.lazyManifolds) drop(child);
}

void ChildPass::keepOrDrop(ChildPair& child) {
  if (child.touching && engine_.overlooks(child)) {
    child.touching = stillTouches(child);
  } else {
    drop(child);
  }
}

bool ChildPass::stillTouches(const ChildPair& child) const {
  return recycles_ ? engine_.countPoints(child.contact) > 0 : engine_.outlasts(child.contact);
}

void ChildPass::find(ChildPair& child, const ChildLook* seen) {
  PartContact contact;
  ChildVerdict verdict = ChildVerdict::kApart;
  if (seen != nullptr && seen->state == ChildLook::State::kMeasured) {
    verdict = seen->verdict;
    contact = seen->contact;
  } else {
    verdict = parts_.measure(child, *bodies_.a, *bodies_.b, steps_, contact, work_);
  }
  if (verdict == ChildVerdict::kApart) return;
  if ((!child.touching || areSpheres(child)) && !engine_.mayBegin(child)) return;
  if (verdict == ChildVerdict::kContact) {
    engine_.add(child, contact);
  } else {
    ++work_.detectorRuns;
    engine_.detect(parts_, child);
  }
}

void ChildPass::drop(ChildPair& child) {
  if (child.contact != nullptr) engine_.release(child.contact);
  child.contact = nullptr;
  child.touching = false;
}

bool ChildPass::isExcused(ChildPair& child) const {
  if (credit_ == nullptr || credit_->account.of(child.a, child.b) <= 0.0F) return false;
  const double late = parts_.motion() - credit_->freshUntil;
  const double latest = credit_->latest;
  if (late >= latest && late < static_cast<double>(auditsFrom_) * latest) return false;
  child.wake = parts_.wakeAt(credit_->freshUntil);
  return true;
}

// Engines keep no contact of two spheres from step to step: what is handed to their detector is found anew.
bool ChildPass::areSpheres(const ChildPair& child) const {
  return bodies_.a->parts().part(child.a).kind == PartKind::kSphere &&
         bodies_.b->parts().part(child.b).kind == PartKind::kSphere;
}

}  // namespace scatter::pairs
