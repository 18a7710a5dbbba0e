#include "lab/summary_json.h"

#include "lab/names.h"
#include "lab/text.h"

#include <cstdint>

namespace scatter::lab {

namespace {

Json timesJson(const TimeStatistics& times) {
  return {{"peak", times.peak},     {"p999", times.p999},   {"p99", times.p99},
          {"median", times.median}, {"total", times.total}, {"frames_over_budget", times.framesOverBudget}};
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
  if (!summary.stopped.empty()) {
    json["stopped"] = summary.stopped;
  }
  return json;
}

}  // namespace scatter::lab
