#include "lab/run_files.h"

#include <scatter/lab/frame_csv.h>

#include <system_error>

namespace scatter::lab {

Result<void> writeRunFiles(const std::filesystem::path& folder, const FrameTable& table,
                           const std::vector<FrameEvent>* events, const Summary& summary) {
  std::error_code error;
  std::filesystem::create_directory(folder, error);
  if (error) {
    return fail("cannot make folder " + folder.string() + ": " + error.message() +
                "; choose another output folder");
  }
  if (auto written = writeFrameCsv(folder / "frames.csv", table); !written) {
    return written;
  }
  if (events != nullptr) {
    if (auto written = writeEventCsv(folder / "events.csv", *events); !written) {
      return written;
    }
  }
  return writeSummary(folder / "summary.json", summary);
}

FigureWorld figureWorld(const RunOptions& options, const FrameTable& table) {
  return {
      .label = options.label,
      .table = &table,
      .governedMs = isClockGoverned(options.physics) ? options.physics.switching.budget.milliseconds : 0.0};
}

}  // namespace scatter::lab
