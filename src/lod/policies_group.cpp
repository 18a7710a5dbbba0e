#include "lod/policies_group.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "lod/approach.h"

namespace scatter::lod {
namespace {

/// In thresholds: where a group that was over the threshold is taken to be under it again.
constexpr float kStayOver = 0.8F;

/// A group is not expected to shrink below this share of its radius.
constexpr float kSmallestShare = 0.5F;

constexpr float kUnitBallVolume = 4.0F / 3.0F * 3.14159265F;

std::shared_ptr<Grouping> orNew(std::shared_ptr<Grouping> grouping) {
  return grouping ? std::move(grouping) : std::make_shared<Grouping>();
}

}  // namespace

GroupPolicy::GroupPolicy(const GroupEffect& effect, std::shared_ptr<Grouping> grouping)
    : effect_(effect), grouping_(orNew(std::move(grouping))) {}

void GroupPolicy::observe(const Situation& situation) {
  grouping_->observe(situation);
  if (generation_ == grouping_->generation()) return;
  generation_ = grouping_->generation();
  prepare(situation);

  groupIsOver_.clear();
  for (const Group& group : grouping_->groups()) {
    const float threshold = wasMostlyOver(group) ? kStayOver : 1.0F;
    const bool isLarge = group.count >= static_cast<std::uint32_t>(effect_.members);
    groupIsOver_.push_back(isLarge && measure(situation, group) > threshold ? 1 : 0);
  }
  bodyWasOver_.assign(situation.bodies.size(), 0);
  for (std::size_t i = 0; i < groupIsOver_.size(); ++i) {
    for (const std::uint32_t member : grouping_->members(grouping_->groups()[i])) {
      bodyWasOver_[member] = groupIsOver_[i];
    }
  }
}

bool GroupPolicy::wasMostlyOver(const Group& group) const {
  std::uint32_t over = 0;
  for (const std::uint32_t member : grouping_->members(group)) {
    if (member < bodyWasOver_.size()) over += bodyWasOver_[member];
  }
  return 2 * over > group.count;
}

void GroupPolicy::advise(const Situation& /*situation*/, const PairView& pair, Wish& wish) const {
  const std::uint32_t group = grouping_->groupOf(pair);
  if (group >= groupIsOver_.size() || groupIsOver_[group] == 0) return;
  wish.scale(effect_.importance);
  if (effect_.level > 0) wish.request(effect_.level);
}

float GroupRangePolicy::measure(const Situation& /*situation*/, const Group& group) const {
  const float shrunk = group.reach - def_.ahead * std::max(group.approach, 0.0F);
  const float reach = std::max(shrunk, kSmallestShare * group.reach);
  const float space = kUnitBallVolume * reach * reach * reach;
  if (!(space > 0.0F)) return 0.0F;
  float measured = 0.0F;
  if (def_.packing > 0.0F) measured = group.volume / space / def_.packing;
  if (def_.objects > 0.0F) {
    measured = std::max(measured, static_cast<float>(group.count) / space / def_.objects);
  }
  return measured;
}

void GroupSharePolicy::prepare(const Situation& situation) {
  approaches_.assign(situation.bodies.size(), 0);
  for (const PairView& pair : situation.pairs) {
    if (pair.touching) continue;
    if (approachSpeed(situation.bodies[pair.a], situation.bodies[pair.b]) <= def_.approach) continue;
    approaches_[pair.a] = 1;
    approaches_[pair.b] = 1;
  }
}

float GroupSharePolicy::measure(const Situation& situation, const Group& group) const {
  std::uint32_t over = 0;
  for (const std::uint32_t member : grouping().members(group)) {
    const bool isFast = glm::length(situation.bodies[member].velocity - group.velocity) > def_.speed;
    if (isFast || approaches_[member] != 0) ++over;
  }
  return static_cast<float>(over) / static_cast<float>(group.count) / def_.share;
}

void GroupDensityPolicy::observe(const Situation& situation) {
  const bool isFresh = !neighbours_.empty() && situation.step - step_ < Grouping::kInterval;
  if (isFresh) return;
  step_ = situation.step;
  neighbours_.assign(situation.bodies.size(), 0);
  const auto add = [this](std::uint32_t body) {
    if (neighbours_[body] < std::numeric_limits<std::uint16_t>::max()) ++neighbours_[body];
  };
  for (const PairView& pair : situation.pairs) {
    if (!pair.touching) continue;
    const float a = situation.bodies[pair.a].radius;
    const float b = situation.bodies[pair.b].radius;
    if (std::max(a, b) > def_.alike * std::min(a, b)) continue;
    add(pair.a);
    add(pair.b);
  }
}

int GroupDensityPolicy::neighboursOf(std::uint32_t body) const {
  return body < neighbours_.size() ? neighbours_[body] : 0;
}

void GroupDensityPolicy::advise(const Situation& /*situation*/, const PairView& pair, Wish& wish) const {
  const int count = std::min(neighboursOf(pair.a), neighboursOf(pair.b));
  if (count <= def_.from) return;
  const float share =
      static_cast<float>(std::min(count, def_.to) - def_.from) / static_cast<float>(def_.to - def_.from);
  wish.scale(1.0F - (1.0F - def_.least) * share);
}

}  // namespace scatter::lod
