#pragma once

#include <scatter/result.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "viewer/image.h"
#include "viewer/pane.h"

namespace scatter::viewer {

/// What a window leaves on disk, all in one folder, which is made when the first file is written.
class Outputs {
 public:
  explicit Outputs(std::filesystem::path folder) : folder_(std::move(folder)) {}

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

  /// The next picture that is drawn is written, as screenshot-N.png or into the file. Relative files lie in
  /// the working folder.
  void askForScreenshot(std::filesystem::path file = {});

  /// While it is on, every picture becomes frames-N/NNNNNN.png, for a video: `ffmpeg -i %06d.png`.
  void setRecording(bool on);
  [[nodiscard]] bool recording() const { return recording_; }

  /// Whether the next picture is wanted.
  [[nodiscard]] bool wantsPicture() const { return recording_ || !wanted_.empty(); }
  void take(const Image& picture);

  /// frames.csv, events.csv, summary.json and figures of all worlds until now.
  void writeRuns(std::vector<std::unique_ptr<Pane>>& panes);

  /// What was written last, or what went wrong.
  [[nodiscard]] const std::string& message() const { return message_; }

  /// Whether anything could not be written.
  [[nodiscard]] bool failed() const { return failed_; }

 private:
  [[nodiscard]] Result<void> prepare(const std::filesystem::path& folder) const;
  void report(const Result<void>& written, const std::filesystem::path& what);

  std::filesystem::path folder_;
  std::vector<std::filesystem::path> wanted_;
  bool recording_ = false;
  std::uint64_t screenshots_ = 0;
  std::uint64_t recordings_ = 0;
  std::uint64_t recorded_ = 0;  ///< Pictures of the recording.
  std::string message_;
  bool failed_ = false;
};

}  // namespace scatter::viewer
