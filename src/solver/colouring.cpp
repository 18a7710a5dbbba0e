#include "solver/colouring.h"

#include <algorithm>
#include <bit>

namespace scatter::solver {

void Colouring::colour(const ContactProblem& problem) {
  taken_.assign(problem.bodies.size(), 0);
  for (std::vector<int>& pairs : byColour_) pairs.clear();
  batches_.clear();
  colours_ = 0;
  for (std::size_t i = 0; i < problem.pairs.size(); ++i) {
    byColour_[static_cast<std::size_t>(take(problem.pairs[i], problem))].push_back(static_cast<int>(i));
  }
  for (int colour = 0; colour < kColours; ++colour) {
    std::vector<int>& pairs = byColour_[static_cast<std::size_t>(colour)];
    if (pairs.empty()) continue;
    ++colours_;
    fill(pairs, problem, colour == kColours - 1 ? 1 : kLanes);
  }
}

int Colouring::take(const ContactPair& pair, const ContactProblem& problem) {
  const auto a = static_cast<std::size_t>(pair.a);
  const auto b = static_cast<std::size_t>(pair.b);
  const bool bMoves = problem.bodies[b].moves;
  const std::uint64_t taken = taken_[a] | (bMoves ? taken_[b] : 0);
  const int colour = std::min(std::countr_one(taken), kColours - 1);
  if (colour == kColours - 1) return colour;
  taken_[a] |= std::uint64_t{1} << colour;
  if (bMoves) taken_[b] |= std::uint64_t{1} << colour;
  return colour;
}

// Those of two moving bodies apart from the others, and those of as many contacts together: few lanes idle.
void Colouring::fill(std::vector<int>& pairs, const ContactProblem& problem, int lanes) {
  const auto pairOf = [&](int i) -> const ContactPair& { return problem.pairs[static_cast<std::size_t>(i)]; };
  const auto bothMove = [&](int i) { return problem.bodies[static_cast<std::size_t>(pairOf(i).b)].moves; };
  std::stable_sort(pairs.begin(), pairs.end(), [&](int i, int k) {
    if (bothMove(i) != bothMove(k)) return bothMove(i);
    return pairOf(i).count > pairOf(k).count;
  });
  for (std::size_t i = 0; i < pairs.size();) {
    PairBatch batch;
    batch.pairs.fill(PairBatch::kNoPair);
    batch.rows = pairOf(pairs[i]).count;
    batch.bothMove = bothMove(pairs[i]);
    for (int lane = 0; lane < lanes && i < pairs.size() && bothMove(pairs[i]) == batch.bothMove; ++lane, ++i)
      batch.pairs[static_cast<std::size_t>(lane)] = pairs[i];
    batches_.push_back(batch);
  }
}

}  // namespace scatter::solver
