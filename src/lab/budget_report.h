#pragma once

#include <scatter/lab/run.h>

#include <string>

namespace scatter::lab {

/// How a run's budget was kept, in words: in how many frames it was not, by how much, and what could not have
/// been given up in them. `isRepeated`: the run is one of several. Ends with a full stop; empty if the world
/// has no budget.
[[nodiscard]] std::string budgetSentence(const Run& run, bool isRepeated);

}  // namespace scatter::lab
