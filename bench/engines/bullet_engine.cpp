// Plain Bullet, as `scatter run --world standard` (level 1: `--world coarsest`) has it: the reference for
// what the other programs report about the pile.

#include <scatter/bullet/bullet_physics.h>

#include "engine.h"

namespace scatter::bench {

EngineInfo engineInfo() {
  return {.program = "engine_bullet", .hullMargin = 0.02F};
}

Result<std::unique_ptr<Physics>> makeEngine(const EngineOptions& options) {
  if (options.convexRadius || options.subSteps || options.boxes) {
    return fail("Bullet's measurement has only --coarsest, --pair-algorithm and --iterations");
  }
  if (options.coarsest && options.pairAlgorithm) return fail("choose --coarsest or --pair-algorithm");
  PhysicsDef def;
  if (options.coarsest || options.pairAlgorithm) def.world = WorldKind::kHybrid;
  if (options.coarsest) def.collision.narrowphase = Narrowphase::kEngine;
  def.switching.switching = Switching::kBody;
  def.switching.policy = options.coarsest ? Policy::kCoarsest : Policy::kFinest;
  def.solverIterations = options.iterations.value_or(def.solverIterations);
  return makeBulletPhysics(def);
}

}  // namespace scatter::bench
