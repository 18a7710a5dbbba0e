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
  void setFilming(bool on);
  [[nodiscard]] bool filming() const { return filming_; }

  /// While it is on, the runs of all worlds are stored, from the oldest frame that is kept on: run-N.rec, or
  /// run-N.LABEL.rec if there are several.
  void setRecording(std::vector<std::unique_ptr<Pane>>& panes, bool on);

  /// Whether the next picture is wanted.
  [[nodiscard]] bool wantsPicture() const { return filming_ || !wanted_.empty(); }
  void take(const Image& picture);

  /// frames.csv, events.csv, summary.json and figures of all worlds until now.
  void writeRuns(std::vector<std::unique_ptr<Pane>>& panes);

  /// What was written last, or what went wrong.
  [[nodiscard]] const std::string& message() const { return message_; }

  /// What went wrong first, whatever was written since; empty if nothing did.
  [[nodiscard]] const std::string& failure() const { return failure_; }

 private:
  [[nodiscard]] Result<void> prepare(const std::filesystem::path& folder) const;
  void report(const Result<void>& written, const std::filesystem::path& what);

  std::filesystem::path folder_;
  std::vector<std::filesystem::path> wanted_;
  bool filming_ = false;
  std::uint64_t screenshots_ = 0;
  std::uint64_t films_ = 0;
  std::uint64_t filmed_ = 0;  ///< Pictures of the film.
  std::uint64_t recordings_ = 0;
  std::string message_;
  std::string failure_;
};

}  // namespace scatter::viewer
