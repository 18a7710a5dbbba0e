// Plain Bullet, as `scatter run --world standard` (level 1: `--world coarsest`) has it: the reference for
// what the other programs report about the pile.

#include <scatter/bullet/bullet_physics.h>

#include "engine.h"

namespace scatter::bench {

EngineInfo engineInfo() {
  return {.program = "engine_bullet", .hasMargins = true};
}

Result<std::unique_ptr<Physics>> makeEngine(const EngineOptions& options, const PhysicsDef& scene) {
  if (options.convexRadius || options.subSteps || options.boxes) {
    return fail(
        "Bullet's measurement has only --coarsest, --pair-algorithm, --lean, --iterations and --threads");
  }
  if (options.coarsest + options.pairAlgorithm + options.lean > 1) {
    return fail("choose one of --coarsest, --pair-algorithm and --lean");
  }
  PhysicsDef def = scene;
  if (options.coarsest || options.pairAlgorithm || options.lean) def.world = WorldKind::kHybrid;
  if (options.coarsest) {
    def.collision.narrowphase = Narrowphase::kEngine;
    def.switching.switching = Switching::kBody;
  }
  def.switching.policy = options.coarsest ? Policy::kCoarsest : Policy::kFinest;
  if (options.lean) {
    def.solver = ContactSolver::kWide;
    def.contactsPerDirection = kUsualContactsPerDirection;
    def.collision.pairAlgorithm.recycling = kUsualRecycling;
  }
  def.threads = options.threads;
  def.solverIterations = options.iterations.value_or(def.solverIterations);
  return makeBulletPhysics(def);
}

}  // namespace scatter::bench
