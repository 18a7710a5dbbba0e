#pragma once

#include <cstdint>
#include <string>

namespace scatter {

/// What this library was built as.
struct BuildInfo {
  std::string version;    ///< Of Scatter.
  std::string commit;     ///< Of its sources, with "-dirty" if they were changed; "unknown" without git.
  std::string compiler;   ///< Such as "gcc 12.2.0".
  std::string buildType;  ///< Such as "Release".
  std::string flags;      ///< The compiler's options.
};

/// What it runs on.
struct MachineInfo {
  std::string cpu;
  int cores = 0;  ///< Logical processors that are online.
  std::string os;
  std::uint64_t memoryBytes = 0;
};

[[nodiscard]] BuildInfo buildInfo();

/// What cannot be found out is "unknown" or 0.
[[nodiscard]] MachineInfo machineInfo();

}  // namespace scatter
