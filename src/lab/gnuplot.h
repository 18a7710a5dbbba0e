#pragma once

#include <scatter/result.h>

#include <filesystem>
#include <string>
#include <vector>

namespace scatter::lab {

/// Runs the gnuplot program with these arguments in `folder`. Fails if there is none (the message names the
/// package) and, with gnuplot's own words, if it does not succeed.
[[nodiscard]] Result<void> runGnuplot(const std::vector<std::string>& arguments,
                                      const std::filesystem::path& folder);

}  // namespace scatter::lab
