#include "lod/grouping.h"

#include <algorithm>
#include <cassert>
#include <glm/vec3.hpp>
#include <numeric>
#include <utility>

#include "graph/union_find.h"

namespace scatter::lod {
namespace {

constexpr double kBallVolume = 4.0 / 3.0 * 3.14159265358979323846;

/// Whether a pair makes one group of its bodies.
bool connects(const Situation& situation, const PairView& pair) {
  const BodyView& a = situation.bodies[pair.a];
  const BodyView& b = situation.bodies[pair.b];
  if (!(a.mass > 0.0F && b.mass > 0.0F)) return false;
  if (pair.touching) return true;
  const Vec3 offset = b.center - a.center;
  const float reach = a.radius + b.radius;
  return glm::dot(offset, offset) < reach * reach;
}

}  // namespace

void Grouping::observe(const Situation& situation) {
  // A step before the last one seen, of another run, gives a huge difference.
  const bool isFresh = generation_ > 0 && situation.step - step_ < kInterval;
  if (isFresh) return;
  ++generation_;
  step_ = situation.step;
  connect(situation);
  number(situation.bodies.size());
  for (Group& group : groups_) measure(situation, group);
}

std::uint32_t Grouping::groupOf(const PairView& pair) const {
  const std::uint32_t a = groupOf(pair.a);
  const std::uint32_t b = groupOf(pair.b);
  if (a == b || b == kNone) return a;
  return a == kNone ? b : kNone;
}

void Grouping::connect(const Situation& situation) {
  parent_.resize(situation.bodies.size());
  std::iota(parent_.begin(), parent_.end(), 0U);
  for (const PairView& pair : situation.pairs) {
    assert(pair.a < parent_.size() && pair.b < parent_.size());
    if (!connects(situation, pair)) continue;
    const auto [low, high] = std::minmax({graph::rootOf(parent_, pair.a), graph::rootOf(parent_, pair.b)});
    parent_[high] = low;
  }
}

// A root comes before the other members of its group.
void Grouping::number(std::size_t bodies) {
  constexpr std::uint32_t kHasCompany = 0;
  groups_.clear();
  groupOf_.assign(bodies, kNone);
  for (std::uint32_t body = 0; body < bodies; ++body) {
    if (const std::uint32_t root = graph::rootOf(parent_, body); root != body) groupOf_[root] = kHasCompany;
  }
  for (std::uint32_t body = 0; body < bodies; ++body) {
    const std::uint32_t root = graph::rootOf(parent_, body);
    if (root == body && groupOf_[body] == kNone) continue;
    if (root == body) {
      groupOf_[body] = static_cast<std::uint32_t>(groups_.size());
      groups_.emplace_back();
    } else {
      groupOf_[body] = groupOf_[root];
    }
    ++groups_[groupOf_[body]].count;
  }
  listMembers();
}

// A counting sort by group.
void Grouping::listMembers() {
  std::uint32_t total = 0;
  for (Group& group : groups_) {
    group.first = total;
    total += std::exchange(group.count, 0U);
  }
  members_.resize(total);
  for (std::uint32_t body = 0; body < groupOf_.size(); ++body) {
    if (groupOf_[body] == kNone) continue;
    Group& group = groups_[groupOf_[body]];
    members_[group.first + group.count++] = body;
  }
}

void Grouping::measure(const Situation& situation, Group& group) const {
  glm::dvec3 center(0.0);
  glm::dvec3 velocity(0.0);
  double cubes = 0.0;
  for (const std::uint32_t member : members(group)) {
    const BodyView& body = situation.bodies[member];
    center += glm::dvec3(body.center);
    velocity += glm::dvec3(body.velocity);
    const auto radius = static_cast<double>(body.radius);
    cubes += radius * radius * radius;
  }
  group.center = Vec3(center / static_cast<double>(group.count));
  group.velocity = Vec3(velocity / static_cast<double>(group.count));
  group.volume = static_cast<float>(kBallVolume * cubes);

  double approach = 0.0;
  for (const std::uint32_t member : members(group)) {
    const BodyView& body = situation.bodies[member];
    const Vec3 outward = body.center - group.center;
    const float distance = glm::length(outward);
    group.range = std::max(group.range, distance);
    group.reach = std::max(group.reach, distance + body.radius);
    if (distance > 0.0F) {
      approach -= static_cast<double>(glm::dot(body.velocity - group.velocity, outward) / distance);
    }
  }
  group.approach = static_cast<float>(approach / static_cast<double>(group.count));
}

}  // namespace scatter::lod
