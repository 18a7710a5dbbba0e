#include <BulletHybrid/btHybridContactSolver.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "PairTestWorld.h"

// A tower that never sleeps, with a budget that comes and goes: how long does it stand, and how still?

namespace scatter::bench {
namespace {

constexpr int kCubes = 5;
constexpr int kSettled = 60;    // steps
constexpr int kChange = 10;     // steps
constexpr float kLies = 0.3F;   // metres from where a cube was when the tower had settled
constexpr float kFast = 0.02F;  // metres per second

/// Who finds the contacts, and who solves them.
struct TowerWorld {
  const char* name = "";
  bool isPlain = false;  ///< Bullet's collision, in the place of pairs that may switch.
  bool isWide = false;   ///< btHybridContactSolver, in the place of Bullet's.
};

struct TowerTrial {
  TowerWorld world{};
  float mass = 1.0F;
  double units = 0.0;  ///< Of a budget that is there every other ten steps; 0: none.
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
  int steps = 0;      ///< Until a cube lay, or the trial ended.
  int fastSteps = 0;  ///< With a cube faster than 2 cm/s.
};

void toggle(Tower& tower, const TowerTrial& trial, int step) {
  if (trial.units <= 0.0 || step < kSettled || step % kChange != 0) return;
  if (step / kChange % 2 == 0) {
    tower.world.setBudgetUnits(trial.units);
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
    toggle(tower, trial, stood.steps);
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
  }
  return stood;
}

void print(const TowerTrial& trial, const Stood& stood) {
  const std::string budget =
      trial.units > 0.0 ? std::to_string(static_cast<int>(trial.units)) + " units" : "none";
  std::printf("%-14s %-10s %8.0f %8d %10.1f %%\n", trial.world.name, budget.c_str(),
              static_cast<double>(trial.mass), stood.steps, 100.0 * stood.fastSteps / stood.steps);
  std::fflush(stdout);
}

int runTowers(int steps) {
  std::printf("%-14s %-10s %8s %8s %12s\n", "world", "budget", "mass kg", "stands", "> 2 cm/s");
  for (const TowerWorld& world : {TowerWorld{"plain", true, false}, TowerWorld{"hybrid", false, false},
                                  TowerWorld{"hybrid, wide", false, true}}) {
    for (const double units : {0.0, 1.0, 30.0, 60.0}) {
      if (world.isPlain && units > 0.0) continue;
      for (const float mass : {1.0F, 10.0F, 100.0F}) {
        const TowerTrial trial{.world = world, .mass = mass, .units = units, .steps = steps};
        print(trial, run(trial));
      }
    }
  }
  return 0;
}

}  // namespace
}  // namespace scatter::bench

int main(int argc, char** argv) {
  int steps = 20000;
  CLI::App app("A tower of five cubes of eight boxes, whose budget comes and goes every ten steps");
  app.add_option("--steps", steps, "at most")->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  return scatter::bench::runTowers(steps);
}
