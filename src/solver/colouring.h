#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/contact_problem.h"

namespace scatter::solver {

/// Pairs whose contacts are solved at once, a pair a lane: no two of them have a moving body in common.
struct PairBatch {
  static constexpr int kNoPair = -1;

  std::array<int, kLanes> pairs{};  ///< kNoPair where there is none; the first is always one.
  int rows = 0;                     ///< Contacts of the pair that has the most.
  bool bothMove = false;            ///< Else no body b does.
};

/// Puts pairs into batches: greedy colours, in the order of the pairs, so that it is the same whatever the
/// number of threads. Pairs of one colour have no moving body in common. Those of a colour that fill no batch
/// share one with pairs of other colours. A body that has more neighbours than there are colours is solved a
/// pair at a time.
class Colouring {
 public:
  void colour(const ContactProblem& problem);

  /// In the order in which they are to be solved.
  [[nodiscard]] std::span<const PairBatch> batches() const { return batches_; }
  [[nodiscard]] int colours() const { return colours_; }

 private:
  static constexpr int kColours = 64;  ///< Bits of a mask. The last is for pairs that have found no other.

  [[nodiscard]] int take(const ContactPair& pair, const ContactProblem& problem);
  void sort(std::vector<int>& pairs, const ContactProblem& problem);
  void fill(std::vector<int>& pairs, const ContactProblem& problem);
  void addBatch(std::span<const int> pairs, const ContactProblem& problem);
  void fit(const ContactProblem& problem);
  [[nodiscard]] bool hasRoom(const PairBatch& batch, int pair, const ContactProblem& problem) const;

  std::vector<std::uint64_t> taken_;  ///< A bit for each colour that a body has.
  std::array<std::vector<int>, kColours> byColour_;
  std::vector<int> left_;            ///< Pairs that fill no batch of their colour.
  std::vector<std::uint64_t> keys_;  ///< Of pairs, in the order in which these are sorted.
  std::vector<PairBatch> batches_;
  int colours_ = 0;
};

}  // namespace scatter::solver
