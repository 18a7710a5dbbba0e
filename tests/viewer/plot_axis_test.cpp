#include "viewer/panels/plot_axis.h"

#include <gmock/gmock.h>

namespace scatter::viewer {
namespace {

using testing::FloatEq;
using testing::IsEmpty;
using testing::Pointwise;

using Lines = std::vector<std::vector<float>>;

TEST(PlotAxis, OneWorldIsLinearFromZero) {
  const PlotAxis axis = chooseAxis(Lines{{1.0F, 100.0F, 3.0F}}, 0.0F);
  EXPECT_FALSE(axis.logarithmic);
  EXPECT_EQ(axis.shareOf(0.0F), 0.0F);
  EXPECT_GT(axis.shareOf(100.0F), 0.8F);
  EXPECT_LT(axis.shareOf(100.0F), 1.0F);
  EXPECT_THAT(axis.marks(), IsEmpty());
}

TEST(PlotAxis, WorldsThatAreAlikeAreLinear) {
  EXPECT_FALSE(chooseAxis(Lines{{10.0F, 12.0F}, {5.0F, 6.0F}}, 0.0F).logarithmic);
}

TEST(PlotAxis, BothAreReadWhereOneDwarfsTheOther) {
  const PlotAxis axis = chooseAxis(Lines{{69000.0F, 70000.0F}, {2500.0F, 2700.0F}}, 0.0F);
  ASSERT_TRUE(axis.logarithmic);
  EXPECT_GT(axis.shareOf(2600.0F), 0.05F);
  EXPECT_LT(axis.shareOf(2700.0F), axis.shareOf(70000.0F) - 0.2F);
  EXPECT_LT(axis.shareOf(70000.0F), 1.0F);
  EXPECT_THAT(axis.marks(), Pointwise(FloatEq(), {1e4F, 1e5F, 2e3F, 2e4F, 5e3F, 5e4F}));
}

TEST(PlotAxis, ABudgetIsInThePicture) {
  EXPECT_LT(chooseAxis(Lines{{1.0F}}, 8.0F).shareOf(8.0F), 1.0F);
  const PlotAxis axis = chooseAxis(Lines{{1.0F}, {0.1F}}, 8.0F);
  EXPECT_TRUE(axis.logarithmic);
  EXPECT_LT(axis.shareOf(8.0F), 1.0F);
}

TEST(PlotAxis, NothingAndZerosAreDrawnAtTheBottom) {
  EXPECT_EQ(chooseAxis(Lines{}, 0.0F).shareOf(0.0F), 0.0F);
  EXPECT_EQ(chooseAxis(Lines{{}, {}}, 0.0F).shareOf(0.0F), 0.0F);
  EXPECT_FALSE(chooseAxis(Lines{{0.0F, 0.0F}, {50.0F}}, 0.0F).logarithmic);
  const PlotAxis axis = chooseAxis(Lines{{0.0F, 900.0F, 1000.0F}, {0.0F, 9.0F, 10.0F}}, 0.0F);
  ASSERT_TRUE(axis.logarithmic);
  EXPECT_EQ(axis.shareOf(0.0F), 0.0F);
}

}  // namespace
}  // namespace scatter::viewer
