#include "pairs/held_contacts.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

namespace scatter::pairs {

namespace {

using Candidate = HeldScratch::Candidate;

/// What two directions that are opposed count, as a distance in metres, when contacts are told apart.
constexpr float kTurned = 2.0F;

/// Least cosine between the directions of two contacts of which one can stand for the other.
constexpr float kAlike = 0.9F;

float squared(const Vec3& v) {
  return glm::dot(v, v);
}

// How different two contacts are: in place, and in direction.
float difference(const ContactPoint& a, const ContactPoint& b) {
  return squared(a.position - b.position) + kTurned * kTurned / 4.0F * squared(a.normal - b.normal);
}

ChildPair* find(std::span<ChildPair> children, int a, int b) {
  const auto isBefore = [](const ChildPair& child, const std::pair<int, int>& wanted) {
    return child.a != wanted.first ? child.a < wanted.first : child.b < wanted.second;
  };
  const auto found = std::lower_bound(children.begin(), children.end(), std::make_pair(a, b), isBefore);
  return found != children.end() && found->a == a && found->b == b ? &*found : nullptr;
}

}  // namespace

void HeldContacts::collect(std::span<const ChildPair> children, const PairEngine& engine,
                           HeldScratch& scratch) const {
  scratch.candidates.clear();
  for (const ChildPair& child : children) {
    const int points = child.contact != nullptr ? engine.countPoints(child.contact) : 0;
    for (int i = 0; i < points; ++i) {
      scratch.candidates.push_back({child.contact, i, engine.point(child.contact, i), kNone});
    }
  }
}

// Contacts that were held and are not found anew are still good: engines find a few at a time and keep them.
void HeldContacts::collectOld(float threshold, const PairEngine& engine, HeldScratch& scratch) const {
  const auto found = static_cast<std::ptrdiff_t>(scratch.candidates.size());
  scratch.replaced.clear();
  for (void* manifold : manifolds()) {
    for (int i = 0; i < engine.countPoints(manifold); ++i) {
      const Candidate old{manifold, i, engine.point(manifold, i), kNone};
      const auto isLike = [&](const Candidate& candidate) {
        return difference(candidate.point, old.point) < threshold * threshold;
      };
      const auto begin = scratch.candidates.begin();
      const bool isFoundAgain = std::any_of(begin, begin + found, isLike);
      (isFoundAgain ? scratch.replaced : scratch.candidates).push_back(old);
    }
  }
}

bool HeldContacts::isFull(const PairEngine& engine) const {
  return count_ == kMostManifolds && engine.isFull(manifolds_[count_ - 1]);
}

void HeldContacts::add(const Candidate& candidate, PairEngine& engine) {
  if (count_ == 0 || engine.isFull(manifolds_[count_ - 1])) manifolds_[count_++] = engine.newManifold();
  engine.move(candidate.manifold, candidate.index, manifolds_[count_ - 1]);
}

// What a contact bore that is not there any more, the one that is most like it bears on.
void HeldContacts::inherit(const Candidate& from, PairEngine& engine) const {
  if (!(from.point.impulse > 0.0F)) return;
  void* best = nullptr;
  int bestIndex = 0;
  float least = kNone;
  for (void* manifold : manifolds()) {
    for (int i = 0; i < engine.countPoints(manifold); ++i) {
      const float far = difference(from.point, engine.point(manifold, i));
      if (far >= least) continue;
      least = far;
      best = manifold;
      bestIndex = i;
    }
  }
  if (best == nullptr || glm::dot(engine.point(best, bestIndex).normal, from.point.normal) < kAlike) return;
  engine.addImpulses(from.manifold, from.index, best, bestIndex);
}

void HeldContacts::gather(std::span<const ChildPair> children, float threshold, PairEngine& engine,
                          HeldScratch& scratch) {
  HeldContacts before = *this;
  collect(children, engine, scratch);
  before.collectOld(threshold, engine, scratch);
  count_ = 0;
  std::vector<Candidate>& candidates = scratch.candidates;
  bool isFirst = true;
  while (!isFull(engine) && !candidates.empty()) {
    const auto isLess = [isFirst](const Candidate& a, const Candidate& b) {
      return isFirst ? a.point.distance > b.point.distance : a.difference < b.difference;
    };
    const auto best = std::max_element(candidates.begin(), candidates.end(), isLess);
    const Candidate chosen = *best;
    add(chosen, engine);
    candidates.erase(best);
    for (Candidate& other : candidates) {
      other.difference = std::min(other.difference, difference(other.point, chosen.point));
    }
    isFirst = false;
  }
  for (const Candidate& left : candidates) inherit(left, engine);
  for (const Candidate& replaced : scratch.replaced) inherit(replaced, engine);
  before.release(engine);
}

void HeldContacts::refresh(const PairEngine& engine) const {
  for (void* manifold : manifolds()) static_cast<void>(engine.outlasts(manifold));
}

void HeldContacts::giveBack(std::span<ChildPair> children, PairEngine& engine) {
  for (void* manifold : manifolds()) {
    for (int i = 0; i < engine.countPoints(manifold); ++i) {
      const ContactPoint point = engine.point(manifold, i);
      ChildPair* const child = find(children, point.partA, point.partB);
      if (child == nullptr) continue;
      if (child->contact == nullptr) child->contact = engine.newManifold();
      if (engine.isFull(child->contact)) continue;
      engine.move(manifold, i, child->contact);
      child->touching = true;
    }
  }
  release(engine);
}

void HeldContacts::release(PairEngine& engine) {
  for (void* manifold : manifolds()) engine.release(manifold);
  count_ = 0;
}

int HeldContacts::countPoints(const PairEngine& engine) const {
  int points = 0;
  for (const void* manifold : manifolds()) points += engine.countPoints(manifold);
  return points;
}

float HeldContacts::leastDistance(const PairEngine& engine) const {
  ContactTally tally;
  for (const void* manifold : manifolds()) engine.addTo(tally, manifold);
  return tally.least;
}

}  // namespace scatter::pairs
