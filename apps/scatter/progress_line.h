#pragma once

#include <scatter/lab/run.h>

#include <string>

namespace scatter::app {

/// How often a line of progress is written, seconds: on a terminal, and into a log.
inline constexpr double kTerminalSeconds = 0.1;
inline constexpr double kLogSeconds = 5.0;

/// Goes back to the start of a terminal's line and clears it.
inline constexpr const char* kClearLine = "\r\033[K";

/// Tells on standard error how far long work is: one line that is rewritten on a terminal, else a line
/// every few seconds. Work that is done sooner says nothing.
class ProgressLine {
 public:
  /// `quiet`: says nothing at all.
  explicit ProgressLine(bool quiet);
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();  ///< Clears the terminal's line.

  /// `what` names the work, such as "fleet, hybrid world".
  void update(const std::string& what, const RunProgress& progress);

 private:
  bool quiet_;
  bool terminal_;
  bool shown_ = false;
  double lastShown_;
  double lastSeconds_ = 0.0;
  double slowestMs_ = 0.0;
};

}  // namespace scatter::app
