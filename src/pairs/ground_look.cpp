#include "pairs/ground_look.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "pairs/contact_recycling.h"

namespace scatter::pairs {

namespace {

using simd::Lanes;
using simd::load;

/// The normal of a half-space in the frame of a body, and how high the origin of the body is above it.
struct Below {
  Vec3 normal;
  float height;
};

/// Adds the parts whose boxes come nearer to a half-space than `limit`; the least distance of a box.
float partsNear(const PartList& parts, const Below& below, float limit, std::vector<int>& near) {
  near.clear();
  const PartList::Boxes& boxes = parts.boxes();
  const Vec3 spread = glm::abs(below.normal);
  constexpr float kNone = 1e18F;
  Lanes least(kNone);
  for (std::size_t i = 0; i < static_cast<std::size_t>(parts.paddedCount()); i += Lanes::size()) {
    Lanes height(below.height);
    for (int axis = 0; axis < 3; ++axis) {
      height += load<Lanes>(&boxes.center[axis][i]) * Lanes(below.normal[axis]) -
                load<Lanes>(&boxes.half[axis][i]) * Lanes(spread[axis]);
    }
    least = simd::stdx::min(least, height);
    simd::forEachSet(height < Lanes(limit), [&](int lane) { near.push_back(static_cast<int>(i) + lane); });
  }
  return simd::stdx::hmin(least);
}

// What is on credit is settled by contacts that have just been found.
bool mayCarry(const GroundPair& pair, const PartBody& body, const Frame& ground) {
  return !pair.contacts.empty() && ground == pair.ground && body.jumps() == pair.jumps &&
         !pair.passage.holds() && std::ranges::none_of(pair.contacts, [](const GroundContact& contact) {
           return contact.credit > 0.0F;
         });
}

Displacement movedSince(const GroundPair& pair, const PartBody& body, const Frame& ground) {
  return displacementBound(pair.looked, relativeFrame(ground, body.frame()), body.parts().center(),
                           body.parts().radius());
}

/// The lowest point of a part, in the body's frame; of one that is not known exactly, of the polytope around
/// it.
Vec3 lowestOf(const PartList::Part& part, const Below& below) {
  const bool isBox = part.kind == PartKind::kBox;
  const PolytopeView& shape = isBox ? part.sharp : part.core;
  const Vec3 vertex = shape.vertex(support(shape, -below.normal).vertex);
  return isBox ? vertex : vertex - part.margin * below.normal;
}

/// Of its lowest point.
float heightOf(const PartList::Part& part, const Below& below) {
  if (part.kind == PartKind::kBox) return below.height - reach(part.sharp, -below.normal);
  return below.height - reach(part.core, -below.normal) - part.margin;
}

// Twice the threshold, as what is proven is more than what makes a contact.
float reachOf(const GroundPair& pair, const GroundEngine& engine) {
  return 2.0F * pair.parts.threshold() + engine.groundMargin();
}

}  // namespace

bool findRegion(GroundPair& pair, const PartBody& body, const Frame& bodyInGround, const Vec3& ahead,
                const PairSteps& steps, GroundEngine& engine, RegionScratch& scratch, PairWork& work) {
  const float reach = reachOf(pair, engine);
  bool isComplete = pair.region.holds(body.parts(), bodyInGround, ahead, reach);
  if (!isComplete) {
    GroundMotion motion;
    motion.ahead = ahead;
    if (steps.passages) motion.since = pair.passage.wayTo(bodyInGround, ahead);
    isComplete = pair.region.gather(body.parts(), bodyInGround, motion, reach, engine, pair.parts, scratch);
  }
  work.pieces += pair.region.takeLookedUp();
  return isComplete;
}

bool mayRecycle(const GroundPair& pair, const PartBody& body, const Frame& ground, const PairSteps& steps) {
  if (!(steps.recycling > 0.0F) || !pair.isSettled || !mayCarry(pair, body, ground)) return false;
  const Displacement moved = movedSince(pair, body, ground);
  return moved.length < std::min(steps.recycling, 0.25F * pair.parts.threshold()) &&
         moved.turn < kMostRecycledTurn;
}

bool mayKeep(const GroundPair& pair, const PartBody& body, const Frame& ground, float furthest) {
  return mayCarry(pair, body, ground) && movedSince(pair, body, ground).length < furthest;
}

void GroundLook::atLevel(int level) {
  pair_.restarted = pair_.hasRecycled = false;
  if (!place(level)) return;
  look();
}

bool GroundLook::keepsAtLevel(int level, float furthest) {
  pair_.restarted = pair_.hasRecycled = false;
  if (!place(level)) return false;
  const bool keeps = !pair_.restarted && mayKeep(pair_, *body_, engine_.groundFrame(), furthest);
  if (keeps) {
    foresight_ = std::exchange(pair_.foresight, nullptr);
    pair_.hasRecycled = true;
    carry();
  } else {
    look();
  }
  return keeps;
}

void GroundLook::look() {
  pair_.hasRecycled = steps_.recycling > 0.0F && !pair_.restarted;
  foresight_ = std::exchange(pair_.foresight, nullptr);
  if (foresight_ == nullptr && mayRecycle(pair_, *body_, engine_.groundFrame(), steps_)) {
    carry();
    return;
  }
  if (pair_.jumps != body_->jumps()) pair_.passage.forget();
  pair_.ground = engine_.groundFrame();
  pair_.jumps = body_->jumps();
  pair_.quietUntil = Pair::kAwake;
  pair_.looked = relativeFrame(pair_.ground, body_->frame());
  refresh();
  const int before = steps_.recycling > 0.0F ? countPoints() : 0;
  if (const auto solid = engine_.halfSpace()) {
    lookAtHalfSpace(*solid);
  } else {
    lookAtPieces();
  }
  releaseEmpty();
  pair_.isSettled = steps_.recycling > 0.0F && countPoints() <= before;
}

// Without a look: as the bodies move on, so do the contacts.
void GroundLook::carry() {
  pair_.quietUntil = Pair::kAwake;
  std::erase_if(pair_.contacts, [this](const GroundContact& contact) {
    return !engine_.outlasts(contact.manifold) && drop(contact);
  });
  ++work_.pairs;
  work_.recycled += static_cast<int>(pair_.contacts.size());
}

int GroundLook::countPoints() const {
  int count = 0;
  for (const GroundContact& contact : pair_.contacts) count += engine_.countPoints(contact.manifold);
  return count;
}

bool GroundLook::place(int level) {
  PlacedBody placed;
  if (pair_.isTooFine) {
    pair_.isTooFine = engine_.fallBack();
    return false;
  }
  if (!engine_.place(level, placed)) {
    fallBack();
    return false;
  }
  const int versions[2]{placed.version, engine_.groundVersion()};
  if (pair_.level != level || pair_.hasFallenBack || !std::ranges::equal(versions, pair_.versions)) {
    pair_.restart(engine_.threshold(), engine_);
    pair_.passage.begin(placed.body->parts());
    if (versions[1] != pair_.versions[1]) {
      pair_.region.forget();
      pair_.passage.forget();
    }
    pair_.level = level;
    std::ranges::copy(versions, pair_.versions);
  }
  pair_.hasFallenBack = false;
  body_ = placed.body;
  return true;
}

bool GroundLook::fallBack() {
  if (!pair_.hasFallenBack) pair_.restart(engine_.threshold(), engine_);
  pair_.hasFallenBack = true;
  return engine_.fallBack();
}

// A part that slides loses its points and is found again in the same step: its credit outlasts them.
void GroundLook::refresh() {
  std::erase_if(pair_.contacts, [this](const GroundContact& contact) {
    if (!engine_.keeps(contact.part)) return drop(contact);
    return !engine_.outlasts(contact.manifold) && !(contact.credit > 0.0F) && drop(contact);
  });
}

void GroundLook::releaseEmpty() {
  std::erase_if(pair_.contacts, [this](const GroundContact& contact) {
    engine_.looked(contact.manifold);
    return engine_.countPoints(contact.manifold) == 0 && drop(contact);
  });
  if (!pair_.contacts.empty()) pair_.quietUntil = Pair::kAwake;
}

// True, so that it can be the end of a condition.
bool GroundLook::drop(const GroundContact& contact) {
  engine_.release(contact.manifold);
  return true;
}

bool GroundLook::hasPoints(int part) const {
  const auto place =
      std::ranges::find_if(pair_.contacts, [part](const GroundContact& c) { return c.part == part; });
  return place != pair_.contacts.end() && engine_.countPoints(place->manifold) > 0;
}

void* GroundLook::manifoldOf(int part) {
  const auto place = std::ranges::lower_bound(pair_.contacts, part, std::less<>(),
                                              [](const GroundContact& c) { return c.part; });
  if (place != pair_.contacts.end() && place->part == part) return place->manifold;
  return pair_.contacts.insert(place, {part, engine_.newManifold(), 0.0F})->manifold;
}

void GroundLook::staysQuietFor(double metres) {
  if (metres > 0.0 && steps_.motionBound) pair_.quietUntil = body_->travel() + metres;
}

// The box of a part may reach the half-space where the part does not.
void GroundLook::lookAtHalfSpace(const HalfSpace& solid) {
  ++work_.pairs;
  const PartList& parts = body_->parts();
  const Frame bodyInGround = relativeFrame(pair_.ground, body_->frame());
  const Below below{bodyInGround.rotateBack(solid.normal),
                    glm::dot(solid.normal, bodyInGround.origin) - solid.offset};
  constexpr float kRounding = 4e-6F;
  const float reach = parts.radius() + glm::length(parts.center()) + std::abs(solid.offset) +
                      glm::length(bodyInGround.origin);
  const float limit = pair_.parts.threshold() + kRounding * reach;
  const float least = partsNear(parts, below, limit, scratch_.near);
  staysQuietFor(static_cast<double>(least - limit));
  work_.childPairs += parts.count();
  work_.childPairsAsleep += parts.count() - static_cast<int>(scratch_.near.size());
  for (const int i : scratch_.near) {
    const PartList::Part& part = parts.part(i);
    ChildPair child;
    child.b = static_cast<std::uint16_t>(i);
    if (heightOf(part, below) > limit) {
      ++work_.axisRejected;
      continue;
    }
    if (!engine_.mayMeet(pair_.region.pieces(), child)) continue;
    ++work_.halfSpaceRuns;
    engine_.detect(manifoldOf(i), pair_.region.pieces(), child);
  }
}

// False: the engine's own algorithm is at work.
bool GroundLook::hasRegion(const Frame& bodyInGround, const Vec3& ahead) {
  const bool isComplete =
      findRegion(pair_, *body_, bodyInGround, ahead, steps_, engine_, scratch_.region, work_);
  if (!isComplete) pair_.isTooFine = fallBack();
  return isComplete;
}

void GroundLook::lookAtPieces() {
  const Frame bodyInGround = relativeFrame(pair_.ground, body_->frame());
  const Vec3 ahead = steps_.passages ? engine_.wayAhead() : Vec3(0.0F);
  if (!hasRegion(bodyInGround, ahead)) return;
  const auto room = static_cast<double>(pair_.region.room(body_->parts(), bodyInGround));
  if (steps_.passages) {
    pair_.passage.follow(bodyInGround, pair_.region.pieces(), reachOf(pair_, engine_), ahead);
  } else {
    pair_.passage.forget();
  }
  if (pair_.region.empty()) {
    ++work_.pairs;
    staysQuietFor(room);
    return;
  }
  PartBody& region = pair_.region.moveTo(pair_.ground);
  const bool isAwake = advance(region);
  scratch_.found.clear();
  if (isAwake) judge(region);
  if (pair_.passage.open()) dropBehind(region);
  addFound(region.frame());
  if (pair_.passage.open()) holdInFront(*pair_.passage.open(), region, bodyInGround);
  if (pair_.passage.coming()) holdInFront(*pair_.passage.coming(), region, bodyInGround);
  if (isAwake && foresight_ == nullptr) pair_.parts.settle(region, *body_, steps_);
  if (!pair_.passage.holds())
    staysQuietFor(std::min(room, pair_.parts.quietUntil() - region.travel() - body_->travel()));
}

// The body is behind other triangles, too, and those know only the way on.
void GroundLook::dropBehind(const PartBody& region) {
  // A cosine: walls, which are more than 73 degrees from the way out, hold as they do, and so does what
  // pushes out.
  constexpr float kBeside = 0.3F;
  const Vec3& front = pair_.passage.open()->normal;
  std::erase_if(scratch_.found, [&](const GroundScratch::Found& found) {
    const bool isBeside = std::abs(glm::dot(region.parts().part(found.piece).normal, front)) < kBeside;
    return !isBeside && glm::dot(found.contact.axis, front) < kBeside;
  });
}

// Until its middle is in front again, the plane across its way out is the ground of a body that is behind; no
// part is deeper than if the body had just come half through, as the way back need not be as fast. What is
// about to pass may come as far as the plane, but for parts that are behind it already or touch something.
void GroundLook::holdInFront(const Passage& passage, const PartBody& region, const Frame& bodyInGround) {
  const PartList& parts = body_->parts();
  const float margin = pair_.region.pieces().margin;
  const Below below{bodyInGround.rotateBack(passage.normal), passage.heightOf(bodyInGround.origin) - margin};
  const float most = engine_.threshold() + passage.reach;
  const float deepest = -std::min({parts.half().x, parts.half().y, parts.half().z});
  ChildPair child;
  child.a = static_cast<std::uint16_t>(passage.piece);
  partsNear(parts, below, most, scratch_.near);
  for (const int i : scratch_.near) {
    const PartList::Part& part = parts.part(i);
    const float height = heightOf(part, below);
    if (height > most || !engine_.letsMeet(i)) continue;
    if (passage.reach > 0.0F && (height < -engine_.threshold() || hasPoints(i))) continue;
    child.b = static_cast<std::uint16_t>(i);
    PartContact contact;
    contact.axis = passage.normal;
    contact.pointB = region.frame().toLocal(body_->frame()(lowestOf(part, below)));
    contact.distance = std::max(height, deepest);
    engine_.add(manifoldOf(i), pair_.region.pieces(), child, contact, region.frame());
  }
}

bool GroundLook::advance(PartBody& region) {
  if (foresight_ == nullptr) return pair_.parts.advance(region, *body_, steps_, parts_, work_);
  work_ += foresight_->work;
  return foresight_->isAwake;
}

void GroundLook::judge(const PartBody& region) {
  if (foresight_ != nullptr) {
    for (std::size_t i = 0; i < foresight_->awake.size(); ++i)
      consider(foresight_->awake[i], foresight_->looks[i].verdict, foresight_->looks[i].contact,
               region.frame());
    return;
  }
  pair_.parts.forEachAwake(work_, [&](int index) {
    ChildPair& child = pair_.parts.children()[static_cast<std::size_t>(index)];
    PartContact contact;
    const ChildVerdict verdict = pair_.parts.judge(child, region, *body_, steps_, contact, work_);
    consider(index, verdict, contact, region.frame());
  });
}

// A piece and a part of the body of which it is known how near they are.
void GroundLook::consider(int index, ChildVerdict verdict, const PartContact& contact, const Frame& region) {
  if (verdict == ChildVerdict::kApart) return;
  const ChildPair& child = pair_.parts.children()[static_cast<std::size_t>(index)];
  if (!engine_.mayMeet(pair_.region.pieces(), child)) {
    ++work_.boundsRejected;
    return;
  }
  PartContact found = contact;
  const bool isTold = verdict == ChildVerdict::kContact && isOfWhole(child, contact);
  const bool isKnown = isTold || asks(child, region, found);
  if (isKnown || pair_.region.pieces().kind != PartKind::kTriangle)
    scratch_.found.push_back({child.a, child.b, found.distance, isKnown, found});
}

// The shortest way out of a piece that was cut from a large shape may be through the cut, which is no way out
// of the shape. Cores that are apart are not nearest to a cut, which is further from the body than contacts.
bool GroundLook::isOfWhole(const ChildPair& child, const PartContact& contact) const {
  const GroundPieces& pieces = pair_.region.pieces();
  const float margins = pieces.margin + body_->parts().part(child.b).margin;
  if (pieces.kind == PartKind::kTriangle || contact.distance > -margins) return true;
  float reach = std::numeric_limits<float>::lowest();
  for (const Vec3& point : pieces.pointsOf(pieces.pieces[child.a]))
    reach = std::max(reach, glm::dot(contact.axis, point));
  return engine_.reach(contact.axis) <= reach + 0.01F * engine_.threshold();
}

// Whether the engine's own detector finds a contact of a triangle. What it adds by itself is of one piece.
bool GroundLook::asks(const ChildPair& child, const Frame& region, PartContact& contact) {
  if (pair_.region.pieces().kind != PartKind::kTriangle) return false;
  ++work_.detectorRuns;
  return engine_.find(manifoldOf(child.b), pair_.region.pieces(), child, region, contact);
}

// Of points of a part that are near each other engines keep the last one: that must be the deepest.
void GroundLook::addFound(const Frame& region) {
  std::ranges::sort(scratch_.found, [](const GroundScratch::Found& a, const GroundScratch::Found& b) {
    if (a.part != b.part) return a.part < b.part;
    return a.distance != b.distance ? a.distance > b.distance : a.piece < b.piece;
  });
  for (const GroundScratch::Found& found : scratch_.found) {
    const ChildPair child{found.piece, found.part};
    void* const manifold = manifoldOf(found.part);
    if (found.isKnown) {
      engine_.add(manifold, pair_.region.pieces(), child, found.contact, region);
    } else {
      ++work_.detectorRuns;
      engine_.detect(manifold, pair_.region.pieces(), child);
    }
  }
}

}  // namespace scatter::pairs
