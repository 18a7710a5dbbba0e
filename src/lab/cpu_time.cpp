#include <scatter/lab/cpu_time.h>

#include <ctime>

namespace scatter {

namespace {

double secondsOf(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

}  // namespace

double threadCpuSeconds() {
  return secondsOf(CLOCK_THREAD_CPUTIME_ID);
}

double processCpuSeconds() {
  return secondsOf(CLOCK_PROCESS_CPUTIME_ID);
}

double wallSeconds() {
  return secondsOf(CLOCK_MONOTONIC);
}

CpuLoad::CpuLoad() : lastCpu_(processCpuSeconds()), lastWall_(wallSeconds()) {}

double CpuLoad::sample() {
  const double cpu = processCpuSeconds();
  const double wall = wallSeconds();
  const double passed = wall - lastWall_;
  const double load = passed > 0.0 ? (cpu - lastCpu_) / passed : 0.0;
  lastCpu_ = cpu;
  lastWall_ = wall;
  return load;
}

}  // namespace scatter
