#include "scenes/ground_shapes.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace scatter {
namespace {

SceneFileTerrain hills() {
  return {.size = {60.0F, 40.0F}, .cells = {60, 40}, .relief = 4.0F, .roughness = 0.4F, .seed = 7};
}

TEST(Terrain, ReachesFromZeroToItsRelief) {
  const HeightField field = terrainHeights(hills());
  EXPECT_EQ(field.columns, 61U);
  EXPECT_EQ(field.rows, 41U);
  const auto [low, high] = std::minmax_element(field.heights.begin(), field.heights.end());
  EXPECT_EQ(*low, 0.0F);
  EXPECT_EQ(*high, 4.0F);
}

TEST(Terrain, IsSmooth) {
  const HeightField field = terrainHeights(hills());
  for (std::size_t i = 0; i + 2 < field.columns; ++i) {
    const float bend = field.heights[i] - 2.0F * field.heights[i + 1] + field.heights[i + 2];
    EXPECT_LT(std::abs(bend), 0.5F) << i;
  }
}

TEST(Terrain, IsTheSameForTheSameSeedAlone) {
  SceneFileTerrain other = hills();
  other.seed = 8;
  EXPECT_EQ(terrainHeights(hills()).heights, terrainHeights(hills()).heights);
  EXPECT_NE(terrainHeights(hills()).heights, terrainHeights(other).heights);
}

TEST(Terrain, MayBeFlatOrASingleCell) {
  SceneFileTerrain flat = hills();
  flat.relief = 0.0F;
  EXPECT_THAT(terrainHeights(flat).heights, testing::Each(0.0F));
  SceneFileTerrain cell = hills();
  cell.cells = {1, 1};
  EXPECT_EQ(terrainHeights(cell).heights.size(), 4U);
}

}  // namespace
}  // namespace scatter
