#include "solver/lanes.h"

#include <gtest/gtest.h>

namespace scatter::solver {
namespace {

TEST(Lanes, ReplaceTheLastNumberOfAQuad) {
  const Lanes changed = withW({1, 2, 3, 4}, 5);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(changed[i], static_cast<float>(i + 1));
  EXPECT_EQ(changed[3], 5.0F);
}

TEST(Lanes, TellTheFirstThatIsSet) {
  for (int set = 0; set < 16; ++set) {
    LaneMask mask{};
    int first = kLanes;
    for (int lane = kLanes - 1; lane >= 0; --lane) {
      if ((set >> lane & 1) == 0) continue;
      mask[lane] = -1;
      first = lane;
    }
    EXPECT_EQ(firstOf(mask), first) << set;
  }
}

TEST(Lanes, TransposeBack) {
  const LaneQuad once =
      transposed(Lanes{1, 2, 3, 4}, Lanes{5, 6, 7, 8}, Lanes{9, 10, 11, 12}, Lanes{13, 14, 15, 16});
  EXPECT_EQ(once.w[0], 4.0F);
  EXPECT_EQ(once.v.x[3], 13.0F);
  const LaneQuad back = transposed(once.v.x, once.v.y, once.v.z, once.w);
  for (int i = 0; i < kLanes; ++i) {
    EXPECT_EQ(back.v.x[i], static_cast<float>(i + 1));
    EXPECT_EQ(back.w[i], static_cast<float>(i + 13));
  }
}

}  // namespace
}  // namespace scatter::solver
