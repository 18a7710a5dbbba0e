#include "lod/policy_list.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace scatter::lod {
namespace {

/// Not a number counts as the least.
float bounded(float importance) {
  if (!(importance > PolicyList::kLeastImportance)) return PolicyList::kLeastImportance;
  return std::min(importance, PolicyList::kMostImportance);
}

}  // namespace

void PolicyList::add(std::unique_ptr<Policy> policy) {
  assert(policy != nullptr);
  assert(policies_.size() < kMost);
  policies_.push_back(std::move(policy));
}

void PolicyList::observe(const Situation& situation) {
  for (const auto& policy : policies_) policy->observe(situation);
}

Wish PolicyList::advise(const Situation& situation, const PairView& pair) const {
  Wish all;
  for (std::size_t i = 0; i < policies_.size(); ++i) {
    Wish own;
    policies_[i]->advise(situation, pair, own);
    all.scale(own.importance);
    if (own.atMost < all.atMost) {
      all.request(own.atMost);
      all.askedBy = static_cast<std::uint8_t>(i);
    }
    all.promise(own.atLeast);
  }
  all.importance = bounded(all.importance);
  all.atLeast = std::min(all.atLeast, std::max<std::uint8_t>(pair.finest, 1));
  all.atMost = std::max(all.atMost, all.atLeast);
  return all;
}

}  // namespace scatter::lod
