#include "viewer/cutaway.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace scatter::viewer {
namespace {

constexpr std::size_t kMostAsked = 64;  // bodies
constexpr float kHidesMuch = 0.25F;     // share of the bodies for which anything is cut away,
constexpr float kWallHides = 0.04F;     // and for which a wall is
constexpr float kHidesNothing = 0.01F;
constexpr float kWallSize = 0.5F;  // radius of a wall, at least, by that of the bodies together
constexpr float kFadeSeconds = 0.3F;
constexpr float kGone = 0.5F;  // share from which it is not there for a user's hand

/// Whether the ray to a body meets the obstacle before it meets the body.
bool hides(const Obstacle& obstacle, const Vec3& eye, const Actor& actor) {
  const Transform back = obstacle.pose.inverse();
  const Vec3 from = back(eye);
  const Vec3 way = back(actor.position) - from;
  const float distance = glm::length(way);
  const float limit = distance - actor.radius;
  if (!(limit > 0.0F)) return false;
  return obstacle.surface->nearestHit(from, way / distance, limit) < limit;
}

/// What the action goes on upon: it lies below its middle, and leaves that to be seen.
bool isFloor(const Obstacle& obstacle, const Vec3& eye, const Vec3& middle) {
  const Transform back = obstacle.pose.inverse();
  const Vec3 down = back.rotation * Vec3(0.0F, -1.0F, 0.0F);
  const float deep = 2.0F * (glm::distance(middle, obstacle.pose.position) + obstacle.radius);
  const bool below = obstacle.surface->nearestHit(back(middle), down, deep) < deep;
  return below && !hides(obstacle, eye, {middle});
}

}  // namespace

float hiddenShare(const Obstacle& obstacle, const Vec3& eye, std::span<const Actor> actors) {
  if (actors.empty()) return 0.0F;
  const std::size_t step = (actors.size() + kMostAsked - 1) / kMostAsked;
  std::size_t asked = 0;
  std::size_t hidden = 0;
  for (std::size_t i = 0; i < actors.size(); i += step) {
    ++asked;
    if (hides(obstacle, eye, actors[i])) ++hidden;
  }
  return static_cast<float>(hidden) / static_cast<float>(asked);
}

void Cutaway::update(const Vec3& eye, std::span<const Actor> actors, std::span<const Obstacle> obstacles,
                     float seconds) {
  const float fade = std::max(0.0F, seconds) / kFadeSeconds;
  const Vec3 middle = middleOf(actors);
  const float wallRadius = kWallSize * extentOf(actors).value_or(Ball{}).radius;
  for (const Obstacle& obstacle : obstacles) {
    const float hidden = isFloor(obstacle, eye, middle) ? 0.0F : hiddenShare(obstacle, eye, actors);
    const float enough = obstacle.radius >= wallRadius ? kWallHides : kHidesMuch;
    bool& cut = cut_[obstacle.body];
    cut = hidden >= enough || (cut && hidden > kHidesNothing);
    const float aim = cut ? 1.0F : 0.0F;
    const auto [share, isNew] = shares_.emplace(obstacle.body, aim);
    if (!isNew) share->second += std::clamp(aim - share->second, -fade, fade);
  }
}

float Cutaway::share(BodyId body) const {
  const auto found = shares_.find(body);
  return found == shares_.end() ? 0.0F : found->second;
}

float Cutaway::depthBehind(const Ray& ray, std::span<const Obstacle> obstacles) const {
  float depth = 0.0F;
  for (const Obstacle& obstacle : obstacles) {
    if (share(obstacle.body) < kGone) continue;
    // Seen from the other end, its last surface is its first.
    const float length = glm::distance(ray.origin, obstacle.pose.position) + 2.0F * obstacle.radius;
    const Transform back = obstacle.pose.inverse();
    const Vec3 from = back(ray.origin + length * ray.direction);
    const float hit = obstacle.surface->nearestHit(from, back.rotation * -ray.direction, length);
    depth = std::max(depth, length - hit);
  }
  return depth;
}

}  // namespace scatter::viewer
