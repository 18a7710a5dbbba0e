#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace scatter::lod {

/// Penetration credit of one pair of bodies. When a pair in contact changes its level, the new shapes overlap
/// where the old ones did not. Each child pair (a part of A and a part of B) keeps that overlap as credit,
/// which is added to the distance of its contacts: the constraint is exactly satisfied at the switch, and
/// nothing is pushed.
///
/// For this to hold:
/// - The depth of an overlap comes from a continuous function of the bodies' places, never from contact
/// points,
///   which flicker.
/// - Credit is the depth plus the gap that the finest shapes still have, so that the gap goes on closing as
/// it did. Finest shapes that overlap have no gap: how deep they do is the business of the contacts held for
/// them, and is no reason to press coarser shapes apart somewhere else.
/// - Credit shrinks with the depth, so that shapes that have come apart touch as usual from then on.
class CreditAccount {
 public:
  struct Entry {
    std::uint16_t a;
    std::uint16_t b;
    float credit;  ///< Metres to add to the distance of this child pair's contacts.
    float gap;     ///< What the finest shapes still have between them; 0 once it has closed.
  };

  void close() { entries_.clear(); }

  /// Grants a child pair that overlaps by `depth` > 0 what it needs. `gap`: between the finest shapes;
  /// negative if they overlap, which counts as none.
  void grant(std::uint16_t a, std::uint16_t b, float depth, float gap) {
    const float open = std::max(gap, 0.0F);
    entries_.push_back({a, b, depth + open, open});
  }

  /// Takes in how deep the child pairs are now: `depthOf(a, b)`, 0 if they do not overlap.
  template <class DepthOf>
  void shrink(DepthOf&& depthOf) {
    // So near to having closed that it will not open again.
    constexpr float kClosed = 0.01F;
    std::erase_if(entries_, [&](Entry& entry) {
      const float depth = depthOf(entry.a, entry.b);
      entry.credit = std::min(entry.credit, depth + entry.gap);
      if (entry.gap > 0.0F && entry.credit - depth < kClosed) entry.gap = 0.0F;
      return depth <= 0.0F;
    });
  }

  /// After the gap between the finest shapes was measured: what the contacts add up to from now on.
  template <class DepthOf>
  void audit(float gap, DepthOf&& depthOf) {
    std::erase_if(entries_, [&](Entry& entry) {
      const float depth = depthOf(entry.a, entry.b);
      entry.gap = std::max(gap, 0.0F);
      entry.credit = depth + entry.gap;
      return depth <= 0.0F;
    });
  }

  [[nodiscard]] float of(std::uint16_t a, std::uint16_t b) const {
    for (const Entry& entry : entries_) {
      if (entry.a == a && entry.b == b) return entry.credit;
    }
    return 0.0F;
  }

  [[nodiscard]] bool empty() const { return entries_.empty(); }
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }

 private:
  std::vector<Entry> entries_;
};

}  // namespace scatter::lod
