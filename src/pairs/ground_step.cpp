#include "pairs/ground_step.h"

#include <algorithm>

#include "pairs/contact_tally.h"
#include "pairs/ground_look.h"

namespace scatter::pairs {

namespace {

class GroundStep {
 public:
  GroundStep(GroundPair& pair, const PairPlan& plan, const PairSteps& steps, GroundEngine& engine,
             StepScratch& scratch, PairWork& work)
      : pair_(pair),
        plan_(plan),
        engine_(engine),
        work_(work),
        look_(pair, steps, engine, scratch.parts, scratch.ground, work) {}

  PairOutcome run() {
    if (!plan_.tries) {
      look_.atLevel(plan_.view.level);
      settleCredit();
    } else if (plan_.view.level == 0) {
      begin();
    } else {
      change();
    }
    report();
    return outcome_;
  }

 private:
  // A new pair takes a coarse level only if nothing overlaps there.
  void begin() {
    int level = plan_.target;
    look_.atLevel(level);
    if (plan_.rules.safe && level < plan_.view.finest && tally().least < 0.0F) {
      level = plan_.view.finest;
      look_.atLevel(level);
    }
    take(lod::SwitchKind::kFree, level);
  }

  void change() {
    const float press = pressBefore();
    look_.atLevel(plan_.target);
    const bool overlaps = tally().least < -press;
    if (overlaps && plan_.rules.safe && !plan_.rules.credit) {
      look_.atLevel(plan_.view.level);
      grantCredit(press);
      take(lod::SwitchKind::kBlocked, plan_.view.level);
      return;
    }
    if (plan_.rules.safe) grantCredit(press);
    hasSwitched_ = true;
    mostPress_ = press;
    take(overlaps ? lod::SwitchKind::kOnCredit : lod::SwitchKind::kFree, plan_.target);
  }

  void take(lod::SwitchKind kind, int level) {
    outcome_.tried = true;
    outcome_.choice = {kind, level};
  }

  // How deep the contacts press where the bodies are now, before the switch.
  [[nodiscard]] float pressBefore() const {
    float press = 0.0F;
    for (const GroundContact& contact : pair_.contacts) {
      press = std::max(press, pressNow(contact.manifold, engine_) - contact.credit);
    }
    return press;
  }

  [[nodiscard]] ContactTally tally() const {
    ContactTally all;
    for (const GroundContact& contact : pair_.contacts) all.add(contact.manifold, engine_);
    return all;
  }

  [[nodiscard]] float depthOf(const GroundContact& contact) const {
    ContactTally own;
    own.add(contact.manifold, engine_);
    return std::max(-own.least, 0.0F);
  }

  // What the shapes of the new level overlap more than those of the level before did is no reason to press.
  void grantCredit(float press) {
    for (GroundContact& contact : pair_.contacts) {
      contact.credit = std::max(depthOf(contact) - press, 0.0F);
      apply(contact);
    }
  }

  // Credit shrinks with the depth: what has come apart touches as usual from then on.
  void settleCredit() {
    for (GroundContact& contact : pair_.contacts) {
      if (!(contact.credit > 0.0F)) continue;
      contact.credit = std::min(contact.credit, depthOf(contact));
      apply(contact);
    }
  }

  void apply(const GroundContact& contact) {
    if (!(contact.credit > 0.0F)) return;
    for (int i = 0; i < engine_.countPoints(contact.manifold); ++i) {
      ContactPoint point = engine_.point(contact.manifold, i);
      point.distance += contact.credit;
      engine_.write(contact.manifold, i, point);
    }
  }

  void report() {
    const ContactTally all = tally();
    outcome_.work.counts = work_;
    outcome_.work.manifolds = all.manifolds;
    outcome_.work.contacts = all.points;
    outcome_.touching = all.least < kTouching;
    outcome_.isUnsafe = hasSwitched_ && all.press > mostPress_ + kTolerance;
    outcome_.credited = std::ranges::any_of(
        pair_.contacts, [](const GroundContact& contact) { return contact.credit > 0.0F; });
  }

  GroundPair& pair_;
  const PairPlan& plan_;
  GroundEngine& engine_;
  PairWork& work_;
  GroundLook look_;
  bool hasSwitched_ = false;
  float mostPress_ = 0.0F;
  PairOutcome outcome_{};
};

}  // namespace

void collideGround(GroundPair& pair, int level, const PairSteps& steps, GroundEngine& engine,
                   StepScratch& scratch, PairWork& work) {
  GroundLook(pair, steps, engine, scratch.parts, scratch.ground, work).atLevel(level);
}

PairOutcome stepGround(GroundPair& pair, const PairPlan& plan, const PairSteps& steps, GroundEngine& engine,
                       StepScratch& scratch, PairWork& work) {
  PairWork own;
  const PairOutcome outcome = GroundStep(pair, plan, steps, engine, scratch, own).run();
  work += own;
  return outcome;
}

}  // namespace scatter::pairs
