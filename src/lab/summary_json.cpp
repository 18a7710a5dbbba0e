#include "lab/summary_json.h"

#include "lab/names.h"
#include "lab/text.h"

#include <cstdint>

namespace scatter::lab {

namespace {

Json timesJson(const TimeStatistics& times) {
  return {{"peak", times.peak},
          {"p999", times.p999},
          {"p99", times.p99},
          {"median", times.median},
          {"total", times.total},
          {"last_100_mean", times.lastHundred},
          {"frames_over_budget", times.framesOverBudget}};
}

Json collisionJson(const CollisionDef& collision) {
  const PairAlgorithmDef& steps = collision.pairAlgorithm;
  Json json{{"narrowphase", nameOf(collision.narrowphase)}, {"verify_every", collision.verifyEvery}};
  if (collision.narrowphase == Narrowphase::kScatter) {
    json["pair_algorithm"] = {{"midphase", nameOf(steps.midphase)},
                              {"motion_bound", steps.motionBound},
                              {"cached_axis", steps.cachedAxis},
                              {"lazy_manifolds", steps.lazyManifolds},
                              {"own_gjk", steps.ownGjk},
                              {"warm_simplex", steps.warmSimplex}};
  }
  return json;
}

Json optionsJson(const Summary& summary) {
  const PhysicsDef& physics = summary.physics;
  const SwitchingDef& switching = physics.switching;
  Json options{{"world", nameOf(physics.world)},
               {"frames", summary.frames},
               {"seed", summary.seed},
               {"budget_ms", summary.budgetMs},
               {"profiling", physics.profiling},
               {"solver_iterations", physics.solverIterations},
               {"gravity", {physics.gravity.x, physics.gravity.y, physics.gravity.z}}};
  if (physics.world == WorldKind::kHybrid) {
    options["collision"] = collisionJson(physics.collision);
    options["switching"] = {{"policy", nameOf(switching.policy)},
                            {"proximity_steps", switching.proximitySteps},
                            {"retry_interval", switching.retryInterval},
                            {"quiet_steps", switching.quietSteps},
                            {"safety_gap", switching.safetyGap},
                            {"load_fine_pairs", switching.loadFinePairs},
                            {"safety_conditions", switching.safetyConditions}};
  }
  return options;
}

// Sums of counts are whole numbers.
Json countersJson(const Summary& summary, double CounterStatistics::*figure) {
  Json counters = Json::object();
  for (const CounterStatistics& counter : summary.counters) {
    counters[counter.name] = static_cast<std::uint64_t>(counter.*figure);
  }
  return counters;
}

Json eventsJson(const LevelEventCounts& counts) {
  Json events = Json::object();
  for (std::size_t i = 0; i < counts.size(); ++i) {
    events[nameOf(static_cast<LevelEventKind>(i))] = counts[i];
  }
  return events;
}

Json memoryJson(const CollisionMemory& memory) {
  return {{"is", "what the pair algorithm held in the frame with the most child pairs"},
          {"pairs", memory.pairs},
          {"child_pairs", memory.childPairs},
          {"pair_bytes", memory.pairBytes},
          {"child_pair_bytes", memory.childPairBytes},
          {"body_bytes", memory.bodyBytes},
          {"part_bytes", memory.partBytes}};
}

Json contactsJson(const ContactCheck& check) {
  Json first = Json::array();
  for (const FrameMiss& miss : check.firstMissed) {
    first.push_back({{"frame", miss.frame},
                     {"body_a", miss.contact.bodyA},
                     {"part_a", miss.contact.childA},
                     {"body_b", miss.contact.bodyB},
                     {"part_b", miss.contact.childB},
                     {"distance", miss.contact.distance}});
  }
  return {{"frames_verified", check.steps}, {"child_pairs", check.childPairs},
          {"expected", check.expected},     {"missed", check.missed},
          {"extra", check.extra},           {"doubtful", check.doubtful},
          {"first_missed", first}};
}

}  // namespace

Json buildJson(const BuildInfo& build) {
  return {{"version", build.version},
          {"compiler", build.compiler},
          {"type", build.buildType},
          {"flags", build.flags}};
}

Json machineJson(const MachineInfo& machine) {
  return {{"cpu", machine.cpu},
          {"cores", machine.cores},
          {"os", machine.os},
          {"memory_bytes", machine.memoryBytes}};
}

Json summaryJson(const Summary& summary) {
  Json json{{"scene", summary.scene},
            {"label", summary.label},
            {"engine", summary.engine},
            {"options", optionsJson(summary)},
            {"build", buildJson(summary.build)},
            {"machine", machineJson(summary.machine)},
            {"physics_ms", timesJson(summary.physicsMs)},
            {"physics_cpu_ms", timesJson(summary.physicsCpuMs)},
            {"totals", countersJson(summary, &CounterStatistics::total)},
            {"peaks", countersJson(summary, &CounterStatistics::peak)},
            {"level_events", eventsJson(summary.levelEvents)},
            {"state_hash", hexNumber(summary.stateHash)}};
  if (summary.collisionMemory.pairs > 0) {
    json["collision_memory"] = memoryJson(summary.collisionMemory);
  }
  if (summary.contactCheck.steps > 0) {
    json["contact_check"] = contactsJson(summary.contactCheck);
  }
  if (!summary.stopped.empty()) {
    json["stopped"] = summary.stopped;
  }
  return json;
}

}  // namespace scatter::lab
