#pragma once

#include <scatter/lab/summary.h>

#include <string>

namespace scatter::app {

/// A run's summary as plain text for the terminal; ends with a new line.
[[nodiscard]] std::string formatSummary(const Summary& summary);

/// What the measurement of fidelity found, as plain text for the terminal; ends with a new line.
[[nodiscard]] std::string formatFidelity(const FidelityStatistics& fidelity);

/// What the verification of contacts found: a line, and one for each of the first missed; ends with a new
/// line.
[[nodiscard]] std::string formatContactCheck(const Summary& summary);

}  // namespace scatter::app
