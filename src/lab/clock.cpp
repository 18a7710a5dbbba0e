#include <scatter/lab/clock.h>

#include <cassert>
#include <thread>

namespace scatter {

using Seconds = std::chrono::duration<double>;

SystemClock::SystemClock() : start_(std::chrono::steady_clock::now()) {}

double SystemClock::now() const {
  return Seconds(std::chrono::steady_clock::now() - start_).count();
}

void SystemClock::sleepUntil(double time) {
  const auto wait = std::chrono::duration_cast<std::chrono::steady_clock::duration>(Seconds(time));
  std::this_thread::sleep_until(start_ + wait);
}

void ManualClock::sleepUntil(double time) {
  if (time > now_) {
    now_ = time;
  }
}

void ManualClock::advance(double seconds) {
  assert(seconds >= 0.0);
  now_ += seconds;
}

}  // namespace scatter
