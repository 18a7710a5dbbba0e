#pragma once

#include <scatter/lab/summary.h>
#include <scatter/result.h>

#include "lab/summary_json.h"

#include <filesystem>

namespace scatter::lab {

/// A JSON file; fails if it cannot be read or is none.
[[nodiscard]] Result<Json> readJson(const std::filesystem::path& file);

/// What summaryJson() has written of a run and no frame table has: the engine, events, fidelity, memory and
/// checked contacts. Fails, naming the file, on what it has not written.
[[nodiscard]] Result<void> readSummary(const Json& json, const std::filesystem::path& file, Summary& summary);

}  // namespace scatter::lab
