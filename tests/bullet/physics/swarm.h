#pragma once

#include <gtest/gtest.h>
#include <scatter/bullet/bullet_physics.h>

#include <memory>
#include <vector>

#include "world/conformance/physics_conformance.h"

namespace scatter::test {

/// Three bars of 2 m that cross; around them two slabs; around those a cube.
[[nodiscard]] inline std::shared_ptr<const LevelSet> crossLevels() {
  LevelSetDef def;
  def.name = "cross";
  def.levels.push_back({{{Box{Vec3(1.0F)}, {}}}});
  def.levels.push_back({{{Box{{1.0F, 1.0F, 0.2F}}, {}}, {Box{{0.2F, 0.2F, 1.0F}}, {}}}});
  def.levels.push_back(
      {{{Box{{1.0F, 0.2F, 0.2F}}, {}}, {Box{{0.2F, 1.0F, 0.2F}}, {}}, {Box{{0.2F, 0.2F, 1.0F}}, {}}}});
  auto levels = LevelSet::create(std::move(def));
  EXPECT_TRUE(levels) << levels.error().message;
  return levels.value();
}

/// Three-levelled bodies and a few spheres, without gravity, that are drawn to one point.
class Swarm {
 public:
  explicit Swarm(const PhysicsDef& def) : physics_(makeBulletPhysics(def)) {
    const auto levels = crossLevels();
    for (int i = 0; i < 27; ++i) {
      const int row = i / 3;
      const int layer = row / 3;
      const Vec3 cell{static_cast<float>(i % 3), static_cast<float>(row % 3), static_cast<float>(layer)};
      BodyDef body = bodyAt(2.6F * cell, i % 5 == 4 ? Shape{Sphere{0.5F}} : Shape{levels});
      body.angularVelocity = {0.3F * cell.x, 0.2F, 0.1F * cell.z};
      const auto made = physics_->createBody(body);
      EXPECT_TRUE(made);
      bodies_.push_back(*made);
    }
  }

  [[nodiscard]] Physics& physics() { return *physics_; }
  [[nodiscard]] const std::vector<BodyId>& bodies() const { return bodies_; }

  /// A budget of cost units that takes detail away from bodies that touch. False where there are no budgets.
  bool squeeze() { return physics_->switching().setBudget({.units = 80.0}); }

  void step(int count = 1) {
    for (int i = 0; i < count; ++i) {
      for (const BodyId body : bodies_) {
        const Vec3 way = Vec3(2.6F) - physics_->state(body).centerOfMass;
        physics_->applyCentralForce(body, 8.0F * way, true);
      }
      physics_->step(kStep);
    }
  }

 private:
  std::unique_ptr<Physics> physics_;
  std::vector<BodyId> bodies_;
};

[[nodiscard]] inline PhysicsDef worldOf(WorldKind kind, Switching switching = Switching::kPair,
                                        Policy policy = Policy::kNone) {
  PhysicsDef def;
  def.world = kind;
  def.switching.switching = switching;
  def.switching.policy = policy;
  return def;
}

inline BodyId create(Physics& physics, const BodyDef& def) {
  const Result<BodyId> body = physics.createBody(def);
  EXPECT_TRUE(body) << body.error().message;
  return *body;
}

inline BodyId createGround(Physics& physics) {
  BodyDef ground = bodyAt({}, Plane{});
  ground.motion = Motion::kStatic;
  return create(physics, ground);
}

inline void stepBy(Physics& physics, int count) {
  for (int i = 0; i < count; ++i) physics.step(kStep);
}

}  // namespace scatter::test
