#include "build_progress.h"

#include <scatter/lab/cpu_time.h>
#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "messages.h"
#include "progress_line.h"

namespace scatter::app {

namespace {

/// An estimate from less would jump about.
constexpr double kLeastSeconds = 2.0;
constexpr double kLeastShare = 0.03;

struct Stage {
  std::string_view name;
  double share;  ///< Of the time of meshes of 6000 to 124 000 triangles with 64 parts.
};
constexpr std::array<Stage, 7> kStages{{{"shells", 0.01},
                                        {"distances", 0.06},
                                        {"patches", 0.06},
                                        {"merging", 0.30},
                                        {"parts", 0.37},
                                        {"levels", 0.03},
                                        {"check", 0.17}}};

}  // namespace

double shareOfBuild(std::string_view stage, double share) {
  double done = 0.0;
  for (const Stage& known : kStages) {
    if (known.name == stage) return done + std::clamp(share, 0.0, 1.0) * known.share;
    done += known.share;
  }
  return 1.0;
}

std::string aboutSeconds(double seconds) {
  constexpr double kMinute = 60.0;
  constexpr double kHour = 3600.0;
  // From two of a unit on, so that what is rounded up is at most twice what it says.
  if (seconds < 2.0 * kMinute) return fmt::format("{:.0f} s", std::max(1.0, std::ceil(seconds)));
  if (seconds < 2.0 * kHour) return fmt::format("{:.0f} min", std::ceil(seconds / kMinute));
  return fmt::format("{:.0f} h", std::ceil(seconds / kHour));
}

BuildProgressLine::BuildProgressLine(std::string what)
    : what_(std::move(what)),
      terminal_(isatty(STDERR_FILENO) != 0),
      start_(wallSeconds()),
      lastShown_(start_) {}

BuildProgressLine::~BuildProgressLine() {
  if (shown_ && terminal_) std::fputs(kClearLine, stderr);
}

void BuildProgressLine::update(std::string_view stage, double share) {
  const double now = wallSeconds();
  if (now - lastShown_ < (terminal_ ? kTerminalSeconds : kLogSeconds)) return;
  lastShown_ = now;
  shown_ = true;
  const double done = shareOfBuild(stage, share);
  std::string line = fmt::format("{}: {}, {:.0f} %", what_, stage, 100.0 * done);
  const double taken = now - start_;
  if (taken >= kLeastSeconds && done >= kLeastShare && done < 1.0)
    line += ", about " + aboutSeconds(taken * (1.0 - done) / done) + " left";
  if (terminal_) {
    std::fprintf(stderr, "%s%s", kClearLine, line.c_str());
  } else {
    printNote(line);
  }
}

}  // namespace scatter::app
