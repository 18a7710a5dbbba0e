#include <BulletHybrid/btHybridContactSolver.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "PairTestWorld.h"

// Towers that never sleep, with a budget that stays, or comes and goes: how long and how still do they stand,
// and what does it save?

namespace scatter::bench {
namespace {

constexpr int kCubes = 5;
constexpr int kSettled = 60;    // steps
constexpr int kChange = 10;     // steps
constexpr float kLies = 0.3F;   // metres from where a cube was when the tower had settled
constexpr float kFast = 0.02F;  // metres per second

/// Of a cube, kg: two towers of different cubes are not alike after some steps, as one rounding differs.
constexpr float kMasses[] = {0.7F, 1.0F, 2.0F, 3.0F, 5.0F, 10.0F, 20.0F, 40.0F, 70.0F, 100.0F};

/// Who finds the contacts, and who solves them.
struct TowerWorld {
  const char* name = "";
  bool isPlain = false;  ///< Bullet's collision, in the place of pairs that may switch.
  bool isWide = false;   ///< btHybridContactSolver, in the place of Bullet's.
};

struct TowerBudget {
  double units = 0.0;  ///< 0: none.
  bool stays = false;  ///< Not every other ten steps only.
};

struct TowerTrial {
  TowerWorld world{};
  TowerBudget budget{};
  float mass = 1.0F;
  int steps = 0;
};

struct Tower : test::PairTestWorld {
  /// The solver must outlive the tower.
  Tower(const TowerTrial& trial, btHybridContactSolver& wide) {
    constexpr float kFriction = 0.5F;
    auto collision = world.getCollisionInfo();
    collision.m_pairAlgorithm = !trial.world.isPlain;
    world.setCollisionInfo(collision);
    if (trial.world.isWide) world.setConstraintSolver(&wide);
    world.setGravity(btVector3(0, -10, 0));
    addFloor()->setFriction(kFriction);
    for (int i = 0; i < kCubes; ++i)
      addBlock(btVector3(0, 0.5F + static_cast<float>(i), 0), trial.mass)->setFriction(kFriction);
  }
};

struct Stood {
  int steps = 0;       ///< Until a cube lay, or the trial ended.
  int fastSteps = 0;   ///< With a cube faster than 2 cm/s.
  double units = 0.0;  ///< Of all steps.
};

void changeBudget(Tower& tower, const TowerBudget& budget, int step) {
  if (budget.units <= 0.0 || step < kSettled || step % kChange != 0) return;
  if (budget.stays && step > kSettled) return;
  if (budget.stays || step / kChange % 2 == 0) {
    tower.world.setBudgetUnits(budget.units);
  } else {
    tower.world.removeBudget();
  }
}

Stood run(const TowerTrial& trial) {
  btHybridContactSolver wide;
  Tower tower(trial, wide);
  Stood stood;
  std::vector<btVector3> start;
  for (; stood.steps < trial.steps; ++stood.steps) {
    changeBudget(tower, trial.budget, stood.steps);
    tower.step();
    float furthest = 0.0F;
    float fastest = 0.0F;
    for (std::size_t i = 0; i < tower.bodies.size(); ++i) {
      const btVector3& place = tower.bodies[i]->getWorldTransform().getOrigin();
      if (stood.steps == kSettled) start.push_back(place);
      if (stood.steps <= kSettled) continue;
      furthest = std::max(furthest, place.distance(start[i]));
      fastest = std::max(fastest, tower.bodies[i]->getLinearVelocity().length());
    }
    if (furthest > kLies) break;
    stood.fastSteps += fastest > kFast ? 1 : 0;
    stood.units += tower.pairInfo().units;
  }
  return stood;
}

void printHead() {
  std::printf("%-13s %-24s %8s %14s %9s %15s %7s\n", "world", "budget", "still", "steps until it", "> 2 cm/s",
              "least, most", "units");
  std::printf("%-13s %-24s %8s %14s %9s %15s %7s\n", "", "", "stand", "lies, median", "mean", "", "a step");
}

std::string describe(const TowerBudget& budget) {
  if (budget.units <= 0.0) return "none";
  return std::to_string(static_cast<int>(budget.units)) + " units" + (budget.stays ? "" : ", comes and goes");
}

void runTowersOf(const TowerWorld& world, const TowerBudget& budget, int steps) {
  std::vector<int> until;
  std::vector<double> fast;
  double units = 0.0;
  int all = 0;
  for (const float mass : kMasses) {
    const Stood stood = run({.world = world, .budget = budget, .mass = mass, .steps = steps});
    until.push_back(stood.steps);
    fast.push_back(100.0 * stood.fastSteps / stood.steps);
    units += stood.units;
    all += stood.steps;
  }
  std::ranges::sort(until);
  std::ranges::sort(fast);
  double mean = 0.0;
  for (const double share : fast) mean += share / static_cast<double>(fast.size());
  std::printf("%-13s %-24s %2d of %2d %14d %7.1f %% %6.1f, %4.1f %%", world.name, describe(budget).c_str(),
              static_cast<int>(std::ranges::count(until, steps)), static_cast<int>(until.size()),
              until[until.size() / 2], mean, fast.front(), fast.back());
  // Plain collision is not counted.
  if (world.isPlain) {
    std::printf("%8s\n", "-");
  } else {
    std::printf("%8.0f\n", units / all);
  }
  std::fflush(stdout);
}

int runTowers(int steps) {
  printHead();
  runTowersOf({"plain", true, false}, {}, steps);
  for (const TowerWorld& world :
       {TowerWorld{"hybrid", false, false}, TowerWorld{"hybrid, wide", false, true}}) {
    runTowersOf(world, {}, steps);
    for (const bool stays : {true, false}) {
      for (const double units : {1.0, 30.0, 60.0, 75.0})
        runTowersOf(world, {.units = units, .stays = stays}, steps);
    }
  }
  return 0;
}

}  // namespace
}  // namespace scatter::bench

int main(int argc, char** argv) {
  int steps = 20000;
  CLI::App app("Towers of five cubes of eight boxes that never sleep, without a budget and with one");
  app.add_option("--steps", steps, "at most")->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  return scatter::bench::runTowers(steps);
}
