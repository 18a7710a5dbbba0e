#pragma once

#include <vector>

namespace scatter::lab {

/// Of the last hundred frames, or of all if there are fewer; zero for none. Single frames at the end differ
/// much more from run to run.
[[nodiscard]] double meanOfLast(const std::vector<double>& values);

}  // namespace scatter::lab
