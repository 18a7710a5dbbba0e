#pragma once

#include <scatter/lab/summary.h>

#include <string>

namespace scatter::app {

/// A run's summary as plain text for the terminal; ends with a new line.
[[nodiscard]] std::string formatSummary(const Summary& summary);

}  // namespace scatter::app
