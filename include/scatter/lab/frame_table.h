#pragma once

#include <scatter/lab/frame_data.h>

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace scatter {

/// One channel over a whole run.
struct FrameColumn {
  Channel channel;
  std::vector<double> values;         ///< Of a real or integer channel.
  std::vector<std::uint64_t> hashes;  ///< Of a hash channel.
};

/// Every frame of a run, by column: what statistics and figures are made from.
class FrameTable {
 public:
  FrameTable() = default;
  explicit FrameTable(const std::vector<Channel>& channels);

  /// Columns of one length.
  explicit FrameTable(std::vector<FrameColumn> columns);

  /// Adds the current frame of `data`, which must have this table's channels first.
  void append(const FrameData& data);

  [[nodiscard]] std::size_t frames() const { return frames_; }
  [[nodiscard]] const std::vector<FrameColumn>& columns() const { return columns_; }

  /// Null if there is no such column.
  [[nodiscard]] const FrameColumn* find(std::string_view name) const;

  /// The column must exist.
  [[nodiscard]] const std::vector<double>& values(std::string_view name) const;
  [[nodiscard]] const std::vector<std::uint64_t>& hashes(std::string_view name) const;

  /// Replaces a column that exists by as many values.
  void setValues(std::string_view name, std::vector<double> values);

 private:
  std::vector<FrameColumn> columns_;
  std::size_t frames_ = 0;
};

}  // namespace scatter
