#include "record_arguments.h"

#include <scatter/lab/summary.h>
#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <system_error>

#include "messages.h"

namespace scatter::app {

void addRecordArguments(CLI::App& command, RecordArguments& arguments, bool several) {
  command
      .add_option("--record", arguments.file,
                  several ? "Store each world's first run, in FILE with the world's name before its ending; "
                            "see scatter replay, diff and export"
                          : "Store the run in FILE while it runs; see scatter replay, diff and export")
      ->type_name("FILE");
  command.add_flag("--record-contacts", arguments.contacts,
                   "With --record: contact points and levels of pairs, too, in a multiple of the room");
}

std::filesystem::path recordingOf(const std::filesystem::path& file, const std::string& label) {
  return file.parent_path() / (file.stem().string() + "." + label + file.extension().string());
}

Result<void> applyRecordArguments(const RecordArguments& arguments, bool several,
                                  std::vector<RunOptions>& runs) {
  if (!arguments.file) {
    return arguments.contacts
               ? Result<void>(fail("--record-contacts says what --record FILE stores; give both"))
               : Result<void>();
  }
  const std::filesystem::path file(*arguments.file);
  std::error_code error;
  if (file.has_parent_path() && !std::filesystem::is_directory(file.parent_path(), error)) {
    return fail("--record: there is no folder " + file.parent_path().string() + "; make it first");
  }
  for (RunOptions& run : runs) {
    run.record =
        RecordOptions{.file = several ? recordingOf(file, run.label) : file, .contacts = arguments.contacts};
  }
  return {};
}

std::string formatRecording(const Run& run) {
  const RecordingCost& cost = *run.recording;
  const auto frames = static_cast<double>(std::max<std::uint64_t>(1, cost.frames));
  const double physics = std::max(1e-9, 1e-3 * run.summary.physicsCpuMs.total);
  const double perBody =
      static_cast<double>(cost.bytes) / static_cast<double>(std::max<std::uint64_t>(1, cost.movingBodies));
  return fmt::format(
      "the recording: {}, {} frames, {:.3g} MB, {:.2f} bytes a moving body a frame\n"
      "  to write a frame took {:.0f} us of the run's thread, {:.2f} % of its physics ({:.0f} us by the "
      "wall), and "
      "{:.0f} us of the writer's\n",
      cost.file.string(), cost.frames, static_cast<double>(cost.bytes) / 1e6, perBody,
      1e6 * cost.runSeconds / frames, 100.0 * cost.runSeconds / physics, 1e6 * cost.wallSeconds / frames,
      1e6 * cost.writerSeconds / frames);
}

ExitStatus checkRecording(const Run& run, ExitStatus status) {
  if (!run.recording || run.recording->failed.empty()) return status;
  printError(run.recording->failed);
  return status == ExitStatus::kOk ? ExitStatus::kFailed : status;
}

}  // namespace scatter::app
