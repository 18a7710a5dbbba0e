#include <scatter/lab/timer.h>

#include <cassert>

namespace scatter {

Timer::Timer(const Clock& clock) : clock_(clock), lastClock_(clock.now()) {}

void Timer::start() {
  update();
  origin_ = elapsed_;
  running_ = true;
}

void Timer::pause() {
  update();
  running_ = false;
}

void Timer::resume() {
  update();
  running_ = true;
}

void Timer::reset() {
  update();
  origin_ = elapsed_;
}

void Timer::update() {
  const double now = clock_.now();
  if (running_) {
    elapsed_ += now - lastClock_;
  }
  lastClock_ = now;
}

SubTimer::SubTimer(const Timer& source, double rate)
    : source_(source), rate_(rate), lastElapsed_(source.elapsed()) {
  assert(rate >= 0.0);
}

void SubTimer::pause() {
  update();
  running_ = false;
}

void SubTimer::resume() {
  update();
  running_ = true;
}

void SubTimer::reset() {
  update();
  seconds_ = 0.0;
}

void SubTimer::update() {
  const double elapsed = source_.elapsed();
  if (running_) {
    seconds_ += (elapsed - lastElapsed_) * rate_;
  }
  lastElapsed_ = elapsed;
}

void SubTimer::setRate(double rate) {
  assert(rate >= 0.0);
  update();
  rate_ = rate;
}

}  // namespace scatter
