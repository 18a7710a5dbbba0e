#include "scenes/hexahedron.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace scatter::test {
namespace {

const Vec3 kLow(-1.0F, 0.0F, 2.0F);
const Vec3 kHigh(1.0F, 3.0F, 3.0F);

TEST(Hexahedron, OfABoxHasItsCornersAndItsMiddle) {
  const Hexahedron box = Hexahedron::box(kLow, kHigh);
  EXPECT_EQ(box.at(Vec3(0.0F)), kLow);
  EXPECT_EQ(box.at(Vec3(1.0F)), kHigh);
  EXPECT_EQ(box.at({1.0F, 0.0F, 0.5F}), Vec3(1.0F, 0.0F, 2.5F));
  EXPECT_EQ(std::get<ConvexHull>(box.part().shape).vertices.size(), 8U);
}

TEST(Hexahedron, CutLeavesTheShare) {
  const Hexahedron piece = Hexahedron::box(kLow, kHigh).cut({{0.5F, 0.0F, 0.0F}, {1.0F, 1.0F, 0.25F}});
  const ConvexPart part = piece.boxPart();
  // x from 0 to 1, y from 0 to 3, z from 2 to 2.25
  EXPECT_EQ(std::get<Box>(part.shape).halfExtents, Vec3(0.5F, 1.5F, 0.125F));
  EXPECT_EQ(part.pose.position, Vec3(0.5F, 1.5F, 2.125F));
}

TEST(Hexahedron, ShrinksByTheInsetOrABitMore) {
  const Hexahedron inside = Hexahedron::box(kLow, kHigh).shrunk(0.1F);
  for (int axis = 0; axis < 3; ++axis) {
    const float below = inside.at(Vec3(0.0F))[axis] - kLow[axis];
    const float above = kHigh[axis] - inside.at(Vec3(1.0F))[axis];
    for (const float gap : {below, above}) {
      EXPECT_GE(gap, 0.1F);
      EXPECT_LE(gap, 0.15F);
    }
  }
}

}  // namespace
}  // namespace scatter::test
