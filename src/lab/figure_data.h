#pragma once

#include <scatter/lab/figures.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace scatter::lab {

/// Frames, both ends included.
struct FrameRange {
  double first = 0.0;
  double last = 0.0;
};

struct FramePeak {
  double frame = 0.0;
  double value = 0.0;
};

/// What figures are drawn from: the tables of all worlds, and their common axes.
class FigureData {
 public:
  /// Every world has at least one frame.
  FigureData(std::vector<FigureWorld> worlds, FigureOptions options);

  [[nodiscard]] std::size_t worlds() const { return worlds_.size(); }
  [[nodiscard]] const std::string& label(std::size_t world) const { return worlds_[world].label; }
  [[nodiscard]] double governedMs(std::size_t world) const { return worlds_[world].governedMs; }
  [[nodiscard]] const FigureOptions& options() const { return options_; }

  [[nodiscard]] FrameRange allFrames() const;

  /// 5 % of the frames on either side of the first world's peak of physics_cpu_ms, at least 25.
  [[nodiscard]] FrameRange peakFrames() const;

  /// The highest value of a column in one world.
  [[nodiscard]] FramePeak peak(std::size_t world, std::string_view column) const;

  /// The highest value of a column in any world in these frames.
  [[nodiscard]] double highest(std::string_view column, const FrameRange& frames) const;

  /// The same in one world.
  [[nodiscard]] double highest(std::size_t world, std::string_view column, const FrameRange& frames) const;

  /// How many of a world's frames in the range have more than `limit`.
  [[nodiscard]] int countAbove(std::size_t world, std::string_view column, const FrameRange& frames,
                               double limit) const;

  /// Writes each world's numbers into `folder`, one line a frame.
  [[nodiscard]] Result<void> write(const std::filesystem::path& folder) const;

  [[nodiscard]] static std::string fileOf(std::size_t world) {
    return "world" + std::to_string(world) + ".dat";
  }

  /// gnuplot's number of a column in those files.
  [[nodiscard]] static int columnOf(std::string_view name);

  /// gnuplot's number of the column with the sum of the first `stages` stages.
  [[nodiscard]] static int stackColumn(std::size_t stages);

 private:
  [[nodiscard]] std::vector<double> valuesIn(std::size_t world, std::string_view column,
                                             const FrameRange& frames) const;

  std::vector<FigureWorld> worlds_;
  FigureOptions options_;
};

}  // namespace scatter::lab
