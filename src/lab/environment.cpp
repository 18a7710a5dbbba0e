#include <scatter/lab/environment.h>

#include <sys/utsname.h>
#include <unistd.h>

#include <fstream>

#include "commit.h"

namespace scatter {

namespace {

// The value after the first `key` at a line's start, without separators and quotes.
std::string readValue(const char* file, const std::string& key) {
  std::ifstream input(file);
  std::string line;
  while (std::getline(input, line)) {
    if (line.rfind(key, 0) == 0) {
      const std::size_t begin = line.find_first_not_of(" \t:=\"", key.size());
      const std::size_t end = line.find_last_not_of(" \t\"");
      return begin == std::string::npos ? std::string() : line.substr(begin, end - begin + 1);
    }
  }
  return {};
}

std::string compilerName() {
#if defined(__clang__)
  return "clang " __clang_version__;
#elif defined(__GNUC__)
  return "gcc " __VERSION__;
#else
  return "unknown";
#endif
}

std::string systemName() {
  utsname kernel{};
  const bool known = uname(&kernel) == 0;
  const std::string distribution = readValue("/etc/os-release", "PRETTY_NAME");
  if (!known) {
    return distribution.empty() ? "unknown" : distribution;
  }
  const std::string kernelName = std::string(kernel.sysname) + ' ' + kernel.release + ' ' + kernel.machine;
  return distribution.empty() ? kernelName : distribution + ", " + kernelName;
}

}  // namespace

BuildInfo buildInfo() {
  return {.version = SCATTER_VERSION,
          .commit = SCATTER_COMMIT,
          .compiler = compilerName(),
          .buildType = SCATTER_BUILD_TYPE,
          .flags = SCATTER_BUILD_FLAGS};
}

MachineInfo machineInfo() {
  MachineInfo info;
  info.cpu = readValue("/proc/cpuinfo", "model name");
  if (info.cpu.empty()) {
    info.cpu = "unknown";
  }
  info.os = systemName();
  const long cores = sysconf(_SC_NPROCESSORS_ONLN);
  info.cores = cores > 0 ? static_cast<int>(cores) : 0;
  const long pages = sysconf(_SC_PHYS_PAGES);
  const long pageBytes = sysconf(_SC_PAGESIZE);
  if (pages > 0 && pageBytes > 0) {
    info.memoryBytes = static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(pageBytes);
  }
  return info;
}

}  // namespace scatter
