#include "lod/policies_local.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "lod/approach.h"

namespace scatter::lod {
namespace {

/// A pair that is coarse already stays so until its speed is this much below a threshold.
constexpr float kStayFast = 0.8F;

/// The corner of a picture of 16 : 9, in half heights from its middle.
constexpr float kCorner = 2.04F;

constexpr float kRadiansPerDegree = 3.14159265F / 180.0F;

bool isCoarse(const PairView& pair, int level) {
  return pair.level != 0 && pair.level <= level;
}

/// 1 up to `from`, then in a straight line down to `least` at `to`. What is no number gives 1.
float falling(float value, float from, float to, float least) {
  if (!(value > from)) return 1.0F;
  if (value >= to) return least;
  return 1.0F - (1.0F - least) * (value - from) / (to - from);
}

/// Kilograms; infinite for what nothing moves.
float weightOf(const BodyView& body) {
  return body.mass > 0.0F ? body.mass : std::numeric_limits<float>::infinity();
}

}  // namespace

void ProximityPolicy::advise(const Situation& situation, const PairView& pair, Wish& wish) const {
  const bool wasAsked = isCoarse(pair, def_.level);
  if (pair.touching) {
    if (wasAsked && pair.contactSteps < def_.steps) wish.request(def_.level);
    return;
  }
  const float approach = approachSpeed(situation.bodies[pair.a], situation.bodies[pair.b]);
  if (approach > (wasAsked ? -def_.approach : def_.approach)) wish.request(def_.level);
}

void SpeedPolicy::advise(const Situation& situation, const PairView& pair, Wish& wish) const {
  const float speed = glm::length(situation.bodies[pair.a].velocity - situation.bodies[pair.b].velocity);
  wish.scale(falling(speed, def_.from, def_.to, def_.least));
  if (def_.coarse <= 0.0F) return;
  const float threshold = isCoarse(pair, def_.level) ? kStayFast * def_.coarse : def_.coarse;
  if (speed > threshold) wish.request(def_.level);
}

void ContactTimePolicy::advise(const Situation& /*situation*/, const PairView& pair, Wish& wish) const {
  if (!pair.touching) return;
  const float share =
      static_cast<float>(std::min<int>(pair.contactSteps, def_.steps)) / static_cast<float>(def_.steps);
  wish.scale(1.0F + (def_.most - 1.0F) * share);
}

FocusPolicy::FocusPolicy(const Def& def) : def_(def), clearSlope_(std::tan(def.angle * kRadiansPerDegree)) {}

void FocusPolicy::observe(const Situation& situation) {
  view_.reset();
  if (!situation.focus) return;
  const Vec3 line = situation.focus->target - situation.focus->eye;
  const float distance = glm::length(line);
  const float fieldOfView = situation.focus->fieldOfView;
  const bool isUsable = distance > 0.0F && fieldOfView > 0.0F && fieldOfView < 3.1F;
  if (!isUsable) return;
  view_ = View{situation.focus->eye, line / distance, std::tan(0.5F * fieldOfView)};
}

void FocusPolicy::advise(const Situation& situation, const PairView& pair, Wish& wish) const {
  if (!view_) return;
  const BodyView& a = situation.bodies[pair.a];
  const BodyView& b = situation.bodies[pair.b];
  wish.scale(importance(*view_, b.radius < a.radius ? b : a));
}

float FocusPolicy::importance(const View& view, const BodyView& body) const {
  const Vec3 offset = body.center - view.eye;
  const float depth = glm::dot(offset, view.forward);
  if (depth <= -body.radius) return def_.least;

  // Around the eye itself everything is large.
  const float distance = std::max(depth, body.radius);
  const float aside = glm::length(offset - view.forward * depth);
  if (aside - body.radius > kCorner * view.halfHeight * distance) return def_.least;

  const float size = body.radius / (distance * view.halfHeight);
  const float slope = aside / distance;
  const float periphery = slope > clearSlope_ ? clearSlope_ / slope : 1.0F;
  return std::clamp(size / def_.size * periphery, def_.least, def_.most);
}

void HeldPolicy::advise(const Situation& situation, const PairView& pair, Wish& wish) const {
  if (situation.bodies[pair.a].held || situation.bodies[pair.b].held) wish.promise(pair.finest);
}

void MassPolicy::observe(const Situation& situation) {
  if (def_.reference > 0.0F) return;
  masses_.clear();
  for (const BodyView& body : situation.bodies) {
    if (body.present && body.mass > 0.0F) masses_.push_back(body.mass);
  }
  const auto middle = masses_.begin() + static_cast<std::ptrdiff_t>(masses_.size() / 2);
  std::nth_element(masses_.begin(), middle, masses_.end());
  reference_ = masses_.empty() ? 0.0F : *middle;
}

void MassPolicy::advise(const Situation& situation, const PairView& pair, Wish& wish) const {
  if (!(reference_ > 0.0F)) return;
  const float a = weightOf(situation.bodies[pair.a]);
  const float b = weightOf(situation.bodies[pair.b]);
  const float mass = def_.heavier != 0 ? std::max(a, b) : std::min(a, b);
  wish.scale(std::clamp(std::sqrt(mass / reference_), 1.0F / def_.most, def_.most));
}

}  // namespace scatter::lod
