#include "solver/colouring.h"

#include <algorithm>
#include <bit>

namespace scatter::solver {

namespace {

bool bothMove(int pair, const ContactProblem& problem) {
  return problem.bodies[static_cast<std::size_t>(problem.pairs[static_cast<std::size_t>(pair)].b)].moves;
}

}  // namespace

void Colouring::colour(const ContactProblem& problem) {
  taken_.assign(problem.bodies.size(), 0);
  for (std::vector<int>& pairs : byColour_) pairs.clear();
  batches_.clear();
  colours_ = 0;
  for (std::size_t i = 0; i < problem.pairs.size(); ++i) {
    byColour_[static_cast<std::size_t>(take(problem.pairs[i], problem))].push_back(static_cast<int>(i));
  }
  for (std::vector<int>& pairs : byColour_) {
    if (pairs.empty()) continue;
    ++colours_;
    if (&pairs != &byColour_.back()) fill(pairs, problem);
  }
  fit(problem);
  for (const int pair : byColour_.back()) addBatch(std::span(&pair, 1), problem);
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
// Among these in the order of their indices.
void Colouring::sort(std::vector<int>& pairs, const ContactProblem& problem) {
  constexpr std::uint64_t kOneMoves = std::uint64_t{1} << 63U;
  constexpr std::uint32_t kMostContacts = 0x7FFFFFFFU;
  keys_.clear();
  for (const int i : pairs) {
    const auto count = static_cast<std::uint32_t>(problem.pairs[static_cast<std::size_t>(i)].count);
    const std::uint64_t most = bothMove(i, problem) ? 0 : kOneMoves;
    keys_.push_back(most | std::uint64_t{kMostContacts - count} << 32U | static_cast<std::uint32_t>(i));
  }
  std::sort(keys_.begin(), keys_.end());
  std::ranges::transform(keys_, pairs.begin(), [](std::uint64_t key) { return static_cast<int>(key); });
}

void Colouring::fill(std::vector<int>& pairs, const ContactProblem& problem) {
  sort(pairs, problem);
  const std::span<const int> all = pairs;
  for (std::size_t i = 0; i < all.size();) {
    std::size_t end = i + 1;
    while (end < all.size() && end < i + kLanes && bothMove(all[end], problem) == bothMove(all[i], problem))
      ++end;
    const auto batch = all.subspan(i, end - i);
    if (batch.size() == kLanes) {
      addBatch(batch, problem);
    } else {
      left_.insert(left_.end(), batch.begin(), batch.end());
    }
    i = end;
  }
}

void Colouring::addBatch(std::span<const int> pairs, const ContactProblem& problem) {
  PairBatch batch;
  batch.pairs.fill(PairBatch::kNoPair);
  std::ranges::copy(pairs, batch.pairs.begin());
  batch.rows = problem.pairs[static_cast<std::size_t>(pairs.front())].count;
  batch.bothMove = bothMove(pairs.front(), problem);
  batches_.push_back(batch);
}

// Each goes into the first batch that it shares no moving body with.
void Colouring::fit(const ContactProblem& problem) {
  sort(left_, problem);
  const std::size_t first = batches_.size();
  for (const int pair : left_) {
    std::size_t i = first;
    while (i < batches_.size() && !hasRoom(batches_[i], pair, problem)) ++i;
    if (i == batches_.size()) {
      addBatch(std::span(&pair, 1), problem);
    } else {
      *std::ranges::find(batches_[i].pairs, PairBatch::kNoPair) = pair;
    }
  }
  left_.clear();
}

bool Colouring::hasRoom(const PairBatch& batch, int pair, const ContactProblem& problem) const {
  if (batch.pairs.back() != PairBatch::kNoPair || batch.bothMove != bothMove(pair, problem)) return false;
  const ContactPair& one = problem.pairs[static_cast<std::size_t>(pair)];
  return std::ranges::none_of(batch.pairs, [&](int i) {
    if (i == PairBatch::kNoPair) return false;
    const ContactPair& other = problem.pairs[static_cast<std::size_t>(i)];
    const bool sharesB = batch.bothMove && (one.b == other.b || one.a == other.b || one.b == other.a);
    return one.a == other.a || sharesB;
  });
}

}  // namespace scatter::solver
