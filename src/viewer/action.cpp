#include "viewer/action.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

namespace scatter::viewer {
namespace {

constexpr float kAsleepWeight = 0.2F;
constexpr float kBystanderWeight = 0.02F;  // of what meets nothing, while others meet
constexpr float kFewMeet = 0.02F;          // share of the bodies that may meet by chance
constexpr float kManyMeet = 0.10F;         // share of the bodies whose meeting is what happens
constexpr float kShown = 0.85F;            // share of the weight that is in the picture
constexpr float kAll = 0.9F;
constexpr float kMostBodyRadii = 22.0F;  // a ball of more body radii shows specks
constexpr float kLeastBodyRadii = 2.5F;  // a ball of fewer shows too little around a body

constexpr float kMoves = 0.005F;      // metres in a frame
constexpr float kFewMove = 0.2F;      // share of the bodies that stands out if only they move,
constexpr float kMoversShare = 0.4F;  // and their share of all weight then
constexpr float kNearMost = 0.7F;     // by the largest ball, the distance of movers that count

/// A number and how much it counts.
using Weighted = std::pair<float, float>;

/// The least of the numbers that has this share of all weight at or below it.
float quantile(std::vector<Weighted>& numbers, float share) {
  std::sort(numbers.begin(), numbers.end());
  const float all = std::accumulate(numbers.begin(), numbers.end(), 0.0F,
                                    [](float sum, const Weighted& one) { return sum + one.second; });
  float below = 0.0F;
  for (const auto& [number, weight] : numbers) {
    below += weight;
    if (below >= share * all) return number;
  }
  return numbers.back().first;
}

Vec3 medianPlace(std::span<const Actor> actors, const std::vector<float>& weights) {
  Vec3 place(0.0F);
  std::vector<Weighted> along(actors.size());
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < actors.size(); ++i) along[i] = {actors[i].position[axis], weights[i]};
    place[axis] = quantile(along, 0.5F);
  }
  return place;
}

float reachAround(const Vec3& center, std::span<const Actor> actors, const std::vector<float>& weights,
                  float share) {
  std::vector<Weighted> reach(actors.size());
  for (std::size_t i = 0; i < actors.size(); ++i)
    reach[i] = {glm::distance(center, actors[i].position) + actors[i].radius, weights[i]};
  return quantile(reach, share);
}

/// A median does not mind stragglers; the mean of those around it moves smoothly when they do.
Ball ballAround(std::span<const Actor> actors, const std::vector<float>& weights, float share) {
  const Vec3 middle = medianPlace(actors, weights);
  const float around = reachAround(middle, actors, weights, share);
  Vec3 sum(0.0F);
  float all = 0.0F;
  for (std::size_t i = 0; i < actors.size(); ++i) {
    if (glm::distance(middle, actors[i].position) + actors[i].radius > around) continue;
    sum += weights[i] * actors[i].position;
    all += weights[i];
  }
  const Vec3 center = all > 0.0F ? sum / all : middle;
  return {center, reachAround(center, actors, weights, share)};
}

float typicalRadius(std::span<const Actor> actors) {
  std::vector<Weighted> radii;
  for (const Actor& actor : actors) radii.emplace_back(actor.radius, 1.0F);
  return quantile(radii, 0.5F);
}

std::vector<float> weightsOf(std::span<const Actor> actors) {
  const float bystander = glm::mix(1.0F, kBystanderWeight, crowding(actors));
  std::vector<float> weights;
  weights.reserve(actors.size());
  for (const Actor& actor : actors)
    weights.push_back((actor.asleep ? kAsleepWeight : 1.0F) * (actor.meeting ? 1.0F : bystander));
  return weights;
}

/// Few that move among many that rest are what happens, unless they have left the others behind.
void raiseMovers(std::span<const Actor> actors, std::vector<float>& weights) {
  const Vec3 middle = middleOf(actors);
  const float reach = kNearMost * kMostBodyRadii * typicalRadius(actors);
  std::vector<std::size_t> movers;
  float moving = 0.0F;
  float all = 0.0F;
  std::size_t count = 0;
  for (std::size_t i = 0; i < actors.size(); ++i) {
    all += weights[i];
    if (actors[i].moved < kMoves) continue;
    ++count;
    if (glm::distance(actors[i].position, middle) > reach) continue;
    movers.push_back(i);
    moving += weights[i];
  }
  const bool few = static_cast<float>(count) <= kFewMove * static_cast<float>(actors.size());
  if (movers.empty() || !few) return;
  const float wanted = kMoversShare / (1.0F - kMoversShare) * (all - moving);
  if (wanted <= moving) return;
  for (const std::size_t i : movers) weights[i] *= wanted / moving;
}

}  // namespace

void markMeetings(std::span<Actor> actors) {
  std::vector<std::size_t> order(actors.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto left = [&](std::size_t i) { return actors[i].position.x - actors[i].radius; };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return left(a) < left(b); });
  for (Actor& actor : actors) actor.meeting = false;
  for (std::size_t i = 0; i < order.size(); ++i) {
    Actor& one = actors[order[i]];
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      Actor& other = actors[order[j]];
      if (left(order[j]) > one.position.x + one.radius) break;
      const float reach = one.radius + other.radius;
      const Vec3 apart = one.position - other.position;
      if (glm::dot(apart, apart) <= reach * reach) one.meeting = other.meeting = true;
    }
  }
}

std::optional<Ball> findAction(std::span<const Actor> actors) {
  if (actors.empty()) return std::nullopt;
  std::vector<float> weights = weightsOf(actors);
  raiseMovers(actors, weights);
  Ball ball = ballAround(actors, weights, kShown);
  const float typical = typicalRadius(actors);
  ball.radius = std::clamp(ball.radius, kLeastBodyRadii * typical, kMostBodyRadii * typical);
  return ball;
}

float crowding(std::span<const Actor> actors) {
  if (actors.empty()) return 0.0F;
  const auto meeting = std::count_if(actors.begin(), actors.end(), [](const Actor& a) { return a.meeting; });
  const float share = static_cast<float>(meeting) / static_cast<float>(actors.size());
  return glm::smoothstep(kFewMeet, kManyMeet, share);
}

Vec3 middleOf(std::span<const Actor> actors) {
  if (actors.empty()) return Vec3(0.0F);
  return medianPlace(actors, std::vector<float>(actors.size(), 1.0F));
}

std::optional<Ball> extentOf(std::span<const Actor> actors) {
  if (actors.empty()) return std::nullopt;
  return ballAround(actors, std::vector<float>(actors.size(), 1.0F), kAll);
}

}  // namespace scatter::viewer
