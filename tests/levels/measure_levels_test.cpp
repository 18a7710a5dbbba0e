#include <gtest/gtest.h>
#include <scatter/levels/measure_levels.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "levels/meshes.h"
#include "trials.h"

namespace scatter {
namespace {

using namespace testing;  // the meshes and part builders

std::shared_ptr<const LevelSet> levelsOf(std::vector<Level> levels, float hullMargin = 0.0F) {
  LevelSetDef definition;
  definition.levels = std::move(levels);
  definition.hullMargin = hullMargin;
  auto set = LevelSet::create(std::move(definition));
  EXPECT_TRUE(set.has_value()) << (set ? "" : set.error().message);
  return set.value_or(nullptr);
}

LevelMeasures measured(const LevelSet& set, const SurfaceMesh& mesh) {
  const auto measures = measureLevels(set, mesh);
  EXPECT_TRUE(measures.has_value()) << (measures ? "" : measures.error().message);
  return measures.value_or(LevelMeasures{});
}

TEST(MeasureLevels, TheSameBoxHasNoGap) {
  const auto set = levelsOf({{{box(Vec3(1.0F, 0.5F, 2.0F))}}});
  const LevelMeasures measures = measured(*set, boxMesh(Vec3(1.0F, 0.5F, 2.0F)));
  const LevelFigures& figures = measures.levels.front();
  EXPECT_EQ(figures.parts, 1);
  EXPECT_EQ(figures.vertices, 8);
  EXPECT_NEAR(figures.maxGap, 0.0, 1e-6);
  EXPECT_NEAR(figures.partVolume, 8.0, 1e-4);
  EXPECT_NEAR(figures.unionVolume, 8.0, 0.01);
  EXPECT_NEAR(figures.volumeRatio, 1.0, 0.002);
  EXPECT_NEAR(measures.meshVolume, 8.0, 1e-6);
  EXPECT_DOUBLE_EQ(figures.predictedCost, 1.0);
}

TEST(MeasureLevels, ALargerBoxIsAsFarAsItsFaces) {
  // Half extents 1 and 1.5: faces are 0.5 away, edges more, corners 0.5 * sqrt(3).
  const auto set = levelsOf({{{box(Vec3(1.5F))}}});
  const LevelFigures figures = measured(*set, boxMesh(Vec3(1.0F))).levels.front();
  EXPECT_NEAR(figures.maxGap, 0.5 * std::sqrt(3.0), 1e-6);
  EXPECT_GT(figures.meanGap, 0.5);
  EXPECT_LT(figures.meanGap, 0.6);
  EXPECT_GT(figures.p95Gap, figures.meanGap);
  EXPECT_NEAR(figures.volumeRatio, 27.0 / 8.0, 0.03);
}

TEST(MeasureLevels, TheMarginOfHullsCounts) {
  const auto hull = levelsOf({{{boxHull(Vec3(1.0F))}}}, 0.1F);
  const LevelFigures figures = measured(*hull, boxMesh(Vec3(1.0F))).levels.front();
  EXPECT_NEAR(figures.meanGap, 0.1, 1e-6);
  EXPECT_NEAR(figures.maxGap, 0.1, 1e-6);
  // Boxes have none around them.
  const auto solid = levelsOf({{{box(Vec3(1.0F))}}}, 0.1F);
  EXPECT_NEAR(measured(*solid, boxMesh(Vec3(1.0F))).levels.front().maxGap, 0.0, 1e-6);
}

TEST(MeasureLevels, AMarginThatReachesThroughTheMeshCountsBeyondIt) {
  // Faces are 0.1 below the mesh and their margin is 0.25: it sticks out by 0.15, around corners by less.
  const auto hull = levelsOf({{{boxHull(Vec3(0.9F))}}}, 0.25F);
  const LevelFigures figures = measured(*hull, boxMesh(Vec3(1.0F))).levels.front();
  EXPECT_NEAR(figures.meanGap, 0.15, 1e-6);
  EXPECT_NEAR(figures.maxGap, 0.15, 1e-6);
}

TEST(MeasureLevels, ABallAroundACubeIsMeasuredByFormula) {
  // The ball through the corners of a cube with half extent 1 is sqrt(3) - 1 above the middles of its faces.
  const auto set = levelsOf({{{sphere(std::sqrt(3.0F))}}});
  const LevelFigures figures = measured(*set, boxMesh(Vec3(1.0F))).levels.front();
  EXPECT_NEAR(figures.maxGap, std::sqrt(3.0) - 1.0, 0.02);
  EXPECT_EQ(figures.vertices, 0);
  EXPECT_NEAR(figures.unionVolume, 4.0 * std::numbers::pi * std::sqrt(3.0), 0.2);
}

TEST(MeasureLevels, WhatOtherPartsHideDoesNotCount) {
  // Two overlapping boxes that together are the mesh: their inner faces are inside each other.
  const auto set = levelsOf({{{box(Vec3(1.2F, 1.0F, 1.0F), Vec3(-0.8F, 0.0F, 0.0F)),
                               box(Vec3(1.2F, 1.0F, 1.0F), Vec3(0.8F, 0.0F, 0.0F))}}});
  MeasureDef definition;
  definition.interior = MeshInterior::kSurface;
  const auto measures = measureLevels(*set, boxMesh(Vec3(2.0F, 1.0F, 1.0F)), definition);
  ASSERT_TRUE(measures.has_value());
  EXPECT_NEAR(measures->levels.front().p95Gap, 0.0, 1e-5);
  // As a surface it is hollow, and that is filled.
  EXPECT_NEAR(measures->levels.front().maxGap, 1.0, 0.05);
  EXPECT_NEAR(measures->levels.front().partVolume, 19.2, 1e-3);
  EXPECT_NEAR(measures->levels.front().unionVolume, 16.0, 0.1);
  EXPECT_FALSE(measures->isSolid);
  EXPECT_EQ(measures->meshVolume, 0.0);
}

TEST(MeasureLevels, TheInsideOfASolidMeshDoesNotCount) {
  // A small box in a large mesh: all of its surface is inside.
  const auto set = levelsOf({{{box(Vec3(0.2F))}}});
  EXPECT_EQ(measured(*set, boxMesh(Vec3(1.0F))).levels.front().maxGap, 0.0);
  MeasureDef definition;
  definition.interior = MeshInterior::kSurface;
  const auto asSurface = measureLevels(*set, boxMesh(Vec3(1.0F)), definition);
  ASSERT_TRUE(asSurface.has_value());
  // Its faces are 0.8 away, its middle 1.
  EXPECT_NEAR(asSurface->levels.front().p95Gap, 0.8, 1e-5);
  EXPECT_NEAR(asSurface->levels.front().maxGap, 1.0, 0.03);
}

TEST(MeasureLevels, FinerLevelsAreNearer) {
  if (test::kSanitized) GTEST_SKIP() << "builds as other tests do";
  const SurfaceMesh mesh = torusMesh(24, 12);
  LevelBuildDef definition;
  definition.partCounts = {1, 6, 24};
  const auto built = buildLevels(mesh, definition);
  ASSERT_TRUE(built.has_value()) << built.error().message;
  const LevelMeasures measures = measured(*built->levels, mesh);
  ASSERT_EQ(measures.levels.size(), 3U);
  for (std::size_t i = 1; i < 3; ++i) {
    EXPECT_LT(measures.levels[i].meanGap, 0.7 * measures.levels[i - 1].meanGap);
    EXPECT_LT(measures.levels[i].p95Gap, 0.7 * measures.levels[i - 1].p95Gap);
    EXPECT_GT(measures.levels[i].predictedCost, measures.levels[i - 1].predictedCost);
  }
  // One hull of the torus fills its hole, which reaches 0.7 from the axis: the middle of the lid lies
  // sqrt(1 + 0.3 * 0.3) - 0.3 from the tube.
  EXPECT_NEAR(measures.levels.front().maxGap, std::sqrt(1.09) - 0.3, 0.05);
  EXPECT_LT(measures.levels.back().p95Gap, 0.02 * measures.diagonal);
}

TEST(MeasureLevels, BadMeshesGetAnError) {
  const auto set = levelsOf({{{box(Vec3(1.0F))}}});
  const auto measures = measureLevels(*set, SurfaceMesh{});
  ASSERT_FALSE(measures.has_value());
  EXPECT_EQ(measures.error().message, "the mesh has no triangles");
}

}  // namespace
}  // namespace scatter
