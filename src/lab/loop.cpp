#include <scatter/lab/loop.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace scatter {

namespace {

// Sums of frame times fall short of a step by rounding; such a step is due.
constexpr double kRounding = 1e-9;

}  // namespace

Loop::Loop(Clock& clock, LoopDef def)
    : clock_(clock), def_(def), timer_(clock), physicsTimer_(timer_), renderTimer_(timer_) {
  assert(def.frequency > 0.0 && def.fixedStep > 0.0 && def.maxSteps > 0);
  timer_.start();
  nextLoop_ = clock_.now();
}

void Loop::add(LoopTask kind, std::function<void()> task) {
  assert(task);
  tasks_[static_cast<std::size_t>(kind)].push_back(std::move(task));
}

void Loop::run() {
  while (!stopRequested()) {
    runOnce();
  }
}

void Loop::runOnce() {
  updateTimers();
  runTasks(LoopTask::kInput);
  runPhysics();
  runTasks(LoopTask::kProfiling);
  runTasks(LoopTask::kDebug);
  runTasks(LoopTask::kRenderer);
  runTasks(LoopTask::kFrameData);
  ++report_.loops;
  synchronise();
}

void Loop::setPhysicsRate(double rate) {
  physicsTimer_.setRate(std::clamp(rate, kMinRate, kMaxRate));
}

void Loop::singleStep() {
  pausePhysics();
  ++singleSteps_;
}

void Loop::updateTimers() {
  timer_.update();
  physicsTimer_.update();
  renderTimer_.update();
}

void Loop::runTasks(LoopTask kind) {
  for (const auto& task : tasks_[static_cast<std::size_t>(kind)]) {
    task();
  }
}

void Loop::runPhysics() {
  // Time that passed before a pause in this very loop is still due.
  accumulated_ += physicsTimer_.seconds() - lastPhysics_;
  lastPhysics_ = physicsTimer_.seconds();
  int due = 0;
  while (due < def_.maxSteps && accumulated_ + kRounding >= def_.fixedStep) {
    accumulated_ = std::max(0.0, accumulated_ - def_.fixedStep);
    ++due;
  }
  if (accumulated_ + kRounding >= def_.fixedStep) {
    const double fraction = std::fmod(accumulated_, def_.fixedStep);
    report_.droppedSeconds += accumulated_ - fraction;
    ++report_.loopsWithDropped;
    accumulated_ = fraction;
  }
  due += std::exchange(singleSteps_, 0);
  for (int step = 0; step < due && !stopRequested(); ++step) {
    runTasks(LoopTask::kPhysics);
    ++report_.steps;
  }
}

void Loop::synchronise() {
  const double period = 1.0 / def_.frequency;
  nextLoop_ += period;
  const double now = clock_.now();
  if (now > nextLoop_ + period) {
    // Too late to make up for: the next loop is due at once, those that were missed are not run.
    ++report_.lateLoops;
    nextLoop_ = now;
  }
  if (!stopRequested()) {
    clock_.sleepUntil(nextLoop_);
  }
}

}  // namespace scatter
