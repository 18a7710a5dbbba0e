#include "collision/part_query.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "collision/geometry.h"
#include "collision/reference_distance.h"
#include "trials.h"

namespace scatter {
namespace {

using testing::anyInt;
using testing::boxPart;
using testing::DistanceBounds;
using testing::frameOf;
using testing::hullPart;
using testing::placed;
using testing::Points;
using testing::Random;
using testing::randomCore;
using testing::randomParts;
using testing::referenceDistance;
using testing::spherePart;

constexpr float kFar = 100.0F;

bool areBoxes(const PartList::Part& a, const PartList::Part& b) {
  return a.kind == PartKind::kBox && b.kind == PartKind::kBox;
}

/// Of two parts, margins included; of two boxes, whose edges are sharp, exactly theirs.
struct QueryTruth {
  double lower;
  double upper;  ///< No part of the answer if the cores overlap.
  bool deep;     ///< They do.
};

QueryTruth queryTruthOf(const PartList::Part& a, const PartList::Part& b, const Frame& frameB) {
  const bool boxes = areBoxes(a, b);
  const DistanceBounds bounds =
      referenceDistance(placed(Frame{}, boxes ? a.sharp : a.core), placed(frameB, boxes ? b.sharp : b.core));
  const double margin = boxes ? 0.0 : static_cast<double>(a.margin) + static_cast<double>(b.margin);
  return {bounds.lower - margin, bounds.upper - margin, glm::length(bounds.axis) < 0.5};
}

QueryTruth queryTruthOf(const PartList& a, const PartList& b, const Frame& frameB) {
  QueryTruth least{kFar, kFar, false};
  for (int i = 0; i < a.count(); ++i) {
    for (int k = 0; k < b.count(); ++k) {
      const QueryTruth pair = queryTruthOf(a.part(i), b.part(k), frameB);
      least.lower = std::min(least.lower, pair.lower);
      least.upper = std::min(least.upper, pair.upper);
      least.deep = least.deep || pair.deep;
    }
  }
  return least;
}

/// One part of a kind of which everything is known.
PartDef knownPart(Random& random, float size) {
  const Vec3 center = random.inBox(Vec3(size));
  switch (anyInt(random, 0, 2)) {
    case 0: {
      const Vec3 half = size * Vec3(random.uniform(0.1F, 0.5F), random.uniform(0.1F, 0.5F), 0.2F);
      return boxPart(center, half, glm::mat3_cast(random.rotation()), 0.02F * size);
    }
    case 1:
      return spherePart(center, size * random.uniform(0.1F, 0.4F));
    default: {
      std::vector<Vec3> core = randomCore(random, 16, 0.4F * size);
      for (Vec3& point : core) point += center;
      return hullPart(std::move(core), size * random.uniform(0.0F, 0.05F));
    }
  }
}

std::vector<PartDef> knownParts(Random& random, int count) {
  std::vector<PartDef> parts;
  for (int i = 0; i < count; ++i) parts.push_back(knownPart(random, 1.0F));
  return parts;
}

TEST(PartQuery, NeverCallsSeparatedWhatIsNearer) {
  Random random(31);
  PartQuery query;
  int yes = 0;
  int needless = 0;
  for (int round = 0; round < test::trials(3000); ++round) {
    const PartList a(knownParts(random, anyInt(random, 1, 4)));
    const PartList b(knownParts(random, anyInt(random, 1, 4)));
    const Frame frameB = frameOf(random.rotation(), random.direction() * random.uniform(0.2F, 4.0F));
    const QueryTruth truth = queryTruthOf(a, b, frameB);
    const float gaps[] = {0.0F, random.uniform(0.0F, 0.5F), random.uniform(-0.05F, 0.0F),
                          static_cast<float>(truth.upper)};
    for (const float gap : gaps) {
      const bool separated = query.isSeparated(a, b, frameB, gap);
      yes += separated ? 1 : 0;
      if (truth.deep) {
        EXPECT_FALSE(separated && gap >= 0.0F) << "round " << round;
        continue;
      }
      EXPECT_FALSE(separated && truth.upper < static_cast<double>(gap) - 1e-5) << "round " << round;
      needless += !separated && truth.lower > static_cast<double>(gap) + 0.01 ? 1 : 0;
    }
  }
  EXPECT_GT(yes, test::trials(3000));
  // It doubts where margins let no plane show it, or where bounds of a negative gap do.
  EXPECT_LT(needless, test::trials(100));
}

TEST(PartQuery, MeasuresTheDistance) {
  Random random(32);
  PartQuery query;
  int apart = 0;
  for (int round = 0; round < test::trials(3000); ++round) {
    const PartList a(knownParts(random, anyInt(random, 1, 4)));
    const PartList b(knownParts(random, anyInt(random, 1, 4)));
    const Frame frameB = frameOf(random.rotation(), random.direction() * random.uniform(0.2F, 4.0F));
    const QueryTruth truth = queryTruthOf(a, b, frameB);
    const float distance = query.distance(a, b, frameB, kFar);
    if (truth.deep) {
      EXPECT_LE(distance, 0.0F) << "round " << round;
      continue;
    }
    ++apart;
    EXPECT_GE(static_cast<double>(distance), truth.lower - 1e-3) << "round " << round;
    EXPECT_LE(static_cast<double>(distance), truth.upper + 1e-3) << "round " << round;
    // Rounding may let either of them win where they are the same.
    EXPECT_NEAR(query.distance(a, b, frameB, distance / 2), std::min(distance, distance / 2),
                1e-3F + std::max(0.0F, -distance));
  }
  EXPECT_GT(apart, test::trials(500));
}

TEST(PartQuery, GivesTheLimitWhereNothingIsNearer) {
  PartQuery query;
  const PartList a(std::vector<PartDef>{boxPart({}, Vec3(0.5F), Mat3(1.0F), 0.0F)});
  const PartList b(std::vector<PartDef>{boxPart({}, Vec3(0.5F), Mat3(1.0F), 0.0F)});
  const auto at = [](float x) { return frameOf(kNoRotation, {x, 0.0F, 0.0F}); };
  EXPECT_FLOAT_EQ(query.distance(a, b, at(9.0F), 0.25F), 0.25F);
  EXPECT_NEAR(query.distance(a, b, at(1.1F), 0.25F), 0.1F, 1e-5F);
  EXPECT_NEAR(query.distance(a, b, at(0.7F), 0.25F), -0.3F, 1e-5F) << "two boxes, all the way";
}

/// The depth along the 15 axes, in double precision.
double exactBoxDepth(const PartDef& a, const PartDef& b, const Frame& frameB) {
  const glm::dmat3 axesA(a.boundsAxes);
  glm::dmat3 axesB;
  for (int i = 0; i < 3; ++i) axesB[i] = glm::dvec3(frameB.rotate(b.boundsAxes[i]));
  const glm::dvec3 between = glm::dvec3(frameB(b.boundsCenter)) - glm::dvec3(a.boundsCenter);
  double least = 1e9;
  const auto along = [&](const glm::dvec3& axis) {
    const double length = glm::length(axis);
    if (length < 1e-6) return;
    double overlap = -std::abs(glm::dot(between, axis));
    for (int i = 0; i < 3; ++i) {
      overlap += static_cast<double>(a.boundsHalf[i]) * std::abs(glm::dot(axesA[i], axis));
      overlap += static_cast<double>(b.boundsHalf[i]) * std::abs(glm::dot(axesB[i], axis));
    }
    least = std::min(least, overlap / length);
  };
  for (int i = 0; i < 3; ++i) {
    along(axesA[i]);
    along(axesB[i]);
    for (int k = 0; k < 3; ++k) along(glm::cross(axesA[i], axesB[k]));
  }
  return std::max(least, 0.0);
}

TEST(PartDepth, OfBoxesIsExact) {
  Random random(33);
  int deep = 0;
  for (int round = 0; round < 5000; ++round) {
    const auto anyBox = [&random] {
      const Vec3 half(random.uniform(0.1F, 1.0F), random.uniform(0.1F, 1.0F), random.uniform(0.1F, 1.0F));
      return boxPart(random.inBox(Vec3(0.5F)), half, glm::mat3_cast(random.rotation()), 0.01F);
    };
    const PartDef boxA = anyBox();
    const PartDef boxB = anyBox();
    const PartList a(std::vector<PartDef>{boxA});
    const PartList b(std::vector<PartDef>{boxB});
    const Frame frameB = frameOf(random.rotation(), random.direction() * random.uniform(0.0F, 2.0F));
    const double depth = exactBoxDepth(boxA, boxB, frameB);
    deep += depth > 0.0 ? 1 : 0;
    EXPECT_NEAR(static_cast<double>(partDepth(a.part(0), b.part(0), frameB)), depth, 2e-5) << round;
  }
  EXPECT_GT(deep, 1000);
}

TEST(PartDepth, OfSpheresIsExact) {
  const PartList ball(std::vector<PartDef>{spherePart({0.5F, 0.0F, 0.0F}, 0.4F)});
  const PartList other(std::vector<PartDef>{spherePart({}, 0.3F)});
  const PartList box(std::vector<PartDef>{boxPart({}, {0.2F, 1.0F, 1.0F}, Mat3(1.0F), 0.0F)});
  const Frame centre;
  EXPECT_NEAR(partDepth(ball.part(0), other.part(0), centre), 0.2F, 1e-6F);
  EXPECT_NEAR(partDepth(ball.part(0), box.part(0), centre), 0.1F, 1e-6F);
  EXPECT_NEAR(partDepth(box.part(0), ball.part(0), centre), 0.1F, 1e-6F);
  const Frame inside = frameOf(kNoRotation, {-0.4F, 0.0F, 0.0F});
  EXPECT_NEAR(partDepth(box.part(0), ball.part(0), inside), 0.5F, 1e-6F) << "its centre is in the box";
  const Frame away = frameOf(kNoRotation, {0.2F, 0.0F, 0.0F});
  EXPECT_EQ(partDepth(box.part(0), ball.part(0), away), 0.0F);
}

/// Part 0 of B with its centre so far from that of A's.
Frame frameNear(Random& random, const PartList& a, const PartList& b, float furthest) {
  Frame frame = frameOf(random.rotation(), Vec3(0.0F));
  frame.origin = a.part(0).center - frame.rotate(b.part(0).center);
  frame.origin += random.direction() * random.uniform(0.0F, furthest);
  return frame;
}

float overlapAlong(const PartList::Part& a, const PartList::Part& b, const Frame& frameB, const Vec3& axis) {
  const bool boxes = areBoxes(a, b);
  const float margin = boxes ? 0.0F : a.margin + b.margin;
  return reach(boxes ? a.sharp : a.core, axis) + reach(boxes ? b.sharp : b.core, frameB.rotateBack(-axis)) +
         margin - glm::dot(axis, frameB.origin);
}

/// The least overlap along any direction: many of them, and the best ones improved.
float searchedDepth(Random& random, const PartList::Part& a, const PartList::Part& b, const Frame& frameB) {
  float least = 1e9F;
  for (int start = 0; start < 60; ++start) {
    Vec3 axis = random.direction();
    float overlap = overlapAlong(a, b, frameB, axis);
    for (float width = 0.5F; width > 1e-4F; width *= 0.85F) {
      const Vec3 other = glm::normalize(axis + width * random.direction());
      const float there = overlapAlong(a, b, frameB, other);
      if (there >= overlap) continue;
      overlap = there;
      axis = other;
    }
    least = std::min(least, overlap);
  }
  return std::max(least, 0.0F);
}

TEST(PartDepth, IsNeverLessThanTheTrueDepth) {
  Random random(34);
  int deep = 0;
  for (int round = 0; round < test::trials(1000); ++round) {
    const PartList a(randomParts(random, 1, 0.6F, 0.0F));
    const PartList b(randomParts(random, 1, 0.6F, 0.0F));
    const Frame frameB = frameNear(random, a, b, 0.4F);
    // The search finds a little more than there is.
    const float searched = searchedDepth(random, a.part(0), b.part(0), frameB);
    deep += searched > 0.05F ? 1 : 0;
    EXPECT_GE(partDepth(a.part(0), b.part(0), frameB), 0.97F * searched - 0.01F) << "round " << round;
  }
  EXPECT_GT(deep, test::trials(200));
}

TEST(PartQuery, TellsHowDeepPartsOverlapAtMost) {
  Random random(38);
  PartQuery query;
  int yes = 0;
  int no = 0;
  for (int round = 0; round < test::trials(1000); ++round) {
    const PartList a(randomParts(random, 1, 0.6F, 0.0F));
    const PartList b(randomParts(random, 1, 0.6F, 0.0F));
    const Frame frameB = frameNear(random, a, b, 0.4F);
    const float searched = searchedDepth(random, a.part(0), b.part(0), frameB);
    const float gap = -random.uniform(0.0F, 0.5F);
    const bool separated = query.isSeparated(a, b, frameB, gap);
    if (separated) {
      EXPECT_LE(0.97F * searched - 0.01F, -gap) << "round " << round;
    }
    (separated ? yes : no) += searched > 0.05F ? 1 : 0;
  }
  EXPECT_GT(yes, test::trials(50));
  EXPECT_GT(no, test::trials(50));
}

/// `frame`, after all of space has moved by `motion`.
Frame moved(const Frame& motion, const Frame& frame) {
  Frame result;
  for (int column = 0; column < 3; ++column) {
    Vec3 unit(0.0F);
    unit[column] = 1.0F;
    const Vec3 turned = motion.rotate(frame.rotate(unit));
    for (int row = 0; row < 3; ++row) result.row[row][column] = turned[row];
  }
  result.origin = motion(frame.origin);
  return result;
}

TEST(PartDepth, IsContinuousAlongMotions) {
  Random random(35);
  float deepest = 0.0F;
  for (int round = 0; round < test::trials(2000); ++round) {
    const PartList a(randomParts(random, 1, 0.5F, 0.0F));
    const PartList b(randomParts(random, 1, 0.5F, 0.0F));
    const Frame start = frameNear(random, a, b, 0.4F);
    const Vec3 axis = random.direction();
    const Vec3 along = random.direction();
    float before = -1.0F;
    for (int i = 0; i < 400; ++i) {
      constexpr float kStride = 1e-3F;
      const float t = kStride * static_cast<float>(i);
      const Frame frameB = moved(frameOf(glm::angleAxis(t, axis), t * along), start);
      const float depth = partDepth(a.part(0), b.part(0), frameB);
      // The line between the centres turns the faster the nearer they are.
      const float centers = glm::length(frameB(b.part(0).center) - a.part(0).center);
      const float most = kStride * (4.0F + 1.5F / std::max(centers, 1e-3F));
      if (before >= 0.0F) {
        ASSERT_NEAR(depth, before, most) << "round " << round << ", place " << i << ", centres " << centers;
      }
      before = depth;
      deepest = std::max(deepest, depth);
    }
  }
  EXPECT_GT(deepest, 0.25F);
}

TEST(PartQuery, FindsAllOverlaps) {
  Random random(36);
  PartQuery query;
  std::size_t total = 0;
  for (int round = 0; round < 500; ++round) {
    const PartList a(randomParts(random, anyInt(random, 1, 12), 1.0F, 0.0F));
    const PartList b(randomParts(random, anyInt(random, 1, 12), 1.0F, 0.0F));
    const Frame frameB = frameOf(random.rotation(), random.direction() * random.uniform(0.0F, 1.5F));
    std::map<std::pair<int, int>, float> expected;
    for (int i = 0; i < a.count(); ++i) {
      for (int k = 0; k < b.count(); ++k) {
        const float depth = partDepth(a.part(i), b.part(k), frameB);
        if (depth > 1e-5F) expected[{i, k}] = depth;
      }
    }
    std::map<std::pair<int, int>, float> found;
    for (const PartQuery::Overlap& overlap : query.overlaps(a, b, frameB)) {
      if (overlap.depth > 1e-5F) found[{overlap.a, overlap.b}] = overlap.depth;
    }
    EXPECT_EQ(found, expected) << "round " << round;
    total += found.size();
  }
  EXPECT_GT(total, 400U);
}

}  // namespace
}  // namespace scatter
