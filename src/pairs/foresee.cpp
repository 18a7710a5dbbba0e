#include "pairs/foresee.h"

#include <algorithm>

#include "pairs/ground_look.h"
#include "pairs/level_look.h"

namespace scatter::pairs {

namespace {

/// Answers for the engine, and writes down what was asked.
class PeekingKeeper final : public ContactKeeper {
 public:
  PeekingKeeper(const ContactPeek& peek, const PlacedBodies& bodies, BoundsLocks& locks, Foresight& foresight)
      : peek_(peek), bodies_(bodies), locks_(locks), foresight_(foresight) {}

  // Whoever is told that a contact lasts compares bounds next.
  bool outlasts(void* contact) const override {
    if (!peek_.carries()) foresight_.asked.push_back(contact);
    if (!peek_.wouldOutlast(contact)) return false;
    locks_.compute(bodies_);
    return true;
  }

 private:
  const ContactPeek& peek_;
  const PlacedBodies& bodies_;
  BoundsLocks& locks_;
  Foresight& foresight_;
};

/// The child pairs of one pair, as ChildPass looks at them, as far as it needs no engine.
class ChildForesight {
 public:
  ChildForesight(Pair& pair, const PlacedBodies& bodies, const PairSteps& steps, const ContactPeek& peek,
                 BoundsLocks& locks, Foresight& foresight)
      : parts_(pair.parts),
        credit_(pair.credit),
        bodies_(bodies),
        steps_(steps),
        peek_(peek),
        locks_(locks),
        foresight_(foresight) {}

  /// Whether no child pair needs a detector that works on one thread alone.
  bool run() {
    parts_.forEachAwake(foresight_.work, [this](int index) { foresight_.awake.push_back(index); });
    bool isApart = steps_.lazyManifolds && !isOnCredit_;
    bool isDecided = true;
    for (const int i : foresight_.awake) {
      ChildPair& child = parts_.children()[static_cast<std::size_t>(i)];
      foresight_.looks.push_back(look(child));
      isApart = isApart && child.contact == nullptr && isFree(foresight_.looks.back());
      isDecided = isDecided && (!mayDetect(child, foresight_.looks.back()) || peek_.detectsAnywhere(child));
    }
    if (isApart) settle();
    return isDecided;
  }

 private:
  static bool isFree(const ChildLook& look) {
    return look.state != ChildLook::State::kMeasured || look.verdict == ChildVerdict::kApart;
  }

  // Its contacts move along, and are not found anew.
  [[nodiscard]] bool isCarried(const ChildPair& child) const {
    return foresight_.recycles && child.touching && !child.stale;
  }

  [[nodiscard]] bool mayDetect(const ChildPair& child, const ChildLook& look) const {
    if (look.state == ChildLook::State::kMeasured) return look.verdict == ChildVerdict::kAskEngine;
    return look.state == ChildLook::State::kOpen && !isCarried(child);
  }

  // Without contacts, not even empty ones, a look at child pairs changes nothing but the counts.
  void settle() {
    for (const ChildLook& look : foresight_.looks)
      foresight_.work.boundsRejected += look.state == ChildLook::State::kBoundsApart ? 1 : 0;
    parts_.settle(*bodies_.a, *bodies_.b, steps_);
    foresight_.isSettled = true;
  }

  [[nodiscard]] bool isExcused(const ChildPair& child) const {
    return isOnCredit_ && credit_.account.of(child.a, child.b) > 0.0F;
  }

  ChildLook look(ChildPair& child) {
    ChildLook look;
    PartBody& a = *bodies_.a;
    PartBody& b = *bodies_.b;
    if (isExcused(child)) {
      look.state = ChildLook::State::kExcused;
    } else if (parts_.isToldApart(child, a, b, steps_, foresight_.work)) {
      look.state = ChildLook::State::kToldApart;
    } else if (isCarried(child)) {
      return look;
    } else if (!overlap(child)) {
      look.state = ChildLook::State::kBoundsApart;
    } else if (!child.touching || parts_.isExact(child, a, b)) {
      look.state = ChildLook::State::kMeasured;
      look.verdict = parts_.measure(child, a, b, steps_, look.contact, foresight_.work);
    }
    return look;
  }

  bool overlap(const ChildPair& child) {
    if (!hasBounds_) locks_.compute(bodies_);
    hasBounds_ = true;
    return bounds_.overlap(child.a, child.b);
  }

  PartPair& parts_;
  const CreditState& credit_;
  const bool isOnCredit_ = credit_.isCoarser();
  const PlacedBodies& bodies_;
  const PairSteps& steps_;
  const ContactPeek& peek_;
  BoundsLocks& locks_;
  Foresight& foresight_;
  BoundsTest bounds_{*bodies_.a, *bodies_.b};
  bool hasBounds_ = false;
};

}  // namespace

namespace {

// Whether two parts touch depends on no engine, but for what the engine's own detector has to say.
void judgeAll(PartPair& parts, const PartBody& region, const PartBody& body, const PairSteps& steps,
              Foresight& foresight) {
  parts.forEachAwake(foresight.work, [&](int index) {
    ChildPair& child = parts.children()[static_cast<std::size_t>(index)];
    ChildLook look;
    look.state = ChildLook::State::kMeasured;
    look.verdict = parts.judge(child, region, body, steps, look.contact, foresight.work);
    if (look.verdict == ChildVerdict::kApart) return;
    foresight.awake.push_back(index);
    foresight.looks.push_back(look);
  });
}

}  // namespace

Foresight& ForesightScratch::take() {
  if (used == pool.size()) pool.push_back(std::make_unique<Foresight>());
  Foresight& next = *pool[used++];
  next.isAwake = next.isSettled = next.isDone = next.recycles = false;
  next.carried.clear();
  next.work = {};
  next.dropped.clear();
  next.asked.clear();
  next.awake.clear();
  next.looks.clear();
  return next;
}

// Side by side, as they are read in nearly the order in which they were made.
StepAhead& ForesightScratch::takeStep() {
  constexpr std::size_t kBlock = 64;
  if (stepsUsed == stepPool.size() * kBlock) stepPool.push_back(std::make_unique<StepAhead[]>(kBlock));
  StepAhead& next = stepPool[stepsUsed / kBlock][stepsUsed % kBlock];
  ++stepsUsed;
  next.outcome = {};
  next.work = {};
  next.notes.clear();
  return next;
}

namespace {

// Where contacts that are held all end, the pair's motion before the step decides when it is audited.
bool willHold(const Pair& pair, const ContactPeek& peek) {
  const auto keepsPoints = [&peek](const void* manifold) { return peek.keepsPoints(manifold); };
  return pair.held.empty() || std::ranges::any_of(pair.held.manifolds(), keepsPoints);
}

// Audits take room that others may have taken, and are of the finest shapes.
bool mayBeAudited(const Pair& pair, const PlacedBodies& bodies) {
  if (!pair.credit.isOpen()) return false;
  const bool hasJumped = pair.parts.jumps() != bodies.a->jumps() + bodies.b->jumps();
  return hasJumped || !(pair.parts.mostMotion(*bodies.a, *bodies.b) < pair.credit.freshUntil);
}

}  // namespace

bool isForeseeable(const Pair& pair, const PlacedBodies& bodies, const ContactPeek& peek) {
  return pair.isOf(bodies) && !pair.hasFallenBack && !bodies.a->parts().hasOpaque() &&
         !bodies.b->parts().hasOpaque() && !mayBeAudited(pair, bodies) && willHold(pair, peek);
}

namespace {

// What the engine has to do with contacts before anything else.
void carry(Pair& pair, ContactRecycling& recycling, const RecyclingScratch& scratch, bool carries,
           Foresight& foresight) {
  for (const int i : scratch.touching) {
    if (!carries) foresight.carried.push_back(pair.parts.children()[static_cast<std::size_t>(i)].contact);
  }
  recycling.settle([&foresight](void* contact) { foresight.dropped.push_back(contact); });
}

}  // namespace

bool foresee(Pair& pair, const PlacedBodies& bodies, const PairSteps& steps, const ContactPeek& peek,
             BoundsLocks& locks, ForesightScratch& scratch) {
  pair.parts.followWholeBodies(pair.credit.isCoarser());
  const bool recycles = mayRecycle(pair, steps);
  ContactRecycling recycling(pair.parts, bodies, steps.recycling, scratch.recycling);
  const auto slideOf = [&peek](void* contact) { return peek.wouldSlide(contact); };
  const bool isDone = recycles && recycling.look(slideOf, [](const void*) {});
  if (isDone && !peek.carries()) return true;
  Foresight& foresight = scratch.take();
  pair.foresight = &foresight;
  foresight.recycles = recycles;
  foresight.isDone = isDone;
  if (recycles) carry(pair, recycling, scratch.recycling, peek.carries(), foresight);
  if (isDone) {
    foresight.awake = scratch.recycling.touching;
    return true;
  }
  const PeekingKeeper keeper(peek, bodies, locks, foresight);
  scratch.parts.keeper = &keeper;
  if (steps.midphase == PairMidphase::kWorldBoxes) locks.compute(bodies);
  foresight.isAwake = pair.parts.advance(*bodies.a, *bodies.b, steps, scratch.parts, foresight.work);
  scratch.parts.keeper = nullptr;
  foresight.dropped.insert(foresight.dropped.end(), scratch.parts.dropped.begin(),
                           scratch.parts.dropped.end());
  const bool hasRestarted = pair.credit.isOpen() && pair.parts.motion() < pair.credit.seenMotion;
  if (!foresight.isAwake) return !hasRestarted;
  return ChildForesight(pair, bodies, steps, peek, locks, foresight).run() && !hasRestarted;
}

namespace {

bool isAsItWas(const GroundPair& pair, const PlacedBody& placed, int level, int groundVersion) {
  const bool isSame =
      pair.level == level && pair.versions[0] == placed.version && pair.versions[1] == groundVersion;
  return isSame && !pair.hasFallenBack && !pair.isTooFine;
}

}  // namespace

bool onlyCarries(const GroundPair& pair, const PlacedBody& placed, int level, const Frame& ground,
                 int groundVersion, const PairSteps& steps) {
  return isAsItWas(pair, placed, level, groundVersion) && mayRecycle(pair, *placed.body, ground, steps);
}

bool onlyKeeps(const GroundPair& pair, const PairPlan& plan, const PlacedBody& placed, const Frame& ground,
               int groundVersion) {
  const bool canKeep = !plan.tries && plan.keepsFrom == 0 && pair.landing == 0 &&
                       isAsItWas(pair, placed, plan.view.level, groundVersion);
  return canKeep && mayKeep(pair, *placed.body, ground, furthestUnseen(plan, pair.parts.threshold()));
}

bool isForeseeable(const GroundPair& pair, const PlacedBody& placed, int level, const Frame& ground,
                   int groundVersion, const PairSteps& steps) {
  if (!isAsItWas(pair, placed, level, groundVersion) || placed.body->parts().hasOpaque()) return false;
  return !mayRecycle(pair, *placed.body, ground, steps);
}

// What there is too much of, and what has become of a body that has jumped, is found out in the step itself.
bool foresee(GroundPair& pair, const PlacedBody& placed, const Frame& ground, const PairSteps& steps,
             GroundEngine& engine, RegionScratch& region, BoundsLocks& locks, ForesightScratch& scratch) {
  if (engine.halfSpace()) return true;
  const Frame bodyInGround = relativeFrame(ground, placed.body->frame());
  const Vec3 ahead = steps.passages ? engine.wayAhead() : Vec3(0.0F);
  PairWork work;
  if (pair.jumps != placed.body->jumps()) return false;
  if (!findRegion(pair, *placed.body, bodyInGround, ahead, steps, engine, region, work)) return false;
  if (pair.region.empty()) return true;
  Foresight& foresight = scratch.take();
  foresight.work = work;
  pair.foresight = &foresight;
  PartBody& pieces = pair.region.moveTo(ground);
  if (steps.midphase == PairMidphase::kWorldBoxes) locks.compute(*placed.body);
  foresight.isAwake = pair.parts.advance(pieces, *placed.body, steps, scratch.parts, foresight.work);
  if (!foresight.isAwake) return true;
  judgeAll(pair.parts, pieces, *placed.body, steps, foresight);
  pair.parts.settle(pieces, *placed.body, steps);
  foresight.isSettled = true;
  return std::ranges::none_of(foresight.looks,
                              [](const ChildLook& look) { return look.verdict == ChildVerdict::kAskEngine; });
}

}  // namespace scatter::pairs
