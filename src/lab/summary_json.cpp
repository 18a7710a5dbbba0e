#include "lab/summary_json.h"

#include "lab/names.h"
#include "lab/text.h"

#include <algorithm>
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
  const PairSteps& steps = collision.pairAlgorithm;
  Json json{{"narrowphase", nameOf(collision.narrowphase)}, {"verify_every", collision.verifyEvery}};
  if (collision.narrowphase == Narrowphase::kScatter) {
    json["pair_algorithm"] = {{"midphase", nameOf(steps.midphase)},
                              {"motion_bound", steps.motionBound},
                              {"cached_axis", steps.cachedAxis},
                              {"lazy_manifolds", steps.lazyManifolds},
                              {"own_gjk", steps.ownGjk},
                              {"warm_simplex", steps.warmSimplex},
                              {"recycling", steps.recycling},
                              {"passages", steps.passages}};
  }
  return json;
}

Json switchingJson(const SwitchingDef& switching) {
  Json json{{"mode", nameOf(switching.switching)},         {"policy", nameOf(switching.policy)},
            {"proximity_steps", switching.proximitySteps}, {"retry_interval", switching.retryInterval},
            {"quiet_steps", switching.quietSteps},         {"safety_gap", switching.safetyGap},
            {"load_fine_pairs", switching.loadFinePairs},  {"safety_conditions", switching.safetyConditions}};
  if (switching.switching == Switching::kPair) {
    const BudgetDef& budget = switching.budget;
    json["policies"] = switching.policies;
    json["budget"] = {{"milliseconds", budget.milliseconds},
                      {"units", budget.units},
                      {"machine_steps", budget.machine.size()},
                      {"replayed_steps", budget.recorded.size()}};
    json["credit"] = switching.credit;
    json["credit_level"] = switching.creditLevel;
  }
  return json;
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

Json eventsByPolicyJson(const Summary& summary) {
  Json policies = Json::object();
  for (const auto& [policy, counts] : summary.levelEventsByPolicy) {
    policies[policy] = eventsJson(counts);
  }
  return policies;
}

Json fidelityJson(const FidelityStatistics& fidelity) {
  Json shares = Json::array();
  for (std::size_t below = 0; below < fidelity.touchingByLevel.size(); ++below) {
    shares.push_back({{"levels_below_finest", below},
                      {"touching_pairs", fidelity.touchingByLevel[below]},
                      {"share", fidelity.share(below)}});
  }
  return {{"every", fidelity.every},
          {"samples", fidelity.samples},
          {"touching_pairs", fidelity.touchingPairs()},
          {"visible_overlap_pairs",
           {{"mean", fidelity.visibleOverlapMean},
            {"peak", fidelity.visibleOverlapPeak},
            {"per_100_touching", fidelity.visibleOverlapPer100}}},
          {"contact_gaps", fidelity.contactGaps},
          {"contact_gap_p95", fidelity.contactGapP95},
          {"contact_gap_p95_percent", fidelity.contactGapP95Percent()},
          {"contact_gap_max", fidelity.contactGapMax},
          {"length", fidelity.length},
          {"length_is", "mean over the hybrids of the longest side of the finest level's box, metres"},
          {"touching_by_level", std::move(shares)},
          {"finest_share",
           {{"mean", fidelity.finestShareMean},
            {"worst", fidelity.finestShareWorst},
            {"worst_frame", fidelity.finestShareWorstFrame}}},
          {"largest_jump", fidelity.largestJump},
          {"largest_jump_frame", fidelity.largestJumpFrame},
          {"impact",
           {{"first_frame", fidelity.impactFrame},
            {"finest_share", fidelity.impactFinestShare},
            {"contact_gap_p95", fidelity.impactContactGapP95},
            {"visible_overlaps_per_100_touching", fidelity.impactVisibleOverlapPer100}}},
          {"pile_radius", fidelity.pileRadius},
          {"kinetic_energy_last_100_mean", fidelity.kineticEnergyEnd}};
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

Json runOptionsJson(const Summary& summary) {
  const PhysicsDef& physics = summary.physics;
  Json options{{"world", nameOf(physics.world)},
               {"frames", std::max(summary.framesAsked, summary.frames)},
               {"seed", summary.seed},
               {"budget_ms", summary.budgetMs},
               {"profiling", physics.profiling},
               {"solver", nameOf(physics.solver)},
               {"contacts_per_direction", physics.contactsPerDirection},
               {"threads", physics.threads},
               {"solver_iterations", physics.solverIterations},
               {"gravity", {physics.gravity.x, physics.gravity.y, physics.gravity.z}}};
  if (physics.world == WorldKind::kHybrid) {
    options["collision"] = collisionJson(physics.collision);
    options["switching"] = switchingJson(physics.switching);
  }
  return options;
}

Json buildJson(const BuildInfo& build) {
  return {{"version", build.version},
          {"commit", build.commit},
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
            {"complete", summary.stopped.empty()},
            {"frames", summary.frames},
            {"options", runOptionsJson(summary)},
            {"build", buildJson(summary.build)},
            {"machine", machineJson(summary.machine)},
            {"physics_ms", timesJson(summary.physicsMs)},
            {"physics_cpu_ms", timesJson(summary.physicsCpuMs)},
            {"totals", countersJson(summary, &CounterStatistics::total)},
            {"peaks", countersJson(summary, &CounterStatistics::peak)},
            {"level_events", eventsJson(summary.levelEvents)},
            {"level_events_by_policy", eventsByPolicyJson(summary)},
            {"state_hash", hexNumber(summary.stateHash)}};
  if (summary.collisionMemory.pairs > 0) {
    json["collision_memory"] = memoryJson(summary.collisionMemory);
  }
  if (summary.contactCheck.steps > 0) {
    json["contact_check"] = contactsJson(summary.contactCheck);
  }
  if (summary.fidelity.every > 0) {
    json["fidelity"] = fidelityJson(summary.fidelity);
  }
  if (!summary.stopped.empty()) {
    json["stopped"] = summary.stopped;
  }
  return json;
}

}  // namespace scatter::lab
