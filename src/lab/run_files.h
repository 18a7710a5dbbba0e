#pragma once

#include <scatter/lab/event_csv.h>
#include <scatter/lab/figures.h>
#include <scatter/lab/frame_table.h>
#include <scatter/lab/run.h>
#include <scatter/lab/summary.h>
#include <scatter/result.h>

#include <filesystem>
#include <vector>

namespace scatter::lab {

/// Writes frames.csv, events.csv and summary.json of a whole run into a folder, which is made if it does not
/// exist; no events.csv if `events` is null.
[[nodiscard]] Result<void> writeRunFiles(const std::filesystem::path& folder, const FrameTable& table,
                                         const std::vector<FrameEvent>* events, const Summary& summary);

/// A run as figures show it. The table must outlive it.
[[nodiscard]] FigureWorld figureWorld(const RunOptions& options, const FrameTable& table);

}  // namespace scatter::lab
