#include <scatter/lab/recorder.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

namespace scatter {

namespace {

struct CounterColumn {
  std::string_view name;
  std::uint32_t StepCounters::*member;
};

constexpr std::array kCounters{
    CounterColumn{"objects", &StepCounters::objects},
    CounterColumn{"hybrids", &StepCounters::hybrids},
    CounterColumn{"joints", &StepCounters::joints},
    CounterColumn{"overlapping_pairs", &StepCounters::overlappingPairs},
    CounterColumn{"narrowphase_pairs", &StepCounters::narrowphasePairs},
    CounterColumn{"pairs_with_hybrid", &StepCounters::pairsWithHybrid},
    CounterColumn{"pairs_without_hybrid", &StepCounters::pairsWithoutHybrid},
    CounterColumn{"manifolds", &StepCounters::manifolds},
    CounterColumn{"contacts", &StepCounters::contacts},
    CounterColumn{"new_contacts", &StepCounters::newContacts},
    CounterColumn{"requests", &StepCounters::requests},
    CounterColumn{"switches_coarser", &StepCounters::switchesCoarser},
    CounterColumn{"switches_finer", &StepCounters::switchesFiner},
    CounterColumn{"retractions", &StepCounters::retractions},
    CounterColumn{"credited_pairs", &StepCounters::creditedPairs},
    CounterColumn{"finest_pairs", &StepCounters::finestPairs},
    CounterColumn{"touching_pairs", &StepCounters::touchingPairs},
    CounterColumn{"touching_finest_pairs", &StepCounters::touchingFinestPairs},
    CounterColumn{"reused_pairs", &StepCounters::reusedPairs},
    CounterColumn{"hidden_contacts", &StepCounters::hiddenContacts},
    CounterColumn{"resting_bodies", &StepCounters::restingBodies},
    CounterColumn{"woken_bodies", &StepCounters::wokenBodies},
    CounterColumn{"iterations_left_out", &StepCounters::iterationsLeftOut},
    CounterColumn{"blocked_tries", &StepCounters::blockedTries},
    CounterColumn{"separation_queries", &StepCounters::separationQueries},
    CounterColumn{"cost_units", &StepCounters::costUnits},
    CounterColumn{"planned_units", &StepCounters::plannedUnits},
    CounterColumn{"floor_units", &StepCounters::floorUnits},
    CounterColumn{"reachable_units", &StepCounters::reachableUnits},
    CounterColumn{"budget_verdict", &StepCounters::budgetVerdict},
    CounterColumn{"withheld_pairs", &StepCounters::withheldPairs},
    CounterColumn{"overdue_pairs", &StepCounters::overduePairs},
};

struct PairWorkColumn {
  std::string_view name;
  int PairWork::*member;
};

constexpr std::array kWork{
    PairWorkColumn{"pairs_skipped", &PairWork::pairsSkipped},
    PairWorkColumn{"list_rebuilds", &PairWork::rebuilds},
    PairWorkColumn{"child_pairs", &PairWork::childPairs},
    PairWorkColumn{"child_pairs_asleep", &PairWork::childPairsAsleep},
    PairWorkColumn{"recycled", &PairWork::recycled},
    PairWorkColumn{"bounds_rejected", &PairWork::boundsRejected},
    PairWorkColumn{"axis_rejected", &PairWork::axisRejected},
    PairWorkColumn{"gjk_runs", &PairWork::gjkRuns},
    PairWorkColumn{"gjk_iterations", &PairWork::gjkIterations},
    PairWorkColumn{"detector_runs", &PairWork::detectorRuns},
    PairWorkColumn{"half_space_runs", &PairWork::halfSpaceRuns},
    PairWorkColumn{"ground_pieces", &PairWork::pieces},
};

}  // namespace

FrameRecorder::FrameRecorder(World& world, FrameData& data, double budgetMs)
    : world_(world), data_(data), budgetMs_(budgetMs) {
  addChannels();
}

void FrameRecorder::addChannels() {
  const auto real = [this](std::string_view name, const char* unit) {
    return data_.addChannel({std::string(name), unit, ChannelKind::kReal});
  };
  frame_ = data_.addChannel({"frame", "", ChannelKind::kInteger});
  time_ = real("time_s", "s");
  measured_[kWall] = real("physics_ms", "ms");
  measured_[kCpu] = real("physics_cpu_ms", "ms");
  for (std::size_t i = 0; i < kStageCount; ++i) {
    stages_[i] = real(stageColumn(static_cast<Stage>(i)), "ms");
  }
  measured_[kLoad] = real("cpu_load", "cores");
  for (const CounterColumn& counter : kCounters) {
    counters_.push_back(data_.addChannel({std::string(counter.name), "", ChannelKind::kInteger}));
  }
  for (const PairWorkColumn& count : kWork) {
    counters_.push_back(data_.addChannel({std::string(count.name), "", ChannelKind::kInteger}));
  }
  awake_ = data_.addChannel({"awake_bodies", "", ChannelKind::kInteger});
  measured_[kBudget] = real("budget_ms", "ms");
  measured_[kUnits] = real("budget_units", "");
  measured_[kRevised] = real("revised_units", "");
  measured_[kSettled] = real("settled_units", "");
  measured_[kEnergy] = real("kinetic_energy", "J");
  measured_[kPenetration] = real("max_penetration", "m");
  hash_ = data_.addChannel({"state_hash", "", ChannelKind::kHash});
}

Result<void> FrameRecorder::step() {
  const double wallBefore = wallSeconds();
  const double cpuBefore = threadCpuSeconds();
  world_.step(static_cast<float>(kStepSeconds));
  const double cpuAfter = threadCpuSeconds();
  const double wallAfter = wallSeconds();

  const Physics& physics = world_.physics();
  data_.beginFrame();
  data_.set(frame_, static_cast<double>(world_.frame()));
  data_.set(time_, static_cast<double>(world_.frame()) * kStepSeconds);
  data_.set(measured_[kWall], (wallAfter - wallBefore) * 1000.0);
  data_.set(measured_[kCpu], (cpuAfter - cpuBefore) * 1000.0);
  for (std::size_t i = 0; i < kStageCount; ++i) {
    data_.set(stages_[i], physics.stageTimes()[i]);
  }
  recordCounters();
  data_.set(measured_[kBudget], budgetMs_);
  const BudgetUnits budget = physics.switching().budgetUnits();
  data_.set(measured_[kUnits], budget.given);
  data_.set(measured_[kRevised], budget.revised);
  data_.set(measured_[kSettled], budget.settled);
  data_.set(measured_[kEnergy], physics.kineticEnergy());
  data_.set(measured_[kPenetration], physics.maxPenetration());
  data_.setHash(hash_, physics.stateHash());
  data_.set(measured_[kLoad], load_.sample());

  if (const auto broken = physics.findInvalidState()) {
    const WorldObject* object = world_.find(*broken);
    return fail("frame " + std::to_string(world_.frame()) + ": the position or velocity of object '" +
                (object != nullptr ? object->name() : std::string("?")) +
                "' is no longer a finite number; make its forces, speeds or mass ratios smaller");
  }
  return {};
}

void FrameRecorder::recordCounters() {
  const StepCounters& counters = world_.physics().counters();
  for (std::size_t i = 0; i < kCounters.size(); ++i) {
    data_.set(counters_[i], counters.*kCounters[i].member);
  }
  for (std::size_t i = 0; i < kWork.size(); ++i) {
    data_.set(counters_[kCounters.size() + i], counters.pairWork.*kWork[i].member);
  }
  const auto& objects = world_.objects();
  data_.set(awake_, static_cast<double>(std::count_if(objects.begin(), objects.end(), [](const auto& object) {
              return object->def().motion == Motion::kDynamic && !object->state().asleep;
            })));
}

}  // namespace scatter
