#include "lab/run_folder.h"

#include <scatter/lab/output_folder.h>

#include <system_error>
#include <utility>

namespace scatter::lab {

Result<RunFolder> RunFolder::open(const std::filesystem::path& folder, const FrameData& data) {
  if (auto prepared = prepareOutputFolder(folder); !prepared) {
    return tl::unexpected(prepared.error());
  }
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  auto frames = FrameCsv::create(folder / "frames.csv", data);
  if (!frames) {
    return tl::unexpected(frames.error());
  }
  auto events = EventCsv::create(folder / "events.csv");
  if (!events) {
    return tl::unexpected(events.error());
  }
  return RunFolder(folder, std::move(*frames), std::move(*events));
}

RunFolder::RunFolder(std::filesystem::path folder, FrameCsv frames, EventCsv events)
    : folder_(std::move(folder)), frames_(std::move(frames)), events_(std::move(events)) {}

Result<void> RunFolder::addFrame(const SceneRun& run) {
  if (!begun_) {
    // What a killed program leaves behind must say so itself.
    Summary unfinished = run.summary();
    unfinished.stopped = "it was killed, or is still running: frames.csv has the whole frames until then";
    if (auto written = writeSummary(folder_ / "summary.json", unfinished); !written) {
      return written;
    }
    begun_ = true;
  }
  const World& world = run.world();
  if (auto written = events_.write(world.frame(), world.physics().switching().levelEvents()); !written) {
    return written;
  }
  auto written = frames_.write(run.data());
  if (!written) {
    events_.dropLast();
  }
  return written;
}

Result<void> RunFolder::finish(const Summary& summary) {
  return frames_.finish().and_then([this] { return events_.finish(); }).and_then([&] {
    return writeSummary(folder_ / "summary.json", summary);
  });
}

}  // namespace scatter::lab
