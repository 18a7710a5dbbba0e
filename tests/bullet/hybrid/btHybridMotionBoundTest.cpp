#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "RandomShapes.h"
#include "ScriptedWorld.h"
#include "trials.h"

// What has been proven apart may be left alone until the bodies have moved enough. These tests look for
// motions that such bookkeeping could lose.

namespace scatter::test {
namespace {

#if defined(__SANITIZE_ADDRESS__)
constexpr int kManySteps = 10000;
#else
constexpr int kManySteps = 50000;
#endif

btTransform at(const btVector3& position, const btQuaternion& turn = btQuaternion::getIdentity()) {
  return btTransform(turn, position);
}

void expectNoneMissed(const ScriptedWorld& w, const std::string& what, long leastExpected) {
  EXPECT_EQ(w.report().m_missed, 0) << what << ", of " << w.report().m_expected;
  EXPECT_GE(w.report().m_expected, leastExpected) << what;
}

/// Two bodies of random parts.
class Duo : public ScriptedWorld {
 public:
  explicit Duo(std::uint64_t seed, int parts = 8, const btVector3& offset = btVector3(0, 0, 0))
      : shapes(seed) {
    for (int i = 0; i < 2; ++i) {
      btCompoundShape* shape = shapes.compound(parts, 1);
      for (int k = 0; k < parts; ++k) {
        btTransform place = shape->getChildTransform(k);
        place.setOrigin(place.getOrigin() + offset);
        shape->updateChildTransform(k, place);
      }
      addHybrid(shapes.oneLevel(shape), at(btVector3(static_cast<float>(i) * 3, 0, 0)));
    }
  }

  RandomShapes shapes;
};

class MotionBound : public InBothModes {};
INSTANTIATE_TEST_SUITE_P(Modes, MotionBound, bothModes(), nameOfMode);

TEST_P(MotionBound, HoldsOverManyTinySteps) {
  for (const float end : {1.0F, 1000.0F}) {
    Duo w(1);
    w.world.verifyContacts(97);
    for (int i = 0; i < kManySteps; ++i) {
      // Far below what a step's rounding is, in the far case.
      const float part = static_cast<float>(i) / static_cast<float>(kManySteps);
      w.place(0, at(btVector3(end, end, 0), btQuaternion(btVector3(0, 1, 0), 0.3F * part)));
      w.place(1, at(btVector3(end + 1.6F - 1.6F * part, end, 0.2F * part),
                    btQuaternion(btVector3(1, 0, 0), part)));
      w.detect();
    }
    expectNoneMissed(w, "at " + std::to_string(end), 50);
  }
}

TEST_P(MotionBound, HoldsWhenOnlyTheTurnIsTiny) {
  Duo w(2);
  w.world.verifyContacts(101);
  w.place(0, at(btVector3(0, 0, 0)));
  for (int i = 0; i < kManySteps; ++i) {
    const float angle = 6.0F * static_cast<float>(i) / static_cast<float>(kManySteps);
    w.place(1, at(btVector3(0.9F, 0, 0), btQuaternion(btVector3(0.6F, 0, 0.8F), angle)));
    w.detect();
  }
  expectNoneMissed(w, "turning", 10);
}

TEST_P(MotionBound, HoldsForShapesFarFromTheirBodysOrigin) {
  for (const std::uint64_t seed : seeds(10, 10)) {
    Duo w(seed, 10, btVector3(100, 0, 0));
    for (int i = 0; i < 400; ++i) {
      // The origin stays; the shape swings by up to two of its lengths a step.
      const float speed = 1e-5F * std::pow(1.045F, static_cast<float>(i % 170));
      const float angle = 0.012F * std::sin(static_cast<float>(i) * speed * 40);
      w.place(0, at(btVector3(0, 0, 0)));
      w.place(1, at(btVector3(0, 0.4F, 0), btQuaternion(btVector3(0, 0, 1), angle)));
      w.detect();
    }
    expectNoneMissed(w, "seed " + std::to_string(seed), 100);
  }
}

TEST_P(MotionBound, HoldsForTheTipOfAStickThatTurnsAboutItsMiddle) {
  // The tip goes straight at the other body as fast as the turn allows: the bound is tight.
  long expected = 0;
  for (const std::uint64_t seed : seeds(80, 30)) {
    RandomShapes shapes(seed);
    ScriptedWorld w;
    auto* stick = shapes.make<btCompoundShape>();
    auto* block = shapes.make<btCompoundShape>();
    for (const float end : {-5.0F, 5.0F}) stick->addChildShape(at(btVector3(end, 0, 0)), shapes.hull(1, 12));
    for (const float side : {-0.5F, 0.5F})
      block->addChildShape(at(btVector3(0, 0, side)), shapes.hull(1, 12));
    w.addHybrid(shapes.oneLevel(block), at(btVector3(5, 0, 0), shapes.random.rotation()));
    w.addHybrid(shapes.oneLevel(stick), at(btVector3(0, 0, 0)));
    const float step = std::pow(10.0F, shapes.random.between(-4, -1));
    for (float angle = -btMin(0.5F, 2000 * step); angle < 0.5F; angle += step) {
      w.place(1, at(btVector3(0, 0, 0), btQuaternion(btVector3(0, 0, 1), angle)));
      w.detect();
    }
    expectNoneMissed(w, "seed " + std::to_string(seed), 0);
    expected += w.report().m_expected;
  }
  EXPECT_GT(expected, trials(1000));
}

TEST_P(MotionBound, HoldsForBodiesThatMoveTogether) {
  long expected = 0;
  for (const std::uint64_t seed : seeds(20, 10)) {
    Duo w(seed);
    const btTransform between = at(btVector3(0.8F, 0.1F, 0), w.shapes.random.rotation());
    const btVector3 axis = w.shapes.random.direction();
    for (int i = 0; i < 300; ++i) {
      // Nothing changes but the bounds in the world, which turn with them.
      const btTransform both = at(btVector3(0, 0.01F * static_cast<float>(i), 0),
                                  btQuaternion(axis, 0.02F * static_cast<float>(i)));
      w.place(0, both);
      w.place(1, both * between);
      w.detect();
    }
    expectNoneMissed(w, "seed " + std::to_string(seed), 0);
    expected += w.report().m_expected;
  }
  EXPECT_GT(expected, trials(1000));
}

TEST_P(MotionBound, HoldsWhenOneBodyMovesAndThenTheOther) {
  for (const std::uint64_t seed : seeds(30, 10)) {
    Duo w(seed);
    btTransform poses[2] = {at(btVector3(0, 0, 0)), at(btVector3(1.5F, 0, 0))};
    for (int i = 0; i < 600; ++i) {
      // Long rests, so that the pair goes to sleep in the algorithm, then a move of either body.
      const int mover = i / 50 % 2;
      if (i % 7 == 0) {
        poses[mover].setOrigin(w.shapes.random.inCube(0.6F));
        poses[mover].setRotation(w.shapes.random.rotation());
      }
      for (int k = 0; k < 2; ++k) w.place(k, poses[k]);
      w.detect();
    }
    expectNoneMissed(w, "seed " + std::to_string(seed), 100);
  }
}

TEST_P(MotionBound, HoldsForABodyThatLeavesAndComesBack) {
  long expected = 0;
  for (const std::uint64_t seed : seeds(40, 10)) {
    Duo w(seed);
    const btTransform home = at(btVector3(0.6F, 0.2F, 0), w.shapes.random.rotation());
    for (int i = 0; i < 200; ++i) {
      w.place(0, at(btVector3(0, 0, 0)));
      const float away = i % 4 == 0 ? 1e4F : (i % 4 == 2 ? 1.2F : 0.0F);
      btTransform pose = home;
      pose.setOrigin(home.getOrigin() + btVector3(away, 0, 0));
      w.place(1, pose);
      w.detect();
    }
    expectNoneMissed(w, "seed " + std::to_string(seed), 0);
    expected += w.report().m_expected;
  }
  EXPECT_GT(expected, trials(500));
}

TEST_P(MotionBound, ApproachesTheThresholdFromOutside) {
  long expected = 0;
  // The first step within the threshold must have the contact: the bound is tight there.
  for (const std::uint64_t seed : seeds(50, 30)) {
    Duo w(seed, 3);
    const btQuaternion turn = w.shapes.random.rotation();
    const float stepLength = std::pow(10.0F, w.shapes.random.between(-5, -1));
    const int steps = btMin(2000, static_cast<int>(2.5F / stepLength));
    for (int i = 0; i < steps; ++i) {
      w.place(0, at(btVector3(0, 0, 0)));
      w.place(1, at(btVector3(btMin(1.4F, stepLength * static_cast<float>(steps)) -
                                  stepLength * static_cast<float>(i),
                              0, 0),
                    turn));
      w.detect();
    }
    expectNoneMissed(w, "seed " + std::to_string(seed), 0);
    expected += w.report().m_expected;
  }
  EXPECT_GT(expected, trials(1000));
}

/// A cube of half a metre as a hull: its bounds are as tight as they get, and it has contacts before it
/// overlaps.
btConvexHullShape* cubeHull(RandomShapes& shapes) {
  auto* hull = shapes.make<btConvexHullShape>();
  hull->setMargin(0.01F);
  for (int corner = 0; corner < 8; ++corner) {
    const auto side = [corner](int axis) { return (corner >> axis & 1) != 0 ? 0.24F : -0.24F; };
    hull->addPoint(btVector3(side(0), side(1), side(2)), false);
  }
  hull->recalcLocalAabb();
  return hull;
}

TEST_P(MotionBound, ApproachesWithFlatSides) {
  // With and without another child pair that is in contact all the while and keeps the pair awake.
  long expected = 0;
  for (const std::uint64_t seed : seeds(110, 40)) {
    RandomShapes shapes(seed);
    ScriptedWorld w;
    btConvexHullShape* cube = cubeHull(shapes);
    auto* target = shapes.make<btCompoundShape>();
    target->addChildShape(at(btVector3(0, 0, 0)), cube);
    target->addChildShape(at(btVector3(0, 3, 0)), cube);
    auto* mover = shapes.make<btCompoundShape>();
    mover->addChildShape(at(btVector3(0, -1.5F, 0)), cube);
    if (seed % 2 == 0) mover->addChildShape(at(btVector3(0.505F, 0, 0)), cube);
    mover->addChildShape(at(btVector3(0.505F, -5, 0)), cube);
    w.addHybrid(shapes.oneLevel(target), at(btVector3(0, 0, 0)));
    w.addHybrid(shapes.oneLevel(mover), at(btVector3(0, 0, 0)));
    const float step = std::pow(10.0F, shapes.random.between(-3.5F, -1.5F));
    // Both turn alike, so that no bounds in the world are tight by accident.
    const btTransform all = at(btVector3(0, 0, 0), shapes.random.rotation(0.05F));
    w.place(0, all);
    for (float way = btMax(0.0F, 1 - 1500 * step); way < 1.1F; way += step) {
      w.place(1, all * at(btVector3(0, way, 0)));
      w.detect();
    }
    expectNoneMissed(w, "seed " + std::to_string(seed), 1);
    expected += w.report().m_expected;
  }
  EXPECT_GT(expected, trials(1000));
}

TEST_P(MotionBound, PosesThatAreNotNumbersDoNoHarm) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinite = std::numeric_limits<float>::infinity();
  for (const btVector3& bad : {btVector3(nan, nan, nan), btVector3(0.5F, nan, 0), btVector3(infinite, 0, 0),
                               btVector3(1e30F, 0, 0)}) {
    Duo w(3);
    const btTransform good = at(btVector3(0.4F, 0, 0));
    w.place(0, at(btVector3(0, 0, 0)));
    w.place(1, good);
    w.detect();
    const auto before = w.contacts();
    ASSERT_FALSE(before.empty());
    for (int i = 0; i < 5; ++i) {
      w.place(1, at(bad));
      w.detect();
    }
    btMatrix3x3 turn = btMatrix3x3::getIdentity();
    turn[0][1] = nan;
    w.place(1, btTransform(turn, btVector3(0.4F, 0, 0)));
    w.detect();
    w.place(1, good);
    w.bodies[1]->forceActivationState(DISABLE_DEACTIVATION);
    w.world.verifyContacts(1);
    w.detect();
    w.detect();
    expectNoneMissed(w, "after a bad pose", 2);
  }
}

}  // namespace
}  // namespace scatter::test
