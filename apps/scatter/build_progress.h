#pragma once

#include <string>
#include <string_view>

namespace scatter::app {

/// Tells on standard error how far a build of levels is and about how long it will take yet: one line that is
/// rewritten on a terminal, else a line every few seconds. Builds that are done sooner say nothing there.
class BuildProgressLine {
 public:
  /// `what` is being built.
  explicit BuildProgressLine(std::string what);
  BuildProgressLine(const BuildProgressLine&) = delete;
  BuildProgressLine& operator=(const BuildProgressLine&) = delete;
  ~BuildProgressLine();  ///< Clears the terminal's line.

  /// As BuildProgress tells it.
  void update(std::string_view stage, double share);

 private:
  std::string what_;
  bool terminal_;
  bool shown_ = false;
  double start_;
  double lastShown_;
};

/// How much of a build is done once `share` of a stage is, 0 to 1, by what stages take on average. Unknown
/// stages come last.
[[nodiscard]] double shareOfBuild(std::string_view stage, double share);

/// "40 s", "3 min", "2 h": seconds as one says them, rounded up.
[[nodiscard]] std::string aboutSeconds(double seconds);

}  // namespace scatter::app
