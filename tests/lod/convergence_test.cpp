#include "lod/convergence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "lod/fake_engine.h"
#include "lod/policy_world.h"

/// Which bodies are on their way to each other.
namespace scatter::lod {
namespace {

using testing::ball;
using testing::Random;

constexpr float kTimeStep = 1.0F / 60.0F;

/// A step, with bodies if they are due.
void advance(Convergence& convergence, const std::vector<BodyView>& bodies, float timeStep = kTimeStep) {
  convergence.advance(convergence.isDue() ? bodies : std::vector<BodyView>(), timeStep);
}

/// What it foresees of bodies that stay where they are as it looks.
PairsToCome lookAt(Convergence& convergence, const std::vector<BodyView>& bodies,
                   float timeStep = kTimeStep) {
  do {
    advance(convergence, bodies, timeStep);
  } while (!convergence.isDue());
  return convergence.pairsToCome();
}

PairsToCome firstLook(const std::vector<BodyView>& bodies, float timeStep = kTimeStep) {
  Convergence convergence;
  return lookAt(convergence, bodies, timeStep);
}

double foreseen(const std::vector<BodyView>& bodies) {
  return firstLook(bodies).foreseen;
}

TEST(Convergence, IsAPairWhenTwoMeet) {
  EXPECT_EQ(foreseen({ball({0, 0, 0}), ball({10, 0, 0}, {-5, 0, 0})}), 1.0) << "one of them lies still";
  EXPECT_EQ(foreseen({ball({0, 0, 0}, {5, 0, 0}), ball({10, 0, 0}, {-5, 0, 0})}), 1.0);
  EXPECT_EQ(foreseen({ball({0, 0, 0}, {5, 0, 0}), ball({10, 0, 0}, {10, 0, 0})}), 0.0) << "it flees";
  EXPECT_EQ(foreseen({ball({0, 0, 0}), ball({10, 0, 0}, {5, 0, 0})}), 0.0) << "it parts";
  EXPECT_EQ(foreseen({ball({0, 0, 0}), ball({10, 0, 0})}), 0.0) << "nothing moves";
}

// Two balls of 1 m meet where their centres are nearer than 1.6 m.
TEST(Convergence, IsNoneOfThoseThatPassOrAreThereAlready) {
  EXPECT_EQ(foreseen({ball({0, 0, 0}), ball({10, 1.5F, 0}, {-5, 0, 0})}), 1.0);
  EXPECT_EQ(foreseen({ball({0, 0, 0}), ball({10, 1.7F, 0}, {-5, 0, 0})}), 0.0) << "it passes by";
  EXPECT_EQ(foreseen({ball({0, 0, 0}), ball({1.5F, 0, 0}, {-5, 0, 0})}), 0.0) << "it is near now";
}

TEST(Convergence, LooksTwoSecondsOfStepsAhead) {
  const std::vector<BodyView> soon = {ball({0, 0, 0}), ball({11, 0, 0}, {-5, 0, 0})};
  const std::vector<BodyView> late = {ball({0, 0, 0}), ball({12, 0, 0}, {-5, 0, 0})};
  EXPECT_EQ(firstLook(soon).foreseen, 1.0);
  EXPECT_EQ(firstLook(late).foreseen, 0.0);
  EXPECT_EQ(firstLook(late, 2.0F * kTimeStep).foreseen, 1.0) << "as many steps are twice as long";
}

TEST(Convergence, LeavesOutWhatNothingMoves) {
  std::vector<BodyView> bodies = {ball({0, 0, 0}), ball({10, 0, 0}, {-5, 0, 0})};
  bodies[0].mass = 0.0F;
  EXPECT_EQ(foreseen(bodies), 0.0) << "a floor has bodies on it, whatever comes";
  bodies[0] = ball({0, 0, 0});
  bodies[0].present = false;
  EXPECT_EQ(foreseen(bodies), 0.0) << "a hole in the table";
}

TEST(Convergence, GivesABodyNoMorePartnersThanFitAroundIt) {
  std::vector<BodyView> bodies = {ball({0, 0, 0}, {50, 0, 0})};
  for (int i = 0; i < 40; ++i) bodies.push_back(ball({10.0F + 2.0F * static_cast<float>(i), 0, 0}));
  EXPECT_EQ(foreseen(bodies), 16.0);
}

TEST(Convergence, TakesWhatIsNoNumberForNobodyOnItsWay) {
  constexpr float kOdd[] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()};
  for (const float odd : kOdd) {
    const PairsToCome pairs = firstLook({ball({0, 0, 0}), ball({10, 0, 0}, {odd, 0, 0}), ball({odd, 5, 0})});
    EXPECT_GE(pairs.foreseen, 0.0);
    EXPECT_LE(pairs.foreseen, 3.0);
    EXPECT_GE(pairs.expected, 0.0);
    EXPECT_LE(pairs.expected, 9.0);
  }
}

TEST(Convergence, NeedsBodiesInOneStepOfEight) {
  Convergence convergence;
  const std::vector<BodyView> bodies = {ball({0, 0, 0}), ball({10, 0, 0}, {-5, 0, 0})};
  for (int step = 0; step < 40; ++step) {
    EXPECT_EQ(convergence.isDue(), step % 8 == 0) << step;
    EXPECT_EQ(convergence.pairsToCome().foreseen, step < 8 ? 0.0 : 1.0) << step;
    advance(convergence, bodies);
  }
}

/// Bodies in a box of 60 m, on their way to its middle. `speed`: metres a second for each metre from it.
std::vector<BodyView> implosion(int count, std::uint64_t seed, float speed) {
  Random random(seed);
  std::vector<BodyView> bodies;
  while (static_cast<int>(bodies.size()) < count) {
    const Vec3 at(random.uniform(-30, 30), random.uniform(-30, 30), random.uniform(-30, 30));
    bodies.push_back(ball(at, -speed * at));
  }
  return bodies;
}

TEST(Convergence, FollowsSomeOfManyBodiesForAll) {
  const std::vector<BodyView> all = implosion(1000, 3, 0.35F);
  // Those that are not followed in one look are in another: together they are all of them.
  Convergence convergence;
  double sum = 0.0;
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  constexpr int kLooks = 16;
  for (int look = 0; look < kLooks; ++look) {
    const double pairs = lookAt(convergence, all).foreseen;
    sum += pairs;
    least = std::min(least, pairs);
    most = std::max(most, pairs);
  }
  EXPECT_GT(least, 0.7 * sum / kLooks);
  EXPECT_LT(most, 1.4 * sum / kLooks);
  // In two seconds the box is three tenths as wide: of those that are within 1.6 / 0.3 m by now, those meet
  // that are not near each other already. Fewer at its surface.
  const double density = 1000.0 / (60.0 * 60.0 * 60.0);
  const double inMiddle = 4.19 * density * (std::pow(1.6 / 0.3, 3.0) - std::pow(1.6, 3.0));
  EXPECT_LT(sum / kLooks, 500.0 * inMiddle);
  EXPECT_GT(sum / kLooks, 0.7 * 500.0 * inMiddle);
}

/// Moves bodies on as they do, with a pull to the middle in m/s^2 for each metre.
void move(std::vector<BodyView>& bodies, float pull) {
  for (BodyView& body : bodies) {
    body.velocity -= kTimeStep * pull * body.center;
    body.center += kTimeStep * body.velocity;
  }
}

/// How many pairs are expected for one that is foreseen, after two seconds and two thirds.
double shareThatComes(float pull, float speed) {
  std::vector<BodyView> bodies = implosion(400, 5, speed);
  Convergence convergence;
  for (int step = 0; step < 160; ++step) {
    convergence.advance(bodies, kTimeStep);
    move(bodies, pull);
  }
  const PairsToCome pairs = convergence.pairsToCome();
  return pairs.foreseen > 0.0 ? pairs.expected / pairs.foreseen : 0.0;
}

TEST(Convergence, ExpectsAsManyAsCameOfThoseThatWereForeseen) {
  // A pull makes more of them meet than their speeds say; a push lets them turn before they do.
  EXPECT_GT(shareThatComes(0.1F, 0.2F), 1.15);
  EXPECT_LT(shareThatComes(-0.12F, 0.3F), 0.8);
  const double alone = shareThatComes(0.0F, 0.3F);
  EXPECT_GT(alone, 0.6);
  EXPECT_LT(alone, 1.5);
}

TEST(Convergence, ExpectsWhatIsForeseenBeforeAnythingIsKnown) {
  const PairsToCome pairs = firstLook(implosion(60, 7, 0.4F));
  EXPECT_GT(pairs.foreseen, 10.0);
  EXPECT_EQ(pairs.expected, pairs.foreseen);
}

}  // namespace
}  // namespace scatter::lod
