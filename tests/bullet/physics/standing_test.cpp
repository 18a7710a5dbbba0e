#include <gtest/gtest.h>
#include <scatter/bullet/bullet_physics.h>
#include <scatter/levels/build_levels.h>
#include <scatter/levels/measure_levels.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "levels/meshes.h"
#include "trials.h"

namespace scatter {
namespace {

using namespace testing;  // the meshes

constexpr int kSteps = 240;
constexpr double kStep = 1.0 / 60.0;

/// A table with round legs of a given height, on y = 0.
SurfaceMesh tableMesh(float height) {
  SurfaceMesh mesh = boxMesh(height * Vec3(0.9F, 0.04F, 0.6F), {0.0F, 0.96F * height, 0.0F});
  for (const float x : {-0.75F, 0.75F}) {
    for (const float z : {-0.45F, 0.45F}) {
      const Vec3 place = height * Vec3(x, 0.0F, z);
      mesh = joined(std::move(mesh), prismMesh(12, 0.06F * height, 0.0F, 0.95F * height, place));
    }
  }
  return mesh;
}

/// Floors whose top is at y = 0 around the origin.
std::vector<std::pair<std::string, Shape>> floors() {
  auto square = std::make_shared<TriangleMesh>();
  square->vertices = {{-20, 0, -20}, {20, 0, -20}, {20, 0, 20}, {-20, 0, 20}};
  square->triangles = {{0, 2, 1}, {0, 3, 2}};
  const HeightField field{
      .columns = 9, .rows = 9, .spacingX = 5.0F, .spacingZ = 5.0F, .heights = std::vector<float>(81, 0.0F)};
  return {{"plane", Plane{}},
          {"box", Box{{20.0F, 1.0F, 20.0F}}},
          {"mesh", std::shared_ptr<const TriangleMesh>(square)},
          {"height field", std::make_shared<const HeightField>(field)}};
}

/// The height above the floor at which the body's model comes to rest.
float restingHeight(WorldKind kind, const Shape& floor, const std::shared_ptr<const LevelSet>& levels,
                    float from) {
  PhysicsDef world;
  world.world = kind;
  world.gravity = Vec3(0.0F, -9.81F, 0.0F);
  const auto physics = makeBulletPhysics(world);
  const float top = std::holds_alternative<Box>(floor) ? -1.0F : 0.0F;
  BodyDef ground;
  ground.pose.position.y = top;
  ground.shape = floor;
  ground.motion = Motion::kStatic;
  EXPECT_TRUE(physics->createBody(ground));
  BodyDef table;
  table.pose.position.y = from;
  table.shape = levels;
  const auto body = physics->createBody(table);
  EXPECT_TRUE(body);
  if (!body) return from;
  for (int i = 0; i < kSteps; ++i) physics->step(kStep);
  return physics->state(*body).pose.position.y;
}

void expectStands(const BuiltLevels& built, const SurfaceMesh& mesh, float height) {
  const auto measures = measureLevels(*built.levels, mesh);
  ASSERT_TRUE(measures.has_value()) << measures.error().message;
  for (const auto& [name, floor] : floors()) {
    for (const WorldKind kind : {WorldKind::kStandard, WorldKind::kHybrid}) {
      const float rests = restingHeight(kind, floor, built.levels, 0.02F * height);
      EXPECT_LT(std::abs(static_cast<double>(rests)), 0.001 * measures->diagonal)
          << name << ", " << height << " m, " << (kind == WorldKind::kHybrid ? "hybrid" : "standard");
    }
  }
}

TEST(Standing, AFlatFootIsOnTheFloor) {
  for (const float height : test::trials<float>({0.8F, 0.3F, 4.0F})) {
    const SurfaceMesh mesh = tableMesh(height);
    LevelBuildDef definition;
    definition.partCounts = {1, 5, 24};
    definition.fitPrimitives = false;
    const auto built = buildLevels(mesh, definition);
    ASSERT_TRUE(built.has_value()) << built.error().message;
    expectStands(*built, mesh, height);
  }
}

TEST(Standing, AFootThatIsACylinderIsOnTheFloor) {
  const float height = 0.8F;
  const SurfaceMesh mesh = tableMesh(height);
  const auto built = buildLevels(mesh, {});
  ASSERT_TRUE(built.has_value()) << built.error().message;
  const auto isCylinder = [](const ConvexPart& part) { return std::holds_alternative<Cylinder>(part.shape); };
  ASSERT_EQ(std::ranges::count_if(built->levels->finest().parts, isCylinder), 4);
  ASSERT_EQ(built->levels->finest().parts.size(), 5U);
  expectStands(*built, mesh, height);
}

/// How high a ball is a second after it starts to come down with 7 m/s on a level sheet at y = 0.
float heightAfterFall(WorldKind kind, const std::shared_ptr<const LevelSet>& sheet, float radius,
                      float from) {
  PhysicsDef world;
  world.world = kind;
  world.gravity = Vec3(0.0F);
  const auto physics = makeBulletPhysics(world);
  BodyDef ground;
  ground.shape = sheet;
  ground.motion = Motion::kStatic;
  EXPECT_TRUE(physics->createBody(ground));
  BodyDef ball;
  ball.shape = Sphere{radius};
  ball.pose.position = {0.1F, from, 0.07F};
  ball.linearVelocity.y = -7.0F;
  const auto body = physics->createBody(ball);
  EXPECT_TRUE(body);
  if (!body) return 0.0F;
  for (int i = 0; i < kSteps / 4; ++i) physics->step(kStep);
  return physics->state(*body).pose.position.y;
}

TEST(Standing, ASheetStopsASmallFastBall) {
  const SurfaceMesh mesh = moved(levelSheet(12), 3.5F, Vec3(0.0F));
  const auto built = buildLevels(mesh, {});
  ASSERT_TRUE(built.has_value()) << built.error().message;
  for (const WorldKind kind : {WorldKind::kStandard, WorldKind::kHybrid}) {
    for (const float radius : {0.015F, 0.03F}) {
      // From everywhere within a step's way.
      for (int i = 0; i < 24; ++i) {
        const float from = 0.3F + 0.005F * static_cast<float>(i);
        EXPECT_GT(heightAfterFall(kind, built->levels, radius, from), 0.0F)
            << radius << " m from " << from << " m";
      }
    }
  }
}

}  // namespace
}  // namespace scatter
