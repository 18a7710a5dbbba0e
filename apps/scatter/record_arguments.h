#pragma once

#include <scatter/lab/run.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "command.h"

namespace scatter::app {

/// The arguments that say whether a run is stored, as they stand on the command line.
struct RecordArguments {
  std::optional<std::string> file;
  bool contacts = false;
};

/// `several`: there are several worlds, and a file for each. `arguments` must outlive the parsing.
void addRecordArguments(CLI::App& command, RecordArguments& arguments, bool several);

/// The file of the world with this label, one of several: "out/fleet.rec" is "out/fleet.standard.rec".
[[nodiscard]] std::filesystem::path recordingOf(const std::filesystem::path& file, const std::string& label);

/// Puts what is asked for into the runs, of which several have a file each. Fails on --record-contacts
/// without --record, and on a folder that does not exist.
[[nodiscard]] Result<void> applyRecordArguments(const RecordArguments& arguments, bool several,
                                                std::vector<RunOptions>& runs);

/// What the recording is and what it has cost, a line or two; ends with a new line.
[[nodiscard]] std::string formatRecording(const Run& run);

/// Says that the recording is not whole, if that is so; the status is then that of a failure.
[[nodiscard]] ExitStatus checkRecording(const Run& run, ExitStatus status);

}  // namespace scatter::app
