#include "pairs/region.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace scatter::pairs {

namespace {

/// Of the body's radius. A larger one makes regions of more pieces, a smaller one more regions.
constexpr float kSkin = 0.25F;

/// Of the body's radius: the longest way in a step around which pieces are looked up.
constexpr float kLongestWay = 8.0F;

Vec3 limited(const Vec3& way, float radius) {
  const float most = kLongestWay * radius;
  const float length = glm::length(way);
  return length > most ? way * (most / length) : way;
}

/// The bounds of a body's parts in the frame in which the body is at `body`.
void boundsIn(const PartList& parts, const Frame& body, Vec3& low, Vec3& high) {
  const Vec3 center = body(parts.center());
  Vec3 half;
  for (int axis = 0; axis < 3; ++axis) half[axis] = glm::dot(glm::abs(body.row[axis]), parts.half());
  low = center - half;
  high = center + half;
}

/// Of one ground. A large piece is cut anew each time, so that its points move.
bool areSame(const GroundPieces& a, const GroundPieces::Piece& pieceA, const GroundPieces& b,
             const GroundPieces::Piece& pieceB) {
  if (pieceA.part != pieceB.part || pieceA.index != pieceB.index || pieceA.count != pieceB.count)
    return false;
  return a.kind != PartKind::kTriangle || std::ranges::equal(a.pointsOf(pieceA), b.pointsOf(pieceB));
}

}  // namespace

void Region::forget() {
  if (whole_) body_.reset();
  whole_.reset();
  pieces_.clear();
  gathered_ = false;
  lookedUp_ = 0;
}

void Region::share(std::shared_ptr<const WholeGround> whole, bool isNew) {
  whole_ = std::move(whole);
  body_ = std::make_unique<PartBody>(whole_->parts());
  origin_ = whole_->origin();
  lookedUp_ = isNew ? static_cast<int>(whole_->pieces().pieces.size()) : 0;
}

float Region::room(const PartList& parts, const Frame& body) const {
  if (whole_) return std::numeric_limits<float>::infinity();
  if (!gathered_) return -1.0F;
  Vec3 low;
  Vec3 high;
  boundsIn(parts, body, low, high);
  const Vec3 least = glm::min(low - low_, high_ - high);
  return std::min({least.x, least.y, least.z});
}

bool Region::holds(const PartList& parts, const Frame& body, const Vec3& ahead, float reach) const {
  if (whole_) return true;
  if (reach > reach_) return false;
  Frame next = body;
  next.origin += limited(ahead, parts.radius());
  return room(parts, body) >= 0.0F && room(parts, next) >= 0.0F;
}

bool Region::gather(const PartList& parts, const Frame& body, const GroundMotion& motion, float reach,
                    GroundEngine& engine, PartPair& pair, RegionScratch& scratch) {
  boundsIn(parts, body, low_, high_);
  std::swap(pieces_, scratch.before);
  const bool isComplete = collect(motion, reach, parts.radius(), engine);
  lookedUp_ += static_cast<int>(pieces_.pieces.size());
  if (!isComplete || pieces_.pieces.empty()) {
    pair.reset(pair.threshold());
    gathered_ = isComplete;
    return isComplete;
  }
  origin_ = 0.5F * (low_ + high_);
  rebuild(scratch);
  if (gathered_) {
    remap(scratch.before, pair, scratch.moved);
  } else {
    pair.reset(pair.threshold());
  }
  gathered_ = true;
  return true;
}

bool Region::collect(const GroundMotion& motion, float reach, float radius, GroundEngine& engine) {
  const Vec3 ahead = limited(motion.ahead, radius);
  low_ = glm::min(low_, low_ + ahead) - Vec3(kSkin * radius);
  high_ = glm::max(high_, high_ + ahead) + Vec3(kSkin * radius);
  const Vec3 since = limited(motion.since, radius);
  const Vec3 low = glm::min(low_, low_ - since) - reach;
  const Vec3 high = glm::max(high_, high_ - since) + reach;
  pieces_.clear();
  reach_ = reach;
  return engine.collect(low, high, pieces_);
}

void Region::rebuild(RegionScratch& scratch) {
  const auto parts = describePieces(pieces_, origin_, scratch.parts);
  if (list_) {
    list_->assign(parts);
  } else {
    list_ = std::make_unique<PartList>(parts);
  }
  if (body_) {
    body_->setParts(*list_);
  } else {
    body_ = std::make_unique<PartBody>(*list_);
  }
}

// The engine tells pieces in the same order each time. Only those that are near a part of the body matter.
void Region::remap(const GroundPieces& before, PartPair& pair, std::vector<int>& moved) const {
  moved.assign(before.pieces.size(), -1);
  std::size_t next = 0;
  std::size_t last = before.pieces.size();
  for (const ChildPair& child : pair.children()) {
    if (child.a == last) continue;
    last = child.a;
    std::size_t j = next;
    while (j < pieces_.pieces.size() && !areSame(before, before.pieces[last], pieces_, pieces_.pieces[j]))
      ++j;
    if (j == pieces_.pieces.size()) continue;
    moved[last] = static_cast<int>(j);
    next = j + 1;
  }
  pair.remapA(moved);
}

PartBody& Region::moveTo(const Frame& ground) {
  Frame frame = ground;
  frame.origin = ground(origin_);
  body_->moveTo(frame);
  return *body_;
}

std::size_t Region::bytes() const {
  return pieces_.bytes() + (list_ ? list_->bytes() : 0) + (body_ ? body_->bytes() : 0);
}

}  // namespace scatter::pairs
