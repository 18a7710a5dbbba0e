#include "bullet/physics/stage_timer.h"

#include <cassert>
#include <cstring>

namespace scatter {

namespace {

constinit thread_local BulletStageTimer* running = nullptr;

struct KnownZone {
  const char* name;
  Stage stage;
  bool closed;
};

constexpr KnownZone kKnownZones[]{
    {"updateAabbs", Stage::kUpdateAabbs, false},
    {"predictUnconstraintMotion", Stage::kPredictMotion, false},
    {"createPredictiveContacts", Stage::kPredictMotion, false},
    {"release predictive contact manifolds", Stage::kPredictMotion, false},
    {"performDiscreteCollisionDetection", Stage::kCollisionDetection, false},
    {"dispatchAllCollisionPairs", Stage::kCollisionDetection, true},
    {"calculateSimulationIslands", Stage::kIslands, false},
    {"islandUnionFindAndQuickSort", Stage::kIslands, false},
    {"solveConstraints", Stage::kContactConstraints, false},
    {"integrateTransforms", Stage::kIntegrate, false},
    {"updateActions", Stage::kVehicles, false},
    {"updateActivationState", Stage::kActivation, false},
    {"planSwitching", Stage::kPlan, false},
};

}  // namespace

BulletStageTimer::Running::Running(BulletStageTimer& timer)
    : timer_(timer),
      enterBefore_(btGetCurrentEnterProfileZoneFunc()),
      leaveBefore_(btGetCurrentLeaveProfileZoneFunc()) {
  assert(running == nullptr && "a step inside a step");
  timer_.isRunning_ = true;
  timer_.current_ = {};
  timer_.depth_ = 0;
  timer_.nesting_ = 0;
  timer_.elapsed_ = {};
  timer_.since_ = Clock::now();
  running = &timer_;
  btSetCustomEnterProfileZoneFunc(enterHook);
  btSetCustomLeaveProfileZoneFunc(leaveHook);
}

BulletStageTimer::Running::~Running() {
  btSetCustomEnterProfileZoneFunc(enterBefore_);
  btSetCustomLeaveProfileZoneFunc(leaveBefore_);
  running = nullptr;
  timer_.isRunning_ = false;
}

BulletStageTimer::Scope::Scope(BulletStageTimer& timer, Stage stage) : timer_(timer) {
  if (!timer_.isRunning_) return;
  ++timer_.depth_;
  timer_.begin({static_cast<std::uint8_t>(stage), timer_.current_.closed});
}

BulletStageTimer::Scope::~Scope() {
  if (timer_.isRunning_) timer_.leave();
}

StageTimes BulletStageTimer::times() const {
  StageTimes milliseconds{};
  for (std::size_t stage = 0; stage < kStageCount; ++stage) {
    milliseconds[stage] = std::chrono::duration<double, std::milli>(elapsed_[stage]).count();
  }
  return milliseconds;
}

void BulletStageTimer::enterHook(const char* name) {
  if (running != nullptr) running->enter(name);
}

void BulletStageTimer::leaveHook() {
  if (running != nullptr) running->leave();
}

void BulletStageTimer::enter(const char* name) {
  ++depth_;
  if (current_.closed) return;
  const Zone zone = lookUp(name);
  if (zone.stage != Zone::kNoStage) begin(zone);
}

void BulletStageTimer::leave() {
  if (nesting_ > 0 && interrupted_[nesting_ - 1].depth == depth_) {
    countElapsed();
    current_ = interrupted_[--nesting_].zone;
  }
  --depth_;
}

void BulletStageTimer::begin(Zone zone) {
  // Deeper nesting counts for the stage around it.
  if (nesting_ == kMaxNesting) return;
  countElapsed();
  interrupted_[nesting_++] = {current_, depth_};
  current_ = zone;
}

void BulletStageTimer::countElapsed() {
  const Clock::time_point now = Clock::now();
  elapsed_[current_.stage] += now - since_;
  since_ = now;
}

BulletStageTimer::Zone BulletStageTimer::classify(const char* name) {
  for (const KnownZone& known : kKnownZones) {
    if (std::strcmp(name, known.name) == 0) return {static_cast<std::uint8_t>(known.stage), known.closed};
  }
  return {};
}

BulletStageTimer::Zone BulletStageTimer::lookUp(const char* name) {
  constexpr std::size_t kProbes = 4;
  const std::size_t start = (reinterpret_cast<std::uintptr_t>(name) >> 3U) % kSlots;
  for (std::size_t probe = 0; probe < kProbes; ++probe) {
    Slot& slot = slots_[(start + probe) % kSlots];
    if (slot.name == name) return slot.zone;
    if (slot.name != nullptr) continue;
    slot = {name, classify(name)};
    return slot.zone;
  }
  return classify(name);
}

}  // namespace scatter
