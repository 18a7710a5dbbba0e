#include <BulletHybrid/btHybridInstallation.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "RandomGrounds.h"
#include "ScriptedMotion.h"
#include "ScriptedWorld.h"

namespace scatter::test {
namespace {

class Grounds : public testing::TestWithParam<GroundType> {};

std::string nameOfGround(const testing::TestParamInfo<GroundType>& info) {
  return nameOf(info.param);
}

/// A body of parts that moves over a ground as a script says, and what the verifier finds.
struct Stage {
  Stage(GroundType type, std::uint64_t seed, float length, int parts)
      : shapes(seed), grounds(shapes), size(length) {
    btCompoundShape* compound = shapes.compound(parts, length);
    // Both orders of the two in a pair.
    const bool groundFirst = seed % 2 == 0;
    if (groundFirst) addGround(type);
    body = w.addHybrid(shapes.oneLevel(compound), btTransform::getIdentity());
    if (!groundFirst) addGround(type);
  }

  void addGround(GroundType type) {
    const btTransform pose(shapes.random.rotation(0.5F), shapes.random.inCube(3 * size));
    ground = w.addOther(0, grounds.make(type, size), pose);
  }

  void run(Motion motion, int steps) {
    ScriptedMotion path(motion, shapes.random, size, 0.6F, ground->getWorldTransform().getOrigin());
    for (int i = 0; i < steps; ++i) {
      ScriptedWorld::place(body, path.next(shapes.random));
      w.detect();
    }
  }

  RandomShapes shapes;
  RandomGrounds grounds;
  float size;
  ScriptedWorld w;
  btHybridRigidBody* body = nullptr;
  btRigidBody* ground = nullptr;
};

TEST_P(Grounds, HaveBulletsContacts) {
  long expected = 0;
  long doubtful = 0;
  long errs = 0;
  for (std::uint64_t seed = 1; seed <= 64; ++seed) {
    const float size = seed % 3 == 0 ? 0.2F : seed % 3 == 1 ? 1.0F : 5.0F;
    Stage stage(GetParam(), seed, size, 4 + static_cast<int>(seed % 3) * 12);
    const auto motion = static_cast<Motion>(seed / 2 % kMotions);
    stage.run(motion, 40);
    const btHybridContactReport& report = stage.w.report();
    EXPECT_EQ(report.m_missed, 0) << "seed " << seed << ", motion " << static_cast<int>(motion);
    EXPECT_EQ(report.m_extra, 0) << "seed " << seed << ", motion " << static_cast<int>(motion);
    expected += report.m_expected;
    doubtful += report.m_doubtful;
    errs += report.m_bulletErrs;
  }
  EXPECT_GT(expected, 1000);
  EXPECT_LT(doubtful, expected / 100);
  // Bullet's GJK does not find every contact of a triangle that has a margin.
  EXPECT_LT(errs, expected / 20);
}

INSTANTIATE_TEST_SUITE_P(All, Grounds, testing::ValuesIn(kGrounds), nameOfGround);

}  // namespace
}  // namespace scatter::test
