#pragma once

#include <scatter/result.h>

#include <cstdint>
#include <functional>
#include <string>

namespace scatter::io {

struct IsolationLimits {
  std::uint64_t memoryBytes = std::uint64_t{1} << 30U;  ///< On top of what this process has.
  int processorSeconds = 60;
  std::uint64_t answerBytes = std::uint64_t{1} << 30U;
};

/// What `work` returns, computed in a copy of this process, whose end does no harm to this one. `work` must
/// not write to files. Fails with a phrase such as "crashed (Segmentation fault)" or "took more than 60 s".
/// In builds with an address sanitizer the memory has no limit.
[[nodiscard]] Result<std::string> callIsolated(const std::function<std::string()>& work,
                                               const IsolationLimits& limits);

}  // namespace scatter::io
