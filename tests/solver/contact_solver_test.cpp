#include "solver/contact_solver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace scatter::solver {
namespace {

constexpr float kStep = 1.0F / 60;

ContactBody ball(float mass, Quad center, Quad velocity) {
  ContactBody body;
  body.center = center;
  body.center.w = 1 / mass;
  body.velocity = velocity;
  const float inertia = 2.5F / mass;
  body.inertia[0].x = body.inertia[1].y = body.inertia[2].z = inertia;
  body.linear = {1 / mass, 1 / mass, 1 / mass, 0};
  body.angular = {1, 1, 1, 0};
  body.moves = true;
  return body;
}

ProblemPoint touch(Quad place, Quad normal, float distance, float friction, float restitution) {
  ProblemPoint point;
  point.onA = point.onB = place;
  point.onA.w = distance;
  point.onB.w = friction;
  point.normal = normal;
  point.normal.w = restitution;
  point.law = {0, 0, 0.2F, 1};
  return point;
}

/// A problem that owns its points.
struct OwnProblem : ContactProblem {
  std::vector<ProblemPoint> own;
};

/// Two balls that fly towards each other along x; a is on the right.
OwnProblem twoBalls(float massA, float massB, float restitution) {
  OwnProblem problem;
  problem.bodies = {ball(massA, {1, 0, 0, 0}, {-1, 0, 0, 0}), ball(massB, {-1, 0, 0, 0}, {2, 0, 0, 0})};
  problem.own = {touch({0, 0, 0, 0}, {1, 0, 0, 0}, 0, 0, restitution)};
  problem.points = problem.own;
  problem.pairs = {{0, 1, 0, 1}};
  problem.order = {0};
  return problem;
}

/// A ball that slides over a floor of a body that does not move.
OwnProblem slidingBall(float speed, float fall, float friction) {
  OwnProblem problem;
  problem.bodies = {ball(2, {0, 1, 0, 0}, {speed, 0, 0, 0}), ContactBody{}};
  problem.bodies[0].inertia[0] = problem.bodies[0].inertia[1] = problem.bodies[0].inertia[2] = {};
  problem.bodies[0].force = {0, -fall, 0, 0};
  problem.own = {touch({0, 0, 0, 0}, {0, 1, 0, 0}, 0, friction, 0)};
  problem.points = problem.own;
  problem.pairs = {{0, 1, 0, 1}};
  problem.order = {0};
  return problem;
}

void solve(ContactSolver& solver, const ContactProblem& problem, const ContactSettings& settings,
           int iterations) {
  solver.begin(problem, settings);
  for (int i = 0; i < iterations; ++i) solver.solveVelocities();
}

TEST(ContactSolver, KeepsMomentumAndBouncesAsTheRestitutionSays) {
  ContactSolver solver;
  solve(solver, twoBalls(3, 2, 0.5F), {.timeStep = kStep}, 4);
  const float a = -1 + solver.velocities()[0].linear.x;
  const float b = 2 + solver.velocities()[1].linear.x;
  EXPECT_NEAR(3 * a + 2 * b, 3 * -1 + 2 * 2, 1e-5F);
  EXPECT_NEAR(a - b, 0.5F * 3, 1e-5F);
}

TEST(ContactSolver, StopsASlowImpactWithoutABounce) {
  OwnProblem problem = twoBalls(1, 1, 1);
  problem.bodies[0].velocity.x = -0.05F;
  problem.bodies[1].velocity.x = 0.05F;
  ContactSolver solver;
  solve(solver, problem, {.timeStep = kStep, .restitutionThreshold = 0.2F}, 4);
  EXPECT_NEAR(solver.velocities()[0].linear.x, 0.05F, 1e-6F);
}

TEST(ContactSolver, SlowsDownWhatSlidesByFrictionTimesTheWeight) {
  ContactSolver solver;
  solve(solver, slidingBall(3, 0.2F, 0.4F), {.timeStep = kStep}, 10);
  EXPECT_NEAR(solver.velocities()[0].linear.y, 0.2F, 1e-6F);
  EXPECT_NEAR(solver.velocities()[0].linear.x, -0.4F * 0.2F, 1e-6F);
}

TEST(ContactSolver, HoldsWhatFrictionCanHold) {
  ContactSolver solver;
  solve(solver, slidingBall(0.05F, 0.2F, 0.4F), {.timeStep = kStep}, 10);
  EXPECT_NEAR(solver.velocities()[0].linear.x, -0.05F, 1e-6F);
}

TEST(ContactSolver, MovesDeepBodiesApartAndLeavesTheirVelocitiesAlone) {
  OwnProblem problem = twoBalls(1, 1, 0);
  problem.bodies[0].velocity = problem.bodies[1].velocity = {};
  problem.points[0].onA.w = -0.1F;
  ContactSolver solver;
  solve(solver, problem, {.timeStep = kStep, .splits = true, .splitDepth = -0.04F}, 4);
  ASSERT_TRUE(solver.pushes());
  for (int i = 0; i < 4; ++i) solver.solvePushes();
  EXPECT_EQ(solver.velocities()[0].linear.x, 0);
  const float apart = solver.pushVelocities()[0].linear.x - solver.pushVelocities()[1].linear.x;
  EXPECT_NEAR(apart * kStep, 0.2F * 0.1F, 1e-6F);
}

TEST(ContactSolver, BeginsWithTheImpulsesThatContactsHad) {
  OwnProblem problem = slidingBall(0, 0.2F, 0);
  problem.points[0].law.x = 0.2F * 2;
  ContactSolver solver;
  solver.begin(problem, {.timeStep = kStep});
  EXPECT_NEAR(solver.velocities()[0].linear.y, 0.2F, 1e-6F);
  EXPECT_NEAR(solver.solveVelocities(), 0, 1e-10F);
}

TEST(ContactSolver, TellsItsImpulsesAndDirections) {
  const OwnProblem problem = slidingBall(3, 0.2F, 0.4F);
  ContactSolver solver;
  solve(solver, problem, {.timeStep = kStep, .frictionDirections = 2}, 10);
  int told = 0;
  ASSERT_EQ(solver.countBatches(), 1U);
  solver.forEachPoint(problem, 0, [&](int point, const ContactSolver::Place& place) {
    const ContactSolver::Impulse impulse = solver.impulseAt(place);
    EXPECT_EQ(point, 0);
    EXPECT_NEAR(impulse.normal, 2 * 0.2F, 1e-5F);
    EXPECT_NEAR(impulse.friction[0], -2 * 0.4F * 0.2F, 1e-5F);
    EXPECT_NEAR(impulse.friction[1], 0, 1e-5F);
    EXPECT_NEAR(impulse.directions[0].x, 1, 1e-5F);
    EXPECT_NEAR(std::abs(impulse.directions[1].z), 1, 1e-5F);
    ++told;
  });
  EXPECT_EQ(told, 1);
}

TEST(ContactSolver, ClampsTheFrictionOfAContactThatBearsNothing) {
  OwnProblem problem = slidingBall(1, 0.2F, 1);
  ContactSolver clamped;
  ContactSolver kept;
  clamped.begin(problem, {.timeStep = kStep, .clampsFriction = true});
  kept.begin(problem, {.timeStep = kStep, .clampsFriction = false});
  for (ContactSolver* solver : {&clamped, &kept}) {
    solver->solveVelocities();
    // Something else lifts the body off the floor.
    solver->velocities()[0].linear.y = 5;
    solver->solveVelocities();
  }
  EXPECT_NEAR(clamped.velocities()[0].linear.x, 0, 1e-5F);
  EXPECT_NEAR(kept.velocities()[0].linear.x, -0.2F, 1e-5F);
}

/// Bodies of 1 kg on each other, with 64 contacts between each two and below the lowest, under gravity.
OwnProblem stackOf(int bodies) {
  OwnProblem problem;
  problem.bodies.push_back(ContactBody{});
  for (int k = 1; k <= bodies; ++k) {
    problem.bodies.push_back(ball(1, {0, static_cast<float>(k) - 0.5F, 0, 0}, {}));
    problem.bodies.back().force = {0, -9.81F * kStep, 0, 0};
    const int first = static_cast<int>(problem.own.size());
    for (int i = 0; i < 64; ++i) {
      const Quad place{static_cast<float>(i % 8) / 7 - 0.5F, static_cast<float>(k) - 1,
                       static_cast<float>(i / 8) / 7 - 0.5F, 0};
      problem.order.push_back(static_cast<int>(problem.own.size()));
      problem.own.push_back(touch(place, {0, 1, 0, 0}, 0, 0.5F, 0));
    }
    problem.pairs.push_back({k, k - 1, first, 64});
  }
  problem.points = problem.own;
  return problem;
}

// All contacts of a pair one after another bear a pair at an iteration, and its upper end falls on.
TEST(ContactSolver, BearsAStackInOneStep) {
  const OwnProblem problem = stackOf(10);
  ContactSolver solver;
  solve(solver, problem, {.timeStep = kStep}, 10);
  for (std::size_t k = 1; k < problem.bodies.size(); ++k) {
    const float fall = 1 - solver.velocities()[k].linear.y / (9.81F * kStep);
    EXPECT_LT(fall, 0.2F) << "body " << k << " keeps this share of a step's fall";
  }
}

/// The velocities after some iterations, and the impulses of all points.
std::vector<float> solvedBy(const ContactProblem& problem, const Share& share) {
  ContactSolver solver;
  solver.begin(problem, {.timeStep = kStep}, share);
  for (int i = 0; i < 10; ++i) solver.solveVelocities();
  std::vector<float> all;
  for (const BodyVelocity& body : solver.velocities()) all.insert(all.end(), {body.linear.y, body.angular.x});
  for (std::size_t batch = 0; batch < solver.countBatches(); ++batch) {
    solver.forEachPoint(problem, batch, [&](int, const ContactSolver::Place& place) {
      all.push_back(solver.impulseAt(place).normal);
    });
  }
  return all;
}

TEST(ContactSolver, HasTheSameBitsInWhicheverOrderRowsAreMade) {
  OwnProblem problem = stackOf(200);
  for (std::size_t i = 0; i < problem.own.size(); ++i)
    problem.own[i].law.x = 0.001F * static_cast<float>(i % 7);
  int parts = 0;
  const auto backwards = [&parts](int count, const std::function<void(int)>& work) {
    for (int i = count; i-- > 0;) work(i);
    parts = count;
  };
  EXPECT_EQ(solvedBy(problem, shareWithNobody), solvedBy(problem, backwards));
  EXPECT_GT(parts, 2) << "there was nothing to share";
}

TEST(ContactSolver, IsEmptyWithoutContacts) {
  ContactProblem problem;
  problem.bodies = {ball(1, {}, {})};
  ContactSolver solver;
  solver.begin(problem, {});
  EXPECT_EQ(solver.solveVelocities(), 0);
  EXPECT_FALSE(solver.pushes());
}

}  // namespace
}  // namespace scatter::solver
