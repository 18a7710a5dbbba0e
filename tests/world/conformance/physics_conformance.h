#pragma once

#include <gtest/gtest.h>
#include <scatter/world/physics.h>

#include <functional>
#include <memory>
#include <ostream>
#include <string>

namespace scatter::test {

/// An engine in one of its worlds.
struct PhysicsFactory {
  std::string name;
  WorldKind world = WorldKind::kStandard;
  std::function<std::unique_ptr<Physics>(const PhysicsDef&)> make;
};

/// For failure messages.
inline void PrintTo(const PhysicsFactory& factory, std::ostream* out) {
  *out << factory.name;
}

inline constexpr float kStep = 1.0F / 60.0F;
inline constexpr Vec3 kEarth{0.0F, -10.0F, 0.0F};

/// What every engine behind Physics must do. An engine's test program compiles the sources of this folder
/// and instantiates the suite with its factories.
class PhysicsConformance : public testing::TestWithParam<PhysicsFactory> {
 protected:
  /// Starts an empty world; `def.world` is the factory's.
  void start(PhysicsDef def);
  void startWithGravity(const Vec3& gravity);

  [[nodiscard]] Physics& physics() { return *physics_; }

  /// Adds a body, which must succeed.
  BodyId add(const BodyDef& def);
  JointId join(const JointDef& def);

  /// The ground: everything below y = 0.
  BodyId addGround(const Material& material = {});

  void step(int count = 1);

 private:
  std::unique_ptr<Physics> physics_;
};

/// A dynamic body of 2 kg that never sleeps.
[[nodiscard]] BodyDef bodyAt(const Vec3& position, Shape shape = Box{});

/// A cube of 1 m as a hybrid: a box around it, then two boxes that make it up.
[[nodiscard]] std::shared_ptr<const LevelSet> cubeLevels();

/// About `axis`, radians.
[[nodiscard]] Quat turn(float angle, const Vec3& axis);

void expectNear(const Vec3& actual, const Vec3& expected, float tolerance);

}  // namespace scatter::test
