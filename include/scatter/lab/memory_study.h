#pragma once

#include <scatter/lab/comparison.h>

#include <string>

namespace scatter {

/// What worlds touch of their memory in a frame (RunOptions::memoryEvery), and what of it the pair algorithm
/// holds at most: a line for each world; ends with a new line.
[[nodiscard]] std::string formatMemory(const Comparison& comparison);

/// The same as CSV, in megabytes of 1e6 bytes.
[[nodiscard]] std::string memoryCsv(const Comparison& comparison);

}  // namespace scatter
