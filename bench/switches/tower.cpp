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

struct Tower : test::PairTestWorld {
  explicit Tower(float mass) {
    constexpr float kFriction = 0.5F;
    world.setGravity(btVector3(0, -10, 0));
    addFloor()->setFriction(kFriction);
    for (int i = 0; i < kCubes; ++i)
      addBlock(btVector3(0, 0.5F + static_cast<float>(i), 0), mass)->setFriction(kFriction);
  }
};

/// Units of a budget that is there every other ten steps; 0: plain Bullet's collision, without budgets.
struct TowerTrial {
  float mass = 1.0F;
  double units = 0.0;
  int steps = 0;
};

struct Stood {
  int steps = 0;      ///< Until a cube lay, or the trial ended.
  int fastSteps = 0;  ///< With a cube faster than 2 cm/s.
};

void setUp(Tower& tower, const TowerTrial& trial) {
  if (trial.units > 0.0) return;
  auto info = tower.world.getCollisionInfo();
  info.m_pairAlgorithm = false;
  tower.world.setCollisionInfo(info);
}

void toggle(Tower& tower, const TowerTrial& trial, int step) {
  if (trial.units <= 0.0 || step < kSettled || step % kChange != 0) return;
  if (step / kChange % 2 == 0) {
    tower.world.setBudgetUnits(trial.units);
  } else {
    tower.world.removeBudget();
  }
}

Stood run(const TowerTrial& trial) {
  Tower tower(trial.mass);
  setUp(tower, trial);
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

int runTowers(int steps) {
  std::printf("%-12s %8s %8s %12s\n", "budget", "mass kg", "stands", "> 2 cm/s");
  for (const double units : {0.0, 1.0, 30.0, 60.0}) {
    for (const float mass : {1.0F, 10.0F, 100.0F}) {
      const Stood stood = run({.mass = mass, .units = units, .steps = steps});
      const std::string budget = units > 0.0 ? std::to_string(static_cast<int>(units)) + " units" : "none";
      std::printf("%-12s %8.0f %8d %10.1f %%\n", budget.c_str(), static_cast<double>(mass), stood.steps,
                  100.0 * stood.fastSteps / stood.steps);
      std::fflush(stdout);
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
