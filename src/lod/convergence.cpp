#include "lod/convergence.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace scatter::lod {
namespace {

// Of the sum of two radii, from how near on bodies are a pair: a ball that holds a box reaches beyond it.
constexpr float kNear = 0.8F;

// Partners of one body: as many fit around it, however many are on their way to the place.
constexpr int kMostPartners = 16;

// Moving bodies that one look follows, of more than that others in each look: eight of them a step, so that
// it takes some microseconds for a hundred bodies, a tenth of a millisecond for two thousand.
constexpr std::size_t kMostFollowed = 64;

// Of its radius: a body that does not get so far lies still.
constexpr float kStill = 0.1F;

// How much of what was learned is kept from look to look, half of it for three seconds; what is foreseen now
// counts as much as this share of itself that comes true.
constexpr double kLearnedKept = 0.97;
constexpr double kBelief = 0.3;

// Pairs that come for one that is foreseen. Where a field pulls, bodies get faster; what rains on a floor is
// stopped by it. docs/budget-figures.md has what other bounds did.
constexpr double kFewestCome = 0.2;
constexpr double kMostCome = 3.0;

}  // namespace

void Convergence::advance(std::span<const BodyView> bodies, float timeStep) {
  if (isDue()) begin(bodies, static_cast<float>(kHorizon) * timeStep);
  follow();
  if (++step_ < kInterval) return;
  step_ = 0;
  learn();
}

void Convergence::begin(std::span<const BodyView> bodies, float seconds) {
  seconds_ = seconds;
  look_ = {};
  balls_.clear();
  moving_.clear();
  for (const BodyView& body : bodies) {
    if (!body.present || !(body.mass > 0.0F)) continue;
    const bool isMoving = glm::length(body.velocity) * seconds > kStill * body.radius;
    if (isMoving) moving_.push_back(balls_.size());
    balls_.push_back({body.center, body.velocity, body.radius, isMoving});
  }
}

/// This step's share of those that are followed: one of as many equal parts of the bodies that move, in every
/// look another one.
void Convergence::follow() {
  const std::size_t followed = std::min(moving_.size(), kMostFollowed);
  const auto step = static_cast<std::size_t>(step_);
  for (std::size_t i = step * followed / kInterval; i < (step + 1) * followed / kInterval; ++i) {
    const std::size_t first = i * moving_.size() / followed;
    const std::size_t end = (i + 1) * moving_.size() / followed;
    const Look one = lookFrom(moving_[first + numLooks_ % (end - first)]);
    const double weight = static_cast<double>(moving_.size()) / static_cast<double>(followed);
    look_.near += weight * one.near;
    look_.foreseen += weight * one.foreseen;
  }
}

/// Where it comes nearest to others. A pair of which both move is half of each.
Convergence::Look Convergence::lookFrom(std::size_t ball) const {
  const Ball& own = balls_[ball];
  Look seen;
  int near = 0;
  int coming = 0;
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    if (i == ball) continue;
    const Ball& other = balls_[i];
    const Vec3 offset = other.center - own.center;
    const float reach = kNear * (own.radius + other.radius);
    const double share = other.isMoving ? 0.5 : 1.0;
    const float distance2 = glm::dot(offset, offset);
    if (distance2 < reach * reach) {
      ++near;
      seen.near += share;
      continue;
    }
    const Vec3 velocity = other.velocity - own.velocity;
    const float approach = -glm::dot(offset, velocity);
    if (!(approach > 0.0F)) continue;
    const float speed2 = glm::dot(velocity, velocity);
    const float time = std::min(approach / speed2, seconds_);
    if (distance2 - time * (2.0F * approach - time * speed2) < reach * reach) {
      ++coming;
      seen.foreseen += share;
    }
  }
  const int room = std::max(kMostPartners - near, 0);
  if (coming > room) seen.foreseen *= static_cast<double>(room) / coming;
  return seen;
}

/// What has come of what was foreseen when the present was as far ahead as is looked.
void Convergence::learn() {
  Look& before = looks_[numLooks_ % kLooks];
  if (numLooks_ >= kLooks) {
    foreseen_ = kLearnedKept * foreseen_ + before.foreseen;
    // A look before anything moved foresees nothing, and says nothing of those that come later.
    came_ = kLearnedKept * came_ + std::clamp(look_.near - before.near, 0.0, kMostCome * before.foreseen);
  }
  ++numLooks_;
  before = look_;
  const double prior = kBelief * look_.foreseen;
  const double known = prior + foreseen_;
  const double came = known > 0.0 ? (prior + came_) / known : 1.0;
  toCome_ = {look_.foreseen, std::clamp(came, kFewestCome, kMostCome) * look_.foreseen};
}

}  // namespace scatter::lod
