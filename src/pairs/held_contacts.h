#pragma once

#include <array>
#include <span>
#include <vector>

#include "pairs/pair_engine.h"

namespace scatter::pairs {

/// Memory for HeldContacts::gather(), used in turn.
struct HeldScratch {
  struct Candidate {
    void* manifold = nullptr;
    int index = 0;
    ContactPoint point{};
    float difference = 0.0F;  ///< From those that were chosen.
  };
  std::vector<Candidate> candidates{};
  std::vector<Candidate> replaced{};
};

/// The contacts of a pair as they were last found at its finest level, kept while it is on credit at a
/// coarser one: a few for all child pairs together. Owns its manifolds as long as they are not released.
class HeldContacts {
 public:
  /// Takes over the contacts of child pairs: the deepest, and those that differ most from it and from each
  /// other in place and direction. Those that were held before stay as long as nothing like them is found.
  /// What the contacts that are left out or replaced bore is borne by those like them. `threshold`: contacts
  /// nearer to each other than this are the same, metres.
  void gather(std::span<const ChildPair> children, float threshold, PairEngine& engine, HeldScratch& scratch);

  /// Takes in where the bodies are: contacts that have come apart end.
  void refresh(const PairEngine& engine) const;

  /// Gives the contacts back to the child pairs of the finest level that they were found for, as far as those
  /// are still neighbours, and holds none any more. `children` are in ascending order.
  void giveBack(std::span<ChildPair> children, PairEngine& engine);

  void release(PairEngine& engine);

  [[nodiscard]] bool empty() const { return count_ == 0; }
  [[nodiscard]] std::span<void* const> manifolds() const { return {manifolds_.data(), count_}; }
  [[nodiscard]] int countPoints(const PairEngine& engine) const;

  /// Of the nearest contact; kNone if there is none.
  [[nodiscard]] float leastDistance(const PairEngine& engine) const;
  static constexpr float kNone = ContactTally::kFar;

 private:
  static constexpr std::size_t kMostManifolds = 3;  ///< With two, towers sway.

  void collect(std::span<const ChildPair> children, const PairEngine& engine, HeldScratch& scratch) const;
  void collectOld(float threshold, const PairEngine& engine, HeldScratch& scratch) const;
  [[nodiscard]] bool isFull(const PairEngine& engine) const;
  void add(const HeldScratch::Candidate& candidate, PairEngine& engine);
  void inherit(const HeldScratch::Candidate& from, PairEngine& engine) const;

  std::array<void*, kMostManifolds> manifolds_{};
  std::size_t count_ = 0;
};

}  // namespace scatter::pairs
