#include "pairs/pair_step.h"

#include <algorithm>

#include "pairs/contact_credit.h"
#include "pairs/level_look.h"

namespace scatter::pairs {

namespace {

/// Further away it does not matter how wide a gap is.
constexpr float kWidestGap = 0.25F;

/// Audit distances by which an audit may be late before the coarse shapes collide in the place of the finest
/// ones.
constexpr float kLateness = 2.0F;

/// Bodies that came back to their finest shapes settle on them: in so many steps they have come to rest.
constexpr int kSettlingSteps = 10;

/// So little overlap is pressed as well as given credit for, metres.
constexpr float kLeastCredit = 1e-4F;

/// How far a pair may move before the first audit, metres; from then on as far again as it has moved.
constexpr double kFirstAudit = 0.002;

/// How late an audit is that is not due, and at most, as that of a pair whose bodies were put elsewhere.
constexpr float kNotDue = -1.0F;
constexpr float kLatest = 1e6F;

class PairStep {
 public:
  PairStep(Pair& pair, const PairPlan& plan, const PairSteps& steps, PairEngine& engine, StepScratch& scratch,
           PairWork& work)
      : pair_(pair),
        credit_(pair.credit),
        plan_(plan),
        engine_(engine),
        scratch_(scratch),
        work_(work),
        look_(pair, steps, engine, scratch, work),
        level_(plan.view.level) {}

  PairOutcome run() {
    if (hasOtherParts()) renewCredit();
    choose();
    if (changesLevel_) {
      changeLevel();
    } else if (keepsContacts(pair_, plan_, outcome_.choiceQueries, frameB()) && isAsItWas()) {
      keepContacts();
      return outcome_;
    }
    findContacts();
    settleCredit();
    if (lateness() >= plan_.auditsFrom) audit();
    seeMotion();
    if (!credit_.keepsHeld(pair_.parts.motion())) pair_.held.release(engine_);
    outcome_.work.counts = work_;
    report();
    const bool canBeQuiet = pair_.held.empty() && !pair_.hasFallenBack;
    pair_.quietUntil = canBeQuiet ? pair_.parts.quietUntil() : Pair::kAwake;
    pair_.jumps = pair_.parts.jumps();
    return outcome_;
  }

 private:
  [[nodiscard]] int finest() const { return plan_.view.finest; }

  const Frame& frameB() {
    if (!hasFrame_) frameB_ = relativeFrame(engine_.frameOf(0), engine_.frameOf(1));
    hasFrame_ = true;
    return frameB_;
  }

  bool isSeparated(int level, float gap) {
    ++outcome_.choiceQueries;
    return scratch_.query.isSeparated(engine_.partsOf(0, level), engine_.partsOf(1, level), frameB(), gap);
  }

  float findGap() {
    ++outcome_.gapQueries;
    return scratch_.query.distance(engine_.partsOf(0, finest()), engine_.partsOf(1, finest()), frameB(),
                                   kWidestGap);
  }

  float depthOf(int a, int b) {
    return partDepth(engine_.partsOf(0, level_).part(a), engine_.partsOf(1, level_).part(b), frameB());
  }

  void choose() {
    if (!plan_.tries) return;
    outcome_.tried = true;
    // Coarser shapes that all but touch where finer ones do: the contacts are better held than dropped.
    const float nearby = plan_.view.touching ? kTouching : 0.0F;
    heldPress_ = pressHeld();
    // Overlap that the contacts that are held press apart already is no reason to wait for it.
    lod::SwitchRules rules = plan_.rules;
    rules.finerOverlap += heldPress_;
    outcome_.choice = lod::chooseLevel(plan_.view, plan_.target, rules, [&](int level, float gap) {
      return isSeparated(level, level < plan_.view.level ? gap + nearby : gap);
    });
    const lod::SwitchKind kind = outcome_.choice.kind;
    changesLevel_ = kind == lod::SwitchKind::kFree || kind == lod::SwitchKind::kOnCredit;
    if (!changesLevel_) return;
    hasSwitched_ = plan_.view.level > 0;
    isOnCredit_ = kind == lod::SwitchKind::kOnCredit;
    for (const ChildPair& child : pair_.parts.children()) {
      if (child.touching) mostPress_ = std::max(mostPress_, pressNow(child.contact, engine_));
    }
    mostPress_ = std::max(mostPress_, heldPress_);
  }

  [[nodiscard]] float pressHeld() const {
    float most = 0.0F;
    for (const void* manifold : pair_.held.manifolds()) most = std::max(most, pressNow(manifold, engine_));
    return most;
  }

  // What is held is what the finest shapes have where the bodies are now: contacts of the step before may be
  // gone by now.
  void changeLevel() {
    const int next = outcome_.choice.level;
    const bool wasFinest = level_ == finest();
    returns_ = next == finest() && !pair_.held.empty();
    rememberPresses();
    if (next < finest() && !isOnCredit_) {
      pair_.held.release(engine_);
    } else if (wasFinest) {
      look_.atLevel(level_, false, plan_.auditsFrom);
      settleFinest();
      pair_.held.gather(pair_.parts.children(), engine_.pointDistance(), engine_, scratch_.held);
    }
    level_ = next;
    openCredit(wasFinest);
    pair_.dropContacts(engine_);
    pair_.versions[0] = pair_.versions[1] = Pair::kNoParts;
  }

  // Of those contacts that go back to the finest level.
  void rememberPresses() {
    scratch_.presses.clear();
    if (!returns_) return;
    for (const void* manifold : pair_.held.manifolds()) {
      for (int i = 0; i < engine_.countPoints(manifold); ++i) {
        const ContactPoint point = engine_.point(manifold, i);
        const float depth = -engine_.distanceNow(manifold, i);
        if (point.presses && depth > 0.0F) scratch_.presses.push_back({point.partA, point.partB, depth});
      }
    }
  }

  // How deep a child pair did press before the pair came back to its finest level.
  [[nodiscard]] float pressOf(const ChildPair& child) const {
    float most = 0.0F;
    for (const StepScratch::Press& press : scratch_.presses) {
      if (press.partA == child.a && press.partB == child.b) most = std::max(most, press.depth);
    }
    return most;
  }

  // The contacts of the finest level were looked for once more, before it is left on credit.
  void settleFinest() {
    const bool hadCredit = !credit_.account.empty();
    shrinkCredit();
    mostPress_ = std::max(mostPress_, settleContacts(hadCredit).press);
  }

  void openCredit(bool wasFinest) {
    if (wasFinest) credit_.easedOverlap = std::min(easedOverlap(), plan_.rules.finerOverlap);
    credit_.account.close();
    const bool isCoarser = isOnCredit_ && level_ < finest();
    credit_.kind = isCoarser ? CreditKind::kCoarser : isOnCredit_ ? CreditKind::kFinest : CreditKind::kNone;
    if (!isCoarser) return;
    // Contacts of the finest shapes, found just now, tell the gap.
    const float least = pair_.held.leastDistance(engine_);
    credit_.gap = wasFinest && least < pair_.parts.threshold() ? least : findGap();
    grantOverlaps();
  }

  // Every overlap that there is at the level is given credit for. The pair's motion starts again with its
  // parts.
  void grantOverlaps() {
    const auto& overlaps =
        scratch_.query.overlaps(engine_.partsOf(0, level_), engine_.partsOf(1, level_), frameB());
    for (const PartQuery::Overlap& overlap : overlaps)
      credit_.account.grant(overlap.a, overlap.b, overlap.depth, credit_.gap);
    credit_.seenMotion = 0.0;
    credit_.freshUntil = 0.0;
    freshen();
  }

  // Whether a program has changed a body's shape, so that credit and contacts that are held are of parts that
  // may be gone.
  [[nodiscard]] bool hasOtherParts() const {
    if (credit_.kind == CreditKind::kNone && pair_.held.empty()) return false;
    const auto versions = engine_.versionsAt(level_);
    return versions && !std::ranges::equal(*versions, pair_.versions);
  }

  void renewCredit() {
    pair_.held.release(engine_);
    credit_.account.close();
    if (!credit_.isCoarser()) {
      credit_.kind = CreditKind::kNone;
      return;
    }
    credit_.gap = findGap();
    if (credit_.gap < engine_.threshold()) look_.atFinest(finest());
    grantOverlaps();
  }

  // Of the finest shapes, as deep as their contacts do not press.
  [[nodiscard]] float easedOverlap() const {
    float overlap = 0.0F;
    for (const void* manifold : pair_.held.manifolds()) {
      for (int i = 0; i < engine_.countPoints(manifold); ++i) {
        if (!engine_.point(manifold, i).presses)
          overlap = std::max(overlap, -engine_.distanceNow(manifold, i));
      }
    }
    return overlap;
  }

  // That parts may move against each other without a look, metres.
  [[nodiscard]] float furthest() const { return furthestUnseen(plan_, pair_.parts.threshold()); }

  // Nothing can come into contact before the gap has closed. Contacts that are new need not be all that there
  // will be, as engines find a point at a time, or only those that are deep: the first looks are soon.
  void freshen() {
    const float distance = furthest();
    const double looks = std::min(static_cast<double>(distance), std::max(kFirstAudit, credit_.freshUntil));
    credit_.freshUntil += std::max(static_cast<double>(credit_.gap - kTouching), looks);
    credit_.latest = static_cast<double>(kLateness * distance);
  }

  // Bodies move in every step of their pairs, so that how far they have come is the same sum whatever these
  // do.
  [[nodiscard]] bool isAsItWas() {
    PlacedBodies bodies;
    return engine_.place(plan_.view.level, bodies) && pair_.isOf(bodies);
  }

  // The contacts of the step before, where the bodies are now.
  void keepContacts() {
    scratch_.looked.clear();
    PartPair::Children& children = pair_.parts.children();
    for (std::size_t i = 0; i < children.size(); ++i) {
      if (!children[i].touching) continue;
      children[i].touching = engine_.outlasts(children[i].contact);
      scratch_.looked.push_back(static_cast<int>(i));
    }
    settleCredit();
    pair_.origin = ContactOrigin::kKept;
    pair_.quietUntil = Pair::kAwake;
    outcome_.work.reuses = true;
    report();
  }

  void findContacts() {
    pair_.origin = returns_ ? ContactOrigin::kGivenBack : ContactOrigin::kFound;
    refreshHeld();
    look_.atLevel(level_, returns_, plan_.auditsFrom);
  }

  // Once none is left a look is due: small bodies lose theirs when they have slid a little. Not in the step
  // of a switch, which is to find what the level before had.
  void refreshHeld() {
    const bool hadPoints = pair_.held.countPoints(engine_) > 0;
    pair_.held.refresh(engine_);
    if (hadPoints && !hasSwitched_ && pair_.held.countPoints(engine_) == 0)
      credit_.freshUntil = std::min(credit_.freshUntil, pair_.parts.motion());
  }

  void shrinkCredit() {
    if (credit_.account.empty()) return;
    credit_.account.shrink([this](int a, int b) { return depthOf(a, b); });
  }

  // Adds credit to the contacts of the child pairs that were looked at.
  void settleCredit() {
    const bool hadCredit = !credit_.account.empty();
    if (credit_.landing > 0) --credit_.landing;
    if (hasSwitched_ && credit_.kind == CreditKind::kFinest) {
      credit_.landing = kSettlingSteps;
      openFinestCredit();
    } else {
      shrinkCredit();
    }
    tally_ = settleContacts(hadCredit);
  }

  // The finest shapes overlap a little: as deep as their contacts were found just now. What they did press
  // before they press still: a body that lies on others would sink into them, and stacks would lean. Of
  // bodies that are deep in each other all contacts press nearly as deep as the deepest that was held.
  void openFinestCredit() {
    for (const ChildPair& child : pair_.parts.children()) {
      if (!child.touching) continue;
      ContactTally tally;
      engine_.addTo(tally, child.contact);
      const float pressed = std::max(pressOf(child), heldPress_ - plan_.rules.finerOverlap);
      const float overlap = -tally.least - pressed;
      if (overlap > kLeastCredit) credit_.account.grant(child.a, child.b, overlap, 0.0F);
    }
  }

  // What is deeper than it was when it had settled is pressed apart again, or bodies would sink.
  [[nodiscard]] bool isEased() const {
    return credit_.kind != CreditKind::kFinest || credit_.landing > 0 || hasSwitched_;
  }

  [[nodiscard]] ContactTally settleContacts(bool hadCredit) {
    ContactTally tally;
    for (const int i : scratch_.looked) {
      const ChildPair& child = pair_.parts.children()[static_cast<std::size_t>(i)];
      if (!child.touching) continue;
      const float granted = credit_.account.of(child.a, child.b);
      if (granted > 0.0F) {
        addCredit(child.contact, granted, engine_, isEased());
      } else if (hadCredit || hasSwitched_) {
        endCredit(child.contact, engine_);
      }
      engine_.addTo(tally, child.contact);
    }
    return tally;
  }

  // How late an audit is: of a pair on credit that has moved so far that its finest shapes must be looked at.
  [[nodiscard]] float lateness() const {
    if (!credit_.isOpen()) return kNotDue;
    const double motion = pair_.parts.motion();
    if (motion < credit_.seenMotion) return kLatest;
    const double late = motion - credit_.freshUntil;
    if (late < 0.0) return kNotDue;
    return late < kLatest * credit_.latest ? static_cast<float>(late / credit_.latest) : kLatest;
  }

  // A pair that has jumped has done so until it is audited.
  void seeMotion() {
    outcome_.late = outcome_.lateNext = lateness();
    if (!credit_.isOpen()) return;
    const double moved = pair_.parts.motion() - credit_.seenMotion;
    if (moved < 0.0) return;
    if (outcome_.late >= 0.0F && outcome_.late < kLatest)
      outcome_.lateNext += static_cast<float>(moved / credit_.latest);
    credit_.seenMotion += moved;
  }

  // How near are the finest shapes, and what contacts would they have? Sliding along each other they come
  // upon other parts of each other.
  void audit() {
    outcome_.audited = true;
    const PairWork before = work_;
    const float threshold = pair_.parts.threshold();
    if (credit_.gap >= threshold) credit_.gap = findGap();
    if (credit_.gap < threshold) {
      look_.atFinest(finest());
    } else {
      pair_.held.release(engine_);
    }
    takeAudit();
    outcome_.auditWork.counts = work_ - before;
  }

  void takeAudit() {
    if (!pair_.held.empty()) {
      credit_.gap = pair_.held.leastDistance(engine_);
    } else if (credit_.gap < pair_.parts.threshold()) {
      credit_.gap = findGap();
    }
    credit_.account.audit(credit_.gap, [this](int a, int b) { return depthOf(a, b); });
    credit_.seenMotion = credit_.freshUntil = pair_.parts.motion();
    freshen();
    easeHeld();
  }

  // What was on credit at the finest level stays so: looking at it once more is no reason to press it apart.
  void easeHeld() {
    credit_.easedOverlap = std::min(credit_.easedOverlap, std::max(-credit_.gap, 0.0F));
    if (!(credit_.easedOverlap > 0.0F)) return;
    for (void* manifold : pair_.held.manifolds()) {
      for (int i = 0; i < engine_.countPoints(manifold); ++i) {
        ContactPoint point = engine_.point(manifold, i);
        if (point.distance < -credit_.easedOverlap - kTolerance) continue;
        point.eased = true;
        engine_.write(manifold, i, point);
      }
    }
  }

  void report() {
    for (const void* manifold : pair_.held.manifolds()) engine_.addTo(tally_, manifold);
    outcome_.work.manifolds = tally_.manifolds;
    outcome_.work.contacts = tally_.points;
    // No switch may push: contacts that press deeper than those of the level before would here are told. In
    // every build.
    outcome_.isUnsafe = hasSwitched_ && tally_.press > mostPress_ + kTolerance;
    outcome_.touching = tally_.least < kTouching;
    outcome_.credited = !credit_.account.empty();
  }

  Pair& pair_;
  CreditState& credit_;
  const PairPlan& plan_;
  PairEngine& engine_;
  StepScratch& scratch_;
  PairWork& work_;
  LevelLook look_;

  int level_;  ///< Whose shapes the contacts are of.
  bool changesLevel_ = false;
  bool hasSwitched_ = false;  ///< The same, but for new pairs.
  bool isOnCredit_ = false;
  bool returns_ = false;  ///< The contacts that were held go back to child pairs of the finest level.
  Frame frameB_{};        ///< Body 1 in the frame of body 0; once it was asked for.
  bool hasFrame_ = false;
  ContactTally tally_{};
  float heldPress_ = 0.0F;  ///< How deep the contacts that are held press.
  float mostPress_ = 0.0F;  ///< How deep contacts may press after a switch: as those of the level before do,
                            ///< where the bodies are.
  PairOutcome outcome_{};
};

}  // namespace

bool keepsContacts(const Pair& pair, const PairPlan& plan, int queries, const Frame& frameB) {
  const bool canKeep = queries >= plan.keepsFrom && pair.foresight == nullptr && !pair.hasFallenBack &&
                       pair.held.empty() && pair.versions[0] != Pair::kNoParts;
  return canKeep && pair.parts.movedSince(frameB) < furthestUnseen(plan, pair.parts.threshold());
}

bool staysQuiet(Pair& pair, const PlacedBodies& bodies) {
  const bool isSame = bodies.a->jumps() + bodies.b->jumps() == pair.jumps && pair.isOf(bodies);
  if (!isSame || !(pair.quietUntil > Pair::kAwake)) return false;
  if (bodies.a->travel() + bodies.b->travel() < pair.quietUntil) return true;
  if (!pair.parts.staysQuiet(*bodies.a, *bodies.b)) return false;
  pair.quietUntil = pair.parts.quietUntil();
  return true;
}

void collidePair(Pair& pair, int level, const PairSteps& steps, PairEngine& engine, StepScratch& scratch,
                 PairWork& work) {
  pair.origin = ContactOrigin::kFound;
  LevelLook(pair, steps, engine, scratch, work).atLevel(level, false, false);
}

PairOutcome stepPair(Pair& pair, const PairPlan& plan, const PairSteps& steps, PairEngine& engine,
                     StepScratch& scratch, PairWork& work) {
  PairWork own;
  const PairOutcome outcome = PairStep(pair, plan, steps, engine, scratch, own).run();
  work += own;
  return outcome;
}

}  // namespace scatter::pairs
