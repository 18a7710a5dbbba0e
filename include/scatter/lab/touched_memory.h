#pragma once

#include <scatter/result.h>

#include <cstdint>

namespace scatter {

/// Counts how much of the process's own data is touched between two moments, by all its threads: in whole
/// pages, 4 KiB where nothing else is said, as Linux marks them (/proc/self). Slows down what is counted.
class TouchedMemory {
 public:
  /// From now on. Fails where the system does not count.
  [[nodiscard]] static Result<void> begin();

  /// Bytes since begin().
  [[nodiscard]] static Result<std::uint64_t> bytes();
};

}  // namespace scatter
