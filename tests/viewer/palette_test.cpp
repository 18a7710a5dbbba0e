#include "viewer/palette.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace scatter::viewer {
namespace {

float difference(const Color& a, const Color& b) {
  return glm::length(glm::vec3(a) - glm::vec3(b));
}

TEST(Palette, CostIsSeenOverThreeOrdersOfMagnitude) {
  for (float units = kLeastCost; units < 0.9F * kMostCost; units *= 2.0F) {
    EXPECT_GT(difference(costColor(units), costColor(2.0F * units)), 0.05F) << units;
  }
  EXPECT_EQ(costColor(0.0F), costColor(kLeastCost));
  EXPECT_LT(difference(costColor(kMostCost), costColor(100.0F * kMostCost)), 1e-4F);
}

TEST(Palette, SmallDifferencesOfCostAreSmallDifferencesOfColour) {
  for (float units = kLeastCost; units < kMostCost; units *= 1.01F) {
    EXPECT_LT(difference(costColor(units), costColor(1.01F * units)), 0.02F) << units;
  }
}

}  // namespace
}  // namespace scatter::viewer
