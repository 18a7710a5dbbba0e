#include "solver/colouring.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "../trials.h"

namespace scatter::solver {
namespace {

ContactProblem randomPairs(std::uint64_t seed) {
  std::mt19937 engine(static_cast<std::mt19937::result_type>(seed));
  const auto below = [&](std::size_t n) { return static_cast<int>(engine() % n); };
  ContactProblem problem;
  problem.bodies.resize(2 + engine() % 60);
  for (ContactBody& body : problem.bodies) body.moves = below(5) > 0;
  problem.bodies[0].moves = true;
  std::set<std::pair<int, int>> known;
  for (int i = below(400); i > 0; --i) {
    int a = below(problem.bodies.size());
    int b = below(problem.bodies.size());
    if (!problem.bodies[static_cast<std::size_t>(a)].moves) std::swap(a, b);
    const bool isNew =
        a != b && problem.bodies[static_cast<std::size_t>(a)].moves && known.insert(std::minmax(a, b)).second;
    if (isNew) problem.pairs.push_back({a, b, 0, 1 + below(30)});
  }
  return problem;
}

ContactProblem star(int neighbours) {
  ContactProblem problem;
  problem.bodies.resize(static_cast<std::size_t>(neighbours) + 1);
  for (ContactBody& body : problem.bodies) body.moves = true;
  for (int i = 1; i <= neighbours; ++i) problem.pairs.push_back({0, i, 0, 1});
  return problem;
}

std::vector<int> pairsOf(const PairBatch& batch) {
  std::vector<int> pairs(batch.pairs.begin(), batch.pairs.end());
  std::erase(pairs, PairBatch::kNoPair);
  return pairs;
}

void expectNoMovingBodyTwice(const ContactProblem& problem, const PairBatch& batch) {
  std::multiset<int> moving;
  for (const int i : pairsOf(batch)) {
    const ContactPair& pair = problem.pairs[static_cast<std::size_t>(i)];
    moving.insert(pair.a);
    const bool bMoves = problem.bodies[static_cast<std::size_t>(pair.b)].moves;
    if (bMoves) moving.insert(pair.b);
    EXPECT_EQ(bMoves, batch.bothMove);
    EXPECT_LE(pair.count, batch.rows);
  }
  for (const int body : moving) EXPECT_EQ(moving.count(body), 1U) << "body " << body;
}

class ColouringSeeds : public testing::TestWithParam<std::uint64_t> {};

TEST_P(ColouringSeeds, HaveEveryPairOnceAndNoMovingBodyTwiceInABatch) {
  const ContactProblem problem = randomPairs(GetParam());
  Colouring colouring;
  colouring.colour(problem);
  std::vector<int> found;
  for (const PairBatch& batch : colouring.batches()) {
    const std::vector<int> pairs = pairsOf(batch);
    ASSERT_FALSE(pairs.empty());
    EXPECT_NE(batch.pairs[0], PairBatch::kNoPair);
    found.insert(found.end(), pairs.begin(), pairs.end());
    expectNoMovingBodyTwice(problem, batch);
  }
  std::sort(found.begin(), found.end());
  std::vector<int> all(problem.pairs.size());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(found, all);
}

INSTANTIATE_TEST_SUITE_P(Random, ColouringSeeds, testing::ValuesIn(test::seeds(1, 200)));

TEST(Colouring, NeedsAsManyColoursAsTheBusiestBodyHasNeighbours) {
  Colouring colouring;
  colouring.colour(star(20));
  EXPECT_EQ(colouring.colours(), 20);
  EXPECT_EQ(colouring.batches().size(), 20U);
}

TEST(Colouring, SolvesPairsOfABodyWithTooManyNeighboursOneByOne) {
  Colouring colouring;
  colouring.colour(star(100));
  EXPECT_EQ(colouring.colours(), 64);
  EXPECT_EQ(colouring.batches().size(), 100U);
}

TEST(Colouring, TakesPairsWithAFixedBodyTogether) {
  ContactProblem problem;
  problem.bodies.resize(9);
  for (std::size_t i = 1; i < 9; ++i) {
    problem.bodies[i].moves = true;
    problem.pairs.push_back({static_cast<int>(i), 0, 0, 1});
  }
  Colouring colouring;
  colouring.colour(problem);
  EXPECT_EQ(colouring.colours(), 1);
  EXPECT_EQ(colouring.batches().size(), 2U);
}

}  // namespace
}  // namespace scatter::solver
