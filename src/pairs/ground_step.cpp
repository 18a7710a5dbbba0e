#include "pairs/ground_step.h"

#include <algorithm>
#include <limits>

#include "pairs/contact_credit.h"
#include "pairs/ground_look.h"

namespace scatter::pairs {

namespace {

/// A body that went finer falls by the room that its finer shapes leave, and may tip over: in so many steps
/// in contact it has come to rest. (`switch_bench`: with none, 1 world of 1700 gains energy by it.)
constexpr int kLandingSteps = 10;

class GroundStep {
 public:
  GroundStep(GroundPair& pair, const PairPlan& plan, const PairSteps& steps, GroundEngine& engine,
             StepScratch& scratch, PairWork& work)
      : pair_(pair),
        plan_(plan),
        engine_(engine),
        work_(work),
        scratch_(scratch.ground),
        look_(pair, steps, engine, scratch.parts, scratch.ground, work) {}

  PairOutcome run() {
    if (!plan_.tries && pair_.landing > 0) {
      land();
    } else if (!plan_.tries) {
      if (plan_.keepsFrom == 0) {
        outcome_.work.reuses = look_.keepsAtLevel(plan_.view.level, furthest());
      } else {
        look_.atLevel(plan_.view.level);
      }
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
  // That the body may move without a look: as parts of a pair may between two audits.
  [[nodiscard]] float furthest() const { return furthestUnseen(plan_, pair_.parts.threshold()); }

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
    const float press = rememberPresses();
    look_.atLevel(plan_.target);
    const bool overlaps = tally().least < -press;
    if (overlaps && plan_.rules.safe && !plan_.rules.credit) {
      look_.atLevel(plan_.view.level);
      grantCredit();
      take(lod::SwitchKind::kBlocked, plan_.view.level);
      return;
    }
    if (plan_.rules.safe) grantCredit();
    hasSwitched_ = true;
    mostPress_ = press;
    take(overlaps ? lod::SwitchKind::kOnCredit : lod::SwitchKind::kFree, plan_.target);
  }

  // What it falls upon deeper than anything has pressed it yet holds it, but does not drive it out: error
  // reduction would give back more than the fall has taken.
  void land() {
    rememberPresses();
    look_.atLevel(plan_.view.level);
    grantCredit();
    if (!pair_.contacts.empty()) --pair_.landing;
  }

  void take(lod::SwitchKind kind, int level) {
    const int from = plan_.view.level;
    if (from > 0 && level != from) pair_.landing = plan_.rules.safe && level > from ? kLandingSteps : 0;
    outcome_.tried = true;
    outcome_.choice = {kind, level};
  }

  // Where and how deep the contacts press where the bodies are now, before the switch; the deepest.
  float rememberPresses() {
    float most = 0.0F;
    scratch_.presses.clear();
    for (const GroundContact& contact : pair_.contacts) {
      for (int i = 0; i < engine_.countPoints(contact.manifold); ++i) {
        const ContactPoint point = engine_.point(contact.manifold, i);
        const float depth = -engine_.distanceNow(contact.manifold, i) - contact.credit;
        if (!point.presses || !(depth > 0.0F)) continue;
        scratch_.presses.push_back({point.position, depth});
        most = std::max(most, depth);
      }
    }
    return most;
  }

  [[nodiscard]] ContactTally tally() const {
    ContactTally all;
    for (const GroundContact& contact : pair_.contacts) engine_.addTo(all, contact.manifold);
    return all;
  }

  [[nodiscard]] float depthOf(const GroundContact& contact) const {
    ContactTally own;
    engine_.addTo(own, contact.manifold);
    return std::max(-own.least, 0.0F);
  }

  // What the shapes of the new level overlap more than those of the level before did is no reason to press.
  // One that pressed is stood for by the nearest alone: a body that is deep at one corner is not lifted at
  // all of them.
  void grantCredit() {
    scratch_.allowed.assign(pair_.contacts.size(), 0.0F);
    for (const GroundScratch::Press& press : scratch_.presses) {
      if (pair_.contacts.empty()) break;
      float& allowed = scratch_.allowed[nearest(press.position)];
      allowed = std::max(allowed, press.depth);
    }
    for (std::size_t i = 0; i < pair_.contacts.size(); ++i) {
      GroundContact& contact = pair_.contacts[i];
      contact.credit = std::max(depthOf(contact) - scratch_.allowed[i], 0.0F);
      apply(contact);
    }
  }

  // Of the contacts, by their points.
  [[nodiscard]] std::size_t nearest(const Vec3& position) const {
    std::size_t best = 0;
    float least = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < pair_.contacts.size(); ++i) {
      const void* const manifold = pair_.contacts[i].manifold;
      for (int k = 0; k < engine_.countPoints(manifold); ++k) {
        const Vec3 between = engine_.point(manifold, k).position - position;
        if (glm::dot(between, between) >= least) continue;
        least = glm::dot(between, between);
        best = i;
      }
    }
    return best;
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
  GroundScratch& scratch_;
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
