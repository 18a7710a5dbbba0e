#include "collision/part_pair.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision/box_separation.h"
#include "collision/penetration.h"

namespace scatter {

namespace {

constexpr float kUnknown = std::numeric_limits<float>::infinity();
/// Boxes that are nearer overlap for the engine, whatever their size: metres, one digit of the last place
/// of 1.
constexpr float kBoxTolerance = std::numeric_limits<float>::epsilon();
/// Of the threshold: so exact distances and depths of contacts are.
constexpr float kExactness = 1e-3F;
constexpr double kAwake = std::numeric_limits<double>::lowest();

/// What decides about two parts: which polytopes stand for them, and how near is a contact.
struct ChildRule {
  const PolytopeView& a;
  const PolytopeView& b;
  float margin;
  float threshold;
  bool exact;  ///< The polytopes are the parts, so that the distance needs no engine.
};

// Two boxes and two spheres are in contact only when they overlap, and have contacts of the engine's own
// kind; so have capsules, and a sphere on a triangle. What is taken off every distance covers the engine's
// tolerance but for tiny boxes. Everything else is decided by the distance.
ChildRule ruleOf(const PartList::Part& a, const PartList::Part& b, float threshold, float rounding) {
  const auto isRound = [](PartKind kind) { return kind == PartKind::kSphere || kind == PartKind::kCapsule; };
  const float margin = a.margin + b.margin;
  if (a.kind == PartKind::kBox && b.kind == PartKind::kBox)
    return {a.sharp, b.sharp, 0.0F, std::max(kBoxTolerance - rounding, 0.0F), false};
  if (a.kind == PartKind::kSphere && b.kind == PartKind::kSphere)
    return {a.core, b.core, margin, 0.0F, false};
  const bool enclosed = a.kind == PartKind::kEnclosed || b.kind == PartKind::kEnclosed;
  const auto meet = [&](PartKind first, PartKind second) {
    return (a.kind == first && b.kind == second) || (a.kind == second && b.kind == first);
  };
  if (meet(PartKind::kTriangle, PartKind::kSphere)) return {a.core, b.core, margin, threshold, false};
  return {a.core, b.core, margin, threshold, !enclosed && !(isRound(a.kind) && isRound(b.kind))};
}

// Not exactly its core and margin.
bool isOdd(const PartList::Part& part) {
  return part.kind == PartKind::kEnclosed || part.kind == PartKind::kOpaque;
}

// Nothing may be concluded from the polytopes of such a pair.
bool isOpaque(const PartList::Part& a, const PartList::Part& b) {
  return a.kind == PartKind::kOpaque || b.kind == PartKind::kOpaque;
}

// How far the parts lie apart along the child pair's axis.
float separationAlong(ChildPair& child, const ChildRule& rule, const Frame& frameB) {
  if (child.reachA == kUnknown) child.reachA = reach(rule.a, child.axis);
  const float nearB = glm::dot(child.axis, frameB.origin) - reach(rule.b, frameB.rotateBack(-child.axis));
  return nearB - child.reachA - rule.margin;
}

// Where the polytopes are nearest to each other, or deepest, as far as GJK has decided that. `pointB` is of
// the polytope, without its margin.
bool findContact(const ChildRule& rule, const Frame& frameB, const GjkResult& result, float threshold,
                 WarmSimplex& warm, PartContact& contact, PairWork& work) {
  if (result.state == GjkResult::State::kConverged) {
    contact = {result.axis, result.pointB, result.distance - rule.margin};
    return true;
  }
  if (result.state != GjkResult::State::kOverlap) return false;
  const auto penetration = penetrationOf(rule.a, rule.b, frameB, result.overlap, kExactness * threshold);
  if (!penetration) return false;
  work.gjkIterations += penetration->iterations;
  warm = penetration->face;
  contact = {penetration->axis, penetration->pointB, -penetration->depth - rule.margin};
  return true;
}

bool isOf(const ChildPair& child, const Neighbours& near) {
  return child.a == near.a && child.b == near.b;
}

// A list without room for so many gets some, with some more to grow little by little; one with far too much
// gives it to others.
template <class Child>
void fit(std::pmr::vector<Child>& list, std::size_t count) {
  const std::size_t room = count + count / 4 + 1;
  if (count <= list.capacity() && list.capacity() <= 2 * room) return;
  std::pmr::vector<Child> other(list.get_allocator());
  other.reserve(room);
  other.assign(list.cbegin(), list.cend());
  list = std::move(other);
}

Vec3 towards(const Vec3& from, const Vec3& to) {
  const Vec3 between = to - from;
  const float length = glm::length(between);
  return length > 1e-6F ? between / length : Vec3(1.0F, 0.0F, 0.0F);
}

}  // namespace

namespace {

constexpr int PairWork::*kCounts[]{
    &PairWork::pairs,          &PairWork::pairsSkipped,     &PairWork::rebuilds,
    &PairWork::childPairs,     &PairWork::childPairsAsleep, &PairWork::recycled,
    &PairWork::boundsRejected, &PairWork::axisRejected,     &PairWork::gjkRuns,
    &PairWork::gjkIterations,  &PairWork::detectorRuns,     &PairWork::halfSpaceRuns,
    &PairWork::pieces};
static_assert(sizeof(kCounts) / sizeof(kCounts[0]) == sizeof(PairWork) / sizeof(int));

}  // namespace

PairWork& operator+=(PairWork& work, const PairWork& other) {
  for (const auto count : kCounts) work.*count += other.*count;
  return work;
}

PairWork operator-(const PairWork& work, const PairWork& other) {
  PairWork difference = work;
  for (const auto count : kCounts) difference.*count -= other.*count;
  return difference;
}

void PartPair::reset(float threshold) {
  children_.clear();
  threshold_ = threshold;
  lastMotion_ = 0.0F;
  forgetList();
  touches_ = false;
}

void PartPair::remapA(std::span<const int> to) {
  forgetList();
  std::size_t kept = 0;
  for (const ChildPair& child : children_) {
    if (to[child.a] < 0) continue;
    ChildPair& moved = children_[kept++];
    moved = child;
    moved.a = static_cast<std::uint16_t>(to[child.a]);
    moved.wake = kAwake;
    moved.settled = false;
    moved.reachA = kUnknown;
  }
  children_.resize(kept);
}

bool PartPair::advance(PartBody& a, PartBody& b, const PairSteps& steps, PairScratch& scratch,
                       PairWork& work) {
  ++work.pairs;
  scratch.dropped.clear();
  motionBound_ = steps.motionBound;
  const int jumps = a.jumps() + b.jumps();
  if (jumps != jumps_) forgetProofs();
  jumps_ = jumps;
  if (a.travel() + b.travel() < quietUntil_ || staysQuiet(a, b)) {
    ++work.pairsSkipped;
    return false;
  }
  follow(a, b);
  const bool complete = steps.midphase == PairMidphase::kNeighbourList && listed_ && motion_ < listEnd_;
  if (!complete) {
    ++work.rebuilds;
    rebuild(a, b, steps, scratch);
  }
  if (children_.empty()) {
    settle(a, b, steps);
    return false;
  }
  return true;
}

// Nothing is known of distances any more.
void PartPair::forgetList() {
  listed_ = false;
  motion_ = 0.0;
  listedMotion_ = 0.0;
  forgetWakeful();
  quietUntil_ = kAwake;
  listSlack_ = -1.0;
}

// After a move that has no length, or too much of it to be added up.
void PartPair::forgetProofs() {
  forgetList();
  turn_ = 0.0F;
  for (ChildPair& child : children_) {
    child.settled = false;
    child.wake = kAwake;
    child.hasAxis = false;
    child.simplex.count = 0;
  }
}

// Where B is in A's frame, and how far that is from where it was.
void PartPair::follow(const PartBody& a, const PartBody& b) {
  // So long a sum would lose the millimetres, and so many turns the minutes.
  constexpr double kLongest = 1e6;
  constexpr float kMostTurned = 1e3F;
  if (!(motion_ < kLongest) || !(turn_ < kMostTurned)) forgetProofs();
  const Frame now = relativeFrame(a.frame(), b.frame());
  const PartList& parts = b.parts();
  const Displacement moved =
      listed_ ? displacementBound(frameB_, now, parts.center(), parts.radius()) : Displacement();
  lastMotion_ = moved.length;
  motion_ += static_cast<double>(moved.length);
  if (listed_) listedMotion_ += static_cast<double>(std::min(listedDisplacement(now), moved.length));
  turn_ += listed_ ? std::max(moved.turn, turnBound(frameA_, a.frame())) : 0.0F;
  turnSince_ = 0.0F;
  frameB_ = now;
  frameA_ = a.frame();
  constexpr float kRounding = 2e-6F;
  rounding_ = 1e-3F * threshold_ +
              kRounding * (a.parts().radius() + glm::length(a.parts().center()) + parts.radius() +
                           glm::length(parts.center()) + glm::length(now.origin));
}

// A dozen steps at the last motion: good for slow and fast bodies alike, and the number matters little. A
// list that would not last for one step gets no room at all. With 1.5, 2 or 2.5 thresholds as the widest,
// `scatter run` of the families implosion, rooms, bowl and ships_heights (seeds 11, 13 to 15) in `lean` takes
// 0.92 to 0.97 of the time that it takes where fast bodies' lists are wide, too, whichever it is.
float PartPair::skin() const {
  constexpr float kSteps = 12.0F;
  constexpr float kWidest = 2.5F;
  if (!listed_) return 0.4F * threshold_;
  if (lastMotion_ > kWidest * threshold_) return 0.0F;
  return std::clamp(kSteps * lastMotion_, 0.08F * threshold_, kWidest * threshold_);
}

void PartPair::rebuild(PartBody& a, PartBody& b, const PairSteps& steps, PairScratch& scratch) {
  NeighbourSearch& search = scratch.search;
  if (steps.midphase == PairMidphase::kWorldBoxes || a.parts().hasOpaque() || b.parts().hasOpaque()) {
    search.byWorldBounds(a, b, boundsAreOfAll_ ? 0.0F : threshold_ + rounding_);
    merge(a, b, search.found(), scratch);
    enclose(b.parts(), steps.midphase);
    listed_ = true;
    listEnd_ = kAwake;
    return;
  }
  const float wide = steps.midphase == PairMidphase::kNeighbourList ? skin() : 0.0F;
  const float limit = threshold_ + rounding_ + wide;
  const float apart = boxSeparation(a.parts().center(), a.parts().half(), b.parts().center(),
                                    b.parts().half(), frameB_, limit);
  if (apart > limit) {
    merge(a, b, {}, scratch);
  } else {
    search.byPartBoxes(a.parts(), b.parts(), frameB_, limit);
    merge(a, b, search.found(), scratch);
  }
  enclose(b.parts(), steps.midphase);
  listed_ = true;
  listEnd_ = motion_ + static_cast<double>(apart > limit ? apart - threshold_ - rounding_ : wide);
}

// A list that is made anew in every step is not worth it.
void PartPair::enclose(const PartList& parts, PairMidphase midphase) {
  listedCenter_ = parts.center();
  listedRadius_ = parts.radius();
  if (midphase != PairMidphase::kNeighbourList || children_.empty()) return;
  const PartList::Boxes& boxes = parts.boxes();
  Vec3 low(std::numeric_limits<float>::max());
  Vec3 high(std::numeric_limits<float>::lowest());
  for (const ChildPair& child : children_) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], boxes.center[axis][child.b] - boxes.half[axis][child.b]);
      high[axis] = std::max(high[axis], boxes.center[axis][child.b] + boxes.half[axis][child.b]);
    }
  }
  listedCenter_ = 0.5F * (low + high);
  listedRadius_ = 0.5F * glm::length(high - low) * 1.0001F;
}

// Both lists are in ascending order of (a, b). Where they begin alike nothing has to be moved.
void PartPair::merge(PartBody& a, PartBody& b, std::span<const Neighbours> found, PairScratch& scratch) {
  const std::size_t most = std::min(children_.size(), found.size());
  std::size_t same = 0;
  for (; same < most && isOf(children_[same], found[same]); ++same) {
    takeSeparation(children_[same], found[same]);
  }
  forgetWakeful();
  if (same == children_.size() && same == found.size()) return;
  mergeFrom(same, a, b, found, scratch);
  const std::size_t count = same + scratch.merged.size();
  children_.resize(same);
  fit(children_, count);
  children_.insert(children_.cend(), scratch.merged.cbegin(), scratch.merged.cend());
}

// What touches stays as long as its contacts may, which is as long as the engine's bounds overlap, even if
// the parts' boxes are not near any more.
void PartPair::mergeFrom(std::size_t first, PartBody& a, PartBody& b, std::span<const Neighbours> found,
                         PairScratch& scratch) {
  scratch.merged.clear();
  auto old = children_.cbegin() + static_cast<std::ptrdiff_t>(first);
  const auto mayStay = [&](const ChildPair& child) {
    if (scratch.keeper == nullptr || !scratch.keeper->outlasts(child.contact)) return false;
    return isOdd(a.parts().part(child.a)) || isOdd(b.parts().part(child.b)) ||
           BoundsTest(a, b).overlap(child.a, child.b);
  };
  const auto drop = [&](const ChildPair& child) {
    if (child.touching && mayStay(child)) {
      scratch.merged.push_back(child);
    } else if (child.contact != nullptr) {
      scratch.dropped.push_back(child.contact);
    }
  };
  for (const Neighbours& near : found.subspan(first)) {
    const auto isBefore = [&near](const ChildPair& child) {
      return child.a < near.a || (child.a == near.a && child.b < near.b);
    };
    for (; old != children_.cend() && isBefore(*old); ++old) drop(*old);
    const bool isKnown = old != children_.cend() && isOf(*old, near);
    ChildPair& child = isKnown ? scratch.merged.emplace_back(*old++) : scratch.merged.emplace_back();
    child.a = near.a;
    child.b = near.b;
    takeSeparation(child, near);
  }
  for (; old != children_.cend(); ++old) drop(*old);
}

// The boxes may prove more than what is known.
void PartPair::takeSeparation(ChildPair& child, const Neighbours& near) const {
  if (near.separation == std::numeric_limits<float>::lowest()) return;
  const double wake =
      listedMotion_ + static_cast<double>(near.separation) - static_cast<double>(threshold_ + rounding_);
  if (child.hasAxis && wake <= child.wake) return;
  child.hasAxis = true;
  child.axis = near.axis;
  child.reachA = kUnknown;
  if (motionBound_) child.wake = wake;
}

void PartPair::wakeAfter(ChildPair& child, float separation, float threshold) const {
  if (!motionBound_) return;
  child.wake = listedMotion_ + static_cast<double>(separation) - static_cast<double>(threshold + rounding_);
}

ChildVerdict PartPair::judge(ChildPair& child, const PartBody& a, const PartBody& b, const PairSteps& steps,
                             PartContact& contact, PairWork& work) {
  if (isToldApart(child, a, b, steps, work)) return ChildVerdict::kApart;
  return measure(child, a, b, steps, contact, work);
}

bool PartPair::isToldApart(ChildPair& child, const PartBody& a, const PartBody& b, const PairSteps& steps,
                           PairWork& work) {
  if (child.touching || !steps.cachedAxis || !child.hasAxis) return false;
  const PartList::Part& partA = a.parts().part(child.a);
  const PartList::Part& partB = b.parts().part(child.b);
  if (isOpaque(partA, partB)) return false;
  const ChildRule rule = ruleOf(partA, partB, threshold_, rounding_);
  const float separation = separationAlong(child, rule, frameB_);
  if (!(separation > rule.threshold + rounding_)) return false;
  ++work.axisRejected;
  wakeAfter(child, separation, rule.threshold);
  return true;
}

ChildVerdict PartPair::measure(ChildPair& child, const PartBody& a, const PartBody& b, const PairSteps& steps,
                               PartContact& contact, PairWork& work) {
  const PartList::Part& partA = a.parts().part(child.a);
  const PartList::Part& partB = b.parts().part(child.b);
  const ChildRule rule = ruleOf(partA, partB, threshold_, rounding_);
  if (isOpaque(partA, partB)) {
    child.wake = kAwake;
    return ChildVerdict::kAskEngine;
  }
  child.wake = kAwake;
  if (!steps.ownGjk || (child.touching && !rule.exact)) return ChildVerdict::kAskEngine;

  if (!steps.warmSimplex) child.simplex.count = 0;
  const Vec3 start = child.hasAxis ? child.axis : towards(partA.center, frameB_(partB.center));
  // Proving some more than needed lets the child pair sleep longer.
  const float enough = rule.margin + rule.threshold + rounding_ + threshold_;
  const GjkResult result =
      gjkDistance(rule.a, rule.b, frameB_, start, enough, kExactness * threshold_, child.simplex);
  ++work.gjkRuns;
  work.gjkIterations += result.iterations;
  const float proven = result.provenDistance - rule.margin;
  if (result.provenDistance > std::numeric_limits<float>::lowest()) {
    child.hasAxis = true;
    child.axis = result.provenAxis;
    child.reachA = kUnknown;
    wakeAfter(child, proven, rule.threshold);
  }
  if (result.state == GjkResult::State::kApart) return ChildVerdict::kApart;
  if (rule.exact && findContact(rule, frameB_, result, threshold_, child.simplex, contact, work)) {
    if (contact.distance > rule.threshold) return ChildVerdict::kApart;
    contact.pointB -= contact.axis * partB.margin;
    return ChildVerdict::kContact;
  }
  return proven > rule.threshold ? ChildVerdict::kApart : ChildVerdict::kAskEngine;
}

bool PartPair::isExact(const ChildPair& child, const PartBody& a, const PartBody& b) const {
  const PartList::Part& partA = a.parts().part(child.a);
  const PartList::Part& partB = b.parts().part(child.b);
  return !isOpaque(partA, partB) && ruleOf(partA, partB, threshold_, rounding_).exact;
}

void PartPair::learnAxis(ChildPair& child, const PartBody& a, const PartBody& b, const Vec3& axis) {
  const PartList::Part& partA = a.parts().part(child.a);
  const PartList::Part& partB = b.parts().part(child.b);
  const ChildRule rule = ruleOf(partA, partB, threshold_, rounding_);
  if (isOpaque(partA, partB)) return;
  child.hasAxis = true;
  child.axis = axis;
  child.reachA = kUnknown;
  wakeAfter(child, separationAlong(child, rule, frameB_), rule.threshold);
}

// Most child pairs of a list sleep for long, and a pile's do not fit into a cache: they are passed by for so
// many steps at the last motion.
void PartPair::findWakeful() {
  constexpr float kSteps = 8.0F;
  wakefulUntil_ = listedMotion_ + static_cast<double>(std::max(kSteps * lastMotion_, 0.05F * threshold_));
  const auto isWakeful = [this](const ChildPair& child) {
    return child.touching || child.wake < wakefulUntil_;
  };
  othersWake_ = std::numeric_limits<double>::max();
  wakeful_.clear();
  fit(wakeful_, static_cast<std::size_t>(std::ranges::count_if(children_, isWakeful)));
  for (std::size_t i = 0; i < children_.size(); ++i) {
    const ChildPair& child = children_[i];
    if (isWakeful(child)) {
      wakeful_.push_back({child.wake, static_cast<int>(i), child.touching});
    } else {
      othersWake_ = std::min(othersWake_, child.wake);
    }
  }
}

// Those that slept were not looked at. Where contacts are recycled, what is apart is left alone for a moment.
double PartPair::renewWakeful(double rest) {
  static_cast<void>(wakeful());
  touches_ = false;
  double least = std::numeric_limits<double>::max();
  for (WakefulChild& one : wakeful_) {
    ChildPair& child = children_[static_cast<std::size_t>(one.index)];
    if (!isAsleep(one)) {
      one.wake = child.wake;
      one.touching = child.touching;
    }
    touches_ = touches_ || one.touching;
    if (one.touching) continue;
    if (one.wake < rest) one.wake = child.wake = rest;
    least = std::min(least, one.wake);
  }
  return least;
}

void PartPair::settle(const PartBody& a, const PartBody& b, const PairSteps& steps) {
  double rest = kAwake;
  if (steps.recycling > 0.0F) {
    const auto moment = static_cast<double>(std::min(steps.recycling, 0.25F * threshold_));
    listEnd_ = std::max(listEnd_, motion_ + moment);
    rest = listedMotion_ + moment;
  }
  const double wake = renewWakeful(rest);
  listSlack_ = steps.midphase == PairMidphase::kNeighbourList ? listEnd_ - motion_ : -1.0;
  listedSlack_ = std::min(wake, wakefulUntil_) - listedMotion_;
  const bool rests = !touches_ || steps.recycling > 0.0F;
  if (rests && listSlack_ > 0.0 && listedSlack_ > 0.0) {
    listedSlack_ = std::min(wake, othersWake_) - listedMotion_;
  }
  const double slack = std::min(listSlack_, listedSlack_);
  quietUntil_ = slack > 0.0 && !touches_ ? a.travel() + b.travel() + slack : kAwake;
}

bool PartPair::staysQuiet(const PartBody& a, const PartBody& b) {
  if (touches_ || !(std::min(listSlack_, listedSlack_) > 0.0)) return false;
  const double left = slackLeft(a, b);
  // Once it is used up a look is due: that is not found out twice.
  if (!(left > 0.0)) listSlack_ = -1.0;
  if (left > 0.0) quietUntil_ = a.travel() + b.travel() + left;
  return left > 0.0;
}

bool PartPair::hasNoNewcomers(const PartBody& a, const PartBody& b) {
  const double left = slackLeft(a, b);
  turnSince_ = std::max(turnSince_, turnBound(frameA_, a.frame()));
  return a.jumps() + b.jumps() == jumps_ && left > 0.0;
}

double PartPair::slackLeft(const PartBody& a, const PartBody& b) {
  const Frame now = relativeFrame(a.frame(), b.frame());
  const Displacement moved = displacementBound(frameB_, now, b.parts().center(), b.parts().radius());
  turnSince_ = moved.turn;
  return std::min(listSlack_ - static_cast<double>(moved.length),
                  listedSlack_ - static_cast<double>(std::min(listedDisplacement(now), moved.length)));
}

double PartPair::mostMotion(const PartBody& a, const PartBody& b) const {
  if (!listed_) return motion_;
  const Frame now = relativeFrame(a.frame(), b.frame());
  const PartList& parts = b.parts();
  return motion_ +
         static_cast<double>(displacementBound(frameB_, now, parts.center(), parts.radius()).length);
}

float PartPair::movedSince(const Frame& now) const {
  if (!listed_) return std::numeric_limits<float>::infinity();
  return displacementBound(frameB_, now, listedCenter_, listedRadius_).length;
}

float PartPair::listedDisplacement(const Frame& now) const {
  return followsWhole_ ? std::numeric_limits<float>::infinity() : movedSince(now);
}

}  // namespace scatter
