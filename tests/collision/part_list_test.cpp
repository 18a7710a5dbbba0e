#include "collision/part_list.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>

#include "collision/geometry.h"
#include "collision/reference_distance.h"

namespace scatter {
namespace {

using testing::anySize;
using testing::placed;
using testing::Random;
using testing::randomFrame;
using testing::randomParts;

/// Lower and upper bounds of one part.
struct Range {
  glm::dvec3 low;
  glm::dvec3 high;
};

Range worldRange(const std::vector<float>& bounds, const PartList& list, int part) {
  const auto at = [&](int which) {
    return static_cast<double>(bounds[static_cast<std::size_t>(which * list.paddedCount() + part)]);
  };
  return {{at(0), at(1), at(2)}, {at(3), at(4), at(5)}};
}

Range boxRange(const PartList& list, int part) {
  const auto i = static_cast<std::size_t>(part);
  Range range{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto center = static_cast<double>(list.boxes().center[axis][i]);
    const auto half = static_cast<double>(list.boxes().half[axis][i]);
    range.low[axis] = center - half;
    range.high[axis] = center + half;
  }
  return range;
}

void expectHolds(const Range& range, const glm::dvec3& point, double margin, double rounding) {
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_LE(range.low[axis], point[axis] - margin + rounding);
    EXPECT_GE(range.high[axis], point[axis] + margin - rounding);
  }
}

TEST(PartList, KeepsThePartsAsTheyAre) {
  Random random(71);
  const std::vector<PartDef> defs = randomParts(random, 37, 2.0F, 0.0F);
  const PartList list(defs);
  ASSERT_EQ(list.count(), 37);
  EXPECT_GE(list.paddedCount(), list.count());
  EXPECT_LT(list.paddedCount(), list.count() + simd::kPadding);
  EXPECT_EQ(list.paddedCount() % simd::kPadding, 0);
  for (int i = 0; i < list.count(); ++i) {
    const PartDef& def = defs[static_cast<std::size_t>(i)];
    const PartList::Part& part = list.part(i);
    EXPECT_EQ(part.kind, def.kind);
    EXPECT_EQ(part.margin, def.margin);
    ASSERT_EQ(part.core.count, static_cast<int>(def.core.size()));
    for (int k = 0; k < part.core.count; ++k)
      EXPECT_EQ(part.core.vertex(k), def.core[static_cast<std::size_t>(k)]);
    for (int k = part.core.count; k < simd::padded(part.core.count); ++k) {
      EXPECT_EQ(part.core.vertex(k), def.core.back()) << "padding";
    }
  }
}

TEST(PartList, ABoxHasSharpCornersOfItsOwn) {
  const Mat3 turned = glm::mat3_cast(glm::angleAxis(0.4F, glm::normalize(Vec3(1, 2, 3))));
  const Vec3 center(1, 2, 3);
  const Vec3 half(0.5F, 1.0F, 1.5F);
  const PartList list(std::vector{testing::boxPart(center, half, turned, 0.04F)});
  const PartList::Part& part = list.part(0);
  ASSERT_EQ(part.sharp.count, 8);
  for (int i = 0; i < 8; ++i) {
    const Vec3 local = glm::transpose(turned) * (part.sharp.vertex(i) - center);
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(std::abs(local[axis]), half[axis], 1e-5F);
    for (int k = 0; k < i; ++k) EXPECT_NE(part.sharp.vertex(i), part.sharp.vertex(k));
  }
}

TEST(PartList, BoxesHoldThePartsWithTheirMargins) {
  Random random(72);
  for (int round = 0; round < 100; ++round) {
    const float size = anySize(random, -3.0F, 3.0F);
    const PartList list(randomParts(random, 1 + round % 40, size, 0.0F));
    const double rounding = 1e-6 * static_cast<double>(size);
    Range all{};
    for (int axis = 0; axis < 3; ++axis) {
      all.low[axis] = static_cast<double>(list.center()[axis] - list.half()[axis]);
      all.high[axis] = static_cast<double>(list.center()[axis] + list.half()[axis]);
    }
    for (int i = 0; i < list.count(); ++i) {
      const PartList::Part& part = list.part(i);
      for (const auto& point : placed(Frame{}, part.core)) {
        expectHolds(boxRange(list, i), point, static_cast<double>(part.margin), rounding);
        expectHolds(all, point, static_cast<double>(part.margin), 2.0 * rounding);
        const double away = glm::length(point - glm::dvec3(list.center())) + static_cast<double>(part.margin);
        EXPECT_LE(away, static_cast<double>(list.radius()) + 2.0 * rounding);
      }
      for (const auto& point : placed(Frame{}, part.sharp))
        expectHolds(boxRange(list, i), point, 0.0, rounding);
    }
  }
}

TEST(PartList, WorldBoundsAreTheSameBitsWithAnyLanes) {
  Random random(73);
  std::vector<float> many;
  std::vector<float> one;
  for (int round = 0; round < 100; ++round) {
    const PartList list(randomParts(random, 1 + round % 50, 1.0F, 0.02F));
    const Frame frame = randomFrame(random, anySize(random, -2.0F, 4.0F));
    list.worldBounds<simd::Lanes>(frame, many);
    list.worldBounds<simd::OneLane>(frame, one);
    ASSERT_EQ(many.size(), one.size());
    for (std::size_t i = 0; i < many.size(); ++i) {
      EXPECT_EQ(std::bit_cast<std::uint32_t>(many[i]), std::bit_cast<std::uint32_t>(one[i])) << i;
    }
  }
}

TEST(PartList, WorldBoundsHoldThePartsAndAreTheEnginesFormula) {
  Random random(74);
  std::vector<float> bounds;
  for (int round = 0; round < 60; ++round) {
    const std::vector<PartDef> defs = randomParts(random, 1 + round % 20, 1.0F, 0.02F);
    const PartList list(defs);
    const float far = anySize(random, -1.0F, 3.0F);
    const Frame frame = randomFrame(random, far);
    const double rounding = 1e-6 * (static_cast<double>(far) + 4.0);
    list.worldBounds(frame, bounds);
    for (int i = 0; i < list.count(); ++i) {
      const PartDef& def = defs[static_cast<std::size_t>(i)];
      const Range range = worldRange(bounds, list, i);
      const double margin = def.kind == PartKind::kBox ? 0.0 : static_cast<double>(def.margin);
      const PartList::Part& part = list.part(i);
      for (const auto& point : placed(frame, def.kind == PartKind::kBox ? part.sharp : part.core)) {
        expectHolds(range, point, margin, rounding);
      }
      const glm::dvec3 center = placed(frame, def.boundsCenter);
      for (int axis = 0; axis < 3; ++axis) {
        // |row of R · axes| · half + margin
        double half = static_cast<double>(def.boundsMargin);
        for (int k = 0; k < 3; ++k) {
          const double turn = glm::dot(glm::dvec3(frame.row[axis]), glm::dvec3(def.boundsAxes[k]));
          half += std::abs(turn) * static_cast<double>(def.boundsHalf[k]);
        }
        EXPECT_NEAR(range.low[axis], center[axis] - half, rounding);
        EXPECT_NEAR(range.high[axis], center[axis] + half, rounding);
      }
    }
  }
}

TEST(PartList, PaddingIsNowhere) {
  Random random(75);
  std::vector<float> bounds;
  for (const int count : {1, 15, 17, 33}) {
    const PartList list(randomParts(random, count, 1.0F, 0.0F));
    ASSERT_GT(list.paddedCount(), count);
    for (int i = count; i < list.paddedCount(); ++i) {
      const Range range = boxRange(list, i);
      for (int axis = 0; axis < 3; ++axis) EXPECT_GT(range.low[axis], range.high[axis]);
    }
    for (int round = 0; round < 20; ++round) {
      const float far = anySize(random, 0.0F, 9.0F);
      list.worldBounds(randomFrame(random, far), bounds);
      for (int i = count; i < list.paddedCount(); ++i) {
        const Range range = worldRange(bounds, list, i);
        for (int axis = 0; axis < 3; ++axis) {
          EXPECT_GT(range.low[axis], 1e3 * static_cast<double>(far)) << "overlaps nothing that is near";
          EXPECT_LT(range.high[axis], -1e3 * static_cast<double>(far));
        }
      }
    }
  }
}

TEST(PartList, CountsAtLeastItsVertices) {
  Random random(76);
  const PartList few(std::vector{testing::spherePart(Vec3(0.0F), 1.0F)});
  const PartList many(randomParts(random, 64, 1.0F, 0.0F));
  EXPECT_GE(few.bytes(), sizeof(PartList) + 3 * 16 * sizeof(float));
  EXPECT_GT(many.bytes(), few.bytes());
}

}  // namespace
}  // namespace scatter
