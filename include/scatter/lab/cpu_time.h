#pragma once

namespace scatter {

/// Processor seconds that the calling thread has used.
[[nodiscard]] double threadCpuSeconds();

/// Processor seconds that all threads of this process have used.
[[nodiscard]] double processCpuSeconds();

/// Wall seconds since an arbitrary time, from the system's steady clock.
[[nodiscard]] double wallSeconds();

/// How busy this process keeps the machine.
class CpuLoad {
 public:
  CpuLoad();

  /// Processor time over wall time since the last sample (or since this was made), in cores: 1 is one core
  /// kept busy. Zero if no wall time has passed.
  double sample();

 private:
  double lastCpu_;
  double lastWall_;
};

}  // namespace scatter
