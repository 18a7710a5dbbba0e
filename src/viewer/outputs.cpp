#include "viewer/outputs.h"

#include <cstdio>
#include <system_error>
#include <utility>

#include "viewer/image_file.h"

namespace scatter::viewer {

void Outputs::askForScreenshot(std::filesystem::path file) {
  if (file.empty()) file = folder_ / ("screenshot-" + std::to_string(++screenshots_) + ".png");
  wanted_.push_back(std::move(file));
}

void Outputs::setFilming(bool on) {
  if (on && !filming_) {
    ++films_;
    filmed_ = 0;
  }
  filming_ = on;
}

void Outputs::setRecording(std::vector<std::unique_ptr<Pane>>& panes, bool on) {
  if (on) ++recordings_;
  for (const auto& pane : panes) {
    Experiment& experiment = pane->experiment();
    if (experiment.history().isRecording() == on) continue;
    const std::string label = panes.size() > 1 ? "." + pane->label() : "";
    const std::filesystem::path file = folder_ / ("run-" + std::to_string(recordings_) + label + ".rec");
    const auto done = on ? prepare(folder_).and_then([&] { return experiment.startRecording(file); })
                         : experiment.history().stopRecording();
    report(done, file);
    if (on && done) message_ = file.string() + ": is being written";
  }
}

Result<void> Outputs::prepare(const std::filesystem::path& folder) const {
  std::error_code error;
  if (!folder.empty()) std::filesystem::create_directories(folder, error);
  if (error) return fail(folder.string() + ": cannot make this folder: " + error.message());
  return {};
}

void Outputs::report(const Result<void>& written, const std::filesystem::path& what) {
  message_ = written ? what.string() + ": written" : written.error().message;
  if (!written && failure_.empty()) failure_ = message_;
}

void Outputs::take(const Image& picture) {
  for (const std::filesystem::path& file : std::exchange(wanted_, {})) {
    report(prepare(file.parent_path()).and_then([&] { return writePng(picture, file); }), file);
  }
  if (!filming_) return;
  char name[32];
  std::snprintf(name, sizeof name, "%06llu.png", static_cast<unsigned long long>(filmed_++));
  const std::filesystem::path file = folder_ / ("frames-" + std::to_string(films_)) / name;
  const auto written = prepare(file.parent_path()).and_then([&] { return writePng(picture, file); });
  report(written, file);
  filming_ = written.has_value();
}

void Outputs::writeRuns(std::vector<std::unique_ptr<Pane>>& panes) {
  for (const auto& pane : panes) {
    const std::filesystem::path folder = panes.size() > 1 ? folder_ / pane->label() : folder_;
    const auto written = pane->experiment().write(folder, true);
    report(written, folder);
    if (!written) return;
  }
}

}  // namespace scatter::viewer
