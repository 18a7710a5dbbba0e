#include "collision/neighbour_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "collision/geometry.h"
#include "collision/reference_distance.h"
#include "trials.h"

namespace scatter {
namespace {

using testing::anyInt;
using testing::anySize;
using testing::placed;
using testing::Random;
using testing::randomFrame;
using testing::randomParts;
using testing::referenceDistance;

using IndexPair = std::pair<int, int>;

void expectAscendingAndOnce(const std::vector<Neighbours>& found) {
  for (std::size_t i = 1; i < found.size(); ++i) {
    const IndexPair before(found[i - 1].a, found[i - 1].b);
    EXPECT_LT(before, IndexPair(found[i].a, found[i].b));
  }
}

bool contains(const std::vector<Neighbours>& found, int a, int b) {
  return std::any_of(found.begin(), found.end(), [&](const Neighbours& n) { return n.a == a && n.b == b; });
}

/// Of the parts as they meet others: a box by its sharp corners.
const PolytopeView& outline(const PartList::Part& part) {
  return part.kind == PartKind::kBox ? part.sharp : part.core;
}

double outlineMargin(const PartList::Part& part) {
  return part.kind == PartKind::kBox ? 0.0 : static_cast<double>(part.margin);
}

double distanceOf(const PartList::Part& a, const PartList::Part& b, const Frame& frameB) {
  const auto truth = referenceDistance(placed(Frame{}, outline(a)), placed(frameB, outline(b)));
  return truth.upper - outlineMargin(a) - outlineMargin(b);
}

/// How far B's part lies beyond A's along the axis, in double precision.
double gapAlong(const PartList::Part& a, const PartList::Part& b, const Frame& frameB,
                const glm::dvec3& axis) {
  double highest = std::numeric_limits<double>::lowest();
  double lowest = std::numeric_limits<double>::max();
  for (const auto& p : placed(Frame{}, outline(a))) highest = std::max(highest, glm::dot(p, axis));
  for (const auto& p : placed(frameB, outline(b))) lowest = std::min(lowest, glm::dot(p, axis));
  return lowest - highest - outlineMargin(a) - outlineMargin(b);
}

TEST(NeighbourSearch, ByPartBoxesFindsAllThatAreWithinTheLimit) {
  Random random(81);
  NeighbourSearch search;
  int within = 0;
  int near = 0;
  int all = 0;
  for (int round = 0; round < test::trials(300); ++round) {
    const float size = anySize(random, -3.0F, 3.0F);
    const PartList a(randomParts(random, anyInt(random, 1, 20), size, 0.0F));
    const PartList b(randomParts(random, anyInt(random, 1, 20), size, 0.0F));
    const Frame frameB = randomFrame(random, size * random.uniform(0.0F, 2.0F));
    const float limit = size * random.uniform(0.0F, 0.3F);
    const double rounding = 4e-6 * static_cast<double>(size);
    search.byPartBoxes(a, b, frameB, limit);
    expectAscendingAndOnce(search.found());
    for (int i = 0; i < a.count(); ++i) {
      for (int j = 0; j < b.count(); ++j) {
        ++all;
        if (distanceOf(a.part(i), b.part(j), frameB) > static_cast<double>(limit) - rounding) continue;
        ++within;
        EXPECT_TRUE(contains(search.found(), i, j)) << "round " << round << ", parts " << i << ", " << j;
      }
    }
    near += static_cast<int>(search.found().size());
    for (const Neighbours& n : search.found()) {
      EXPECT_LE(n.separation, limit);
      EXPECT_NEAR(glm::length(n.axis), 1.0F, 1e-5F);
      const double gap = gapAlong(a.part(n.a), b.part(n.b), frameB, glm::dvec3(n.axis));
      EXPECT_LE(static_cast<double>(n.separation), gap + rounding) << "round " << round;
    }
  }
  EXPECT_GT(within, test::trials(1000));
  // Boxes find more than there is, but not everything.
  EXPECT_LT(near, all * 3 / 4);
}

/// Parts around a place.
std::vector<PartDef> partsAt(Random& random, int count, const Vec3& place) {
  std::vector<PartDef> parts = randomParts(random, count, 1.0F, 0.0F);
  for (PartDef& part : parts) {
    for (Vec3& point : part.core) point += place;
    part.boundsCenter += place;
  }
  return parts;
}

using Found = std::tuple<int, int, float>;

/// In ascending order. `firstA`, `firstB`: added to the parts' numbers.
void addFound(const NeighbourSearch& search, int firstA, int firstB, std::vector<Found>& all) {
  for (const Neighbours& near : search.found())
    all.emplace_back(near.a + firstA, near.b + firstB, near.separation);
  std::sort(all.begin(), all.end());
}

TEST(NeighbourSearch, ByPartBoxesFindsOfManyPartsWhatItFindsOfAFewAtATime) {
  Random random(85);
  NeighbourSearch search;
  constexpr int kFew = 50;
  std::vector<PartDef> all;
  std::vector<std::unique_ptr<PartList>> fews;
  for (int i = 0; i < 12; ++i) {
    const Vec3 place(random.uniform(-6.0F, 6.0F), random.uniform(-6.0F, 6.0F), random.uniform(-6.0F, 6.0F));
    const std::vector<PartDef> parts = partsAt(random, kFew, place);
    fews.push_back(std::make_unique<PartList>(parts));
    ASSERT_TRUE(fews.back()->blocks().center[0].empty());
    all.insert(all.end(), parts.begin(), parts.end());
  }
  const PartList many(all);
  ASSERT_FALSE(many.blocks().center[0].empty());
  const PartList other(randomParts(random, 20, 1.0F, 0.0F));
  std::size_t total = 0;
  for (int round = 0; round < test::trials(100); ++round) {
    const Frame frame = randomFrame(random, 5.0F);
    const float limit = random.uniform(0.0F, 0.3F);
    std::vector<Found> expected[2];
    std::vector<Found> found[2];
    for (std::size_t i = 0; i < fews.size(); ++i) {
      const int first = kFew * static_cast<int>(i);
      search.byPartBoxes(*fews[i], other, frame, limit);
      addFound(search, first, 0, expected[0]);
      search.byPartBoxes(other, *fews[i], frame, limit);
      addFound(search, 0, first, expected[1]);
    }
    search.byPartBoxes(many, other, frame, limit);
    addFound(search, 0, 0, found[0]);
    search.byPartBoxes(other, many, frame, limit);
    addFound(search, 0, 0, found[1]);
    for (const int side : {0, 1}) EXPECT_EQ(found[side], expected[side]) << "round " << round;
    total += found[0].size();
  }
  EXPECT_GT(total, static_cast<std::size_t>(test::trials(1000)));
}

TEST(NeighbourSearch, ByPartBoxesFindsNothingFarAway) {
  Random random(82);
  NeighbourSearch search;
  const PartList a(randomParts(random, 20, 1.0F, 0.0F));
  search.byPartBoxes(a, a, Frame{}, 0.0F);
  EXPECT_FALSE(search.found().empty());
  search.byPartBoxes(a, a, randomFrame(random, 20.0F), 0.1F);
  EXPECT_TRUE(search.found().empty());
}

TEST(NeighbourSearch, ByPartBoxesTellsTheSeparationOfFaces) {
  const PartList box(std::vector{testing::boxPart(Vec3(0.0F), Vec3(1.0F), Mat3(1.0F), 0.04F)});
  NeighbourSearch search;
  search.byPartBoxes(box, box, testing::frameOf(kNoRotation, Vec3(0.5F, -2.25F, 0.0F)), 0.5F);
  ASSERT_EQ(search.found().size(), 1U);
  EXPECT_NEAR(search.found()[0].separation, 0.25F, 1e-5F);
  EXPECT_NEAR(search.found()[0].axis.y, -1.0F, 1e-5F);
}

TEST(NeighbourSearch, ByWorldBoundsFindsWhatALoopFinds) {
  Random random(83);
  NeighbourSearch search;
  std::size_t total = 0;
  for (int round = 0; round < 100; ++round) {
    const PartList listA(randomParts(random, anyInt(random, 1, 40), 1.0F, 0.02F));
    const PartList listB(randomParts(random, anyInt(random, 1, 40), 1.0F, 0.02F));
    PartBody a(listA);
    PartBody b(listB);
    a.moveTo(randomFrame(random, random.uniform(0.0F, 1.5F)));
    b.moveTo(randomFrame(random, random.uniform(0.0F, 1.5F)));
    search.byWorldBounds(a, b, 0.0F);
    BoundsTest test(a, b);
    std::vector<IndexPair> expected;
    for (int i = 0; i < listA.count(); ++i) {
      for (int j = 0; j < listB.count(); ++j) {
        if (test.overlap(i, j)) expected.emplace_back(i, j);
      }
    }
    std::vector<IndexPair> found;
    for (const Neighbours& n : search.found()) {
      found.emplace_back(n.a, n.b);
      EXPECT_EQ(n.separation, std::numeric_limits<float>::lowest());
    }
    EXPECT_EQ(found, expected) << "round " << round;
    total += found.size();
  }
  EXPECT_GT(total, 1000U);
}

TEST(NeighbourSearch, ByWorldBoundsFindsWhatIsWithinALimit) {
  Random random(85);
  NeighbourSearch search;
  std::size_t wider = 0;
  for (int round = 0; round < 50; ++round) {
    const PartList list(randomParts(random, 20, 1.0F, 0.02F));
    PartBody a(list);
    PartBody b(list);
    a.moveTo(randomFrame(random, 1.0F));
    b.moveTo(randomFrame(random, 1.0F));
    const float limit = random.uniform(0.0F, 0.2F);
    const auto room = static_cast<std::size_t>(list.paddedCount());
    const auto gapAlong = [&](std::size_t axis, std::size_t i, std::size_t j) {
      const auto low = [&](PartBody& body, std::size_t k) { return body.worldBounds()[axis * room + k]; };
      const auto high = [&](PartBody& body, std::size_t k) {
        return body.worldBounds()[(axis + 3) * room + k];
      };
      return std::max(low(b, j) - high(a, i), low(a, i) - high(b, j));
    };
    std::size_t expected = 0;
    for (std::size_t i = 0; i < 20; ++i) {
      for (std::size_t j = 0; j < 20; ++j)
        expected += std::max({gapAlong(0, i, j), gapAlong(1, i, j), gapAlong(2, i, j)}) <= limit ? 1 : 0;
    }
    search.byWorldBounds(a, b, 0.0F);
    const std::size_t overlapping = search.found().size();
    search.byWorldBounds(a, b, limit);
    // What is at the limit is rounding's to decide.
    EXPECT_NEAR(static_cast<double>(search.found().size()), static_cast<double>(expected), 1.0);
    wider += search.found().size() - overlapping;
  }
  EXPECT_GT(wider, 100U);
}

TEST(NeighbourSearch, FindsNothingAtAPlaceThatIsNoNumber) {
  Random random(84);
  const PartList list(randomParts(random, 20, 1.0F, 0.0F));
  Frame nowhere;
  nowhere.origin = Vec3(std::numeric_limits<float>::quiet_NaN());
  NeighbourSearch search;
  search.byPartBoxes(list, list, nowhere, 0.1F);
  EXPECT_TRUE(search.found().empty());
  PartBody here(list);
  PartBody there(list);
  here.moveTo(Frame{});
  there.moveTo(nowhere);
  search.byWorldBounds(here, there, 0.0F);
  EXPECT_TRUE(search.found().empty());
}

}  // namespace
}  // namespace scatter
