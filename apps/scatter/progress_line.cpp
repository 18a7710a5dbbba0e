#include "progress_line.h"

#include <scatter/lab/cpu_time.h>
#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "messages.h"

namespace scatter::app {

ProgressLine::ProgressLine(bool quiet)
    : quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0), lastShown_(wallSeconds()) {}

ProgressLine::~ProgressLine() {
  if (shown_ && terminal_) {
    std::fputs(kClearLine, stderr);
  }
}

void ProgressLine::update(const std::string& what, const RunProgress& progress) {
  if (progress.frame <= 1) {
    lastSeconds_ = 0.0;
    slowestMs_ = 0.0;
  }
  slowestMs_ = std::max(slowestMs_, 1000.0 * (progress.seconds - lastSeconds_));
  lastSeconds_ = progress.seconds;
  const double now = wallSeconds();
  if (quiet_ || now - lastShown_ < (terminal_ ? kTerminalSeconds : kLogSeconds)) {
    return;
  }
  lastShown_ = now;
  shown_ = true;
  const std::string line = fmt::format("{}: frame {} of {} ({} %), slowest {:.1f} ms", what, progress.frame,
                                       progress.frames, 100 * progress.frame / progress.frames, slowestMs_);
  if (terminal_) {
    std::fprintf(stderr, "%s%s", kClearLine, line.c_str());
  } else {
    printNote(line);
  }
}

}  // namespace scatter::app
