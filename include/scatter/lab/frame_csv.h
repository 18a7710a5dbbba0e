#pragma once

#include <scatter/lab/frame_data.h>
#include <scatter/lab/frame_table.h>
#include <scatter/result.h>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace scatter {

class GrowingFile;

/// Streams frames to a CSV file: one header line, one row a frame, real numbers in the shortest form that
/// reads back to the same bits, hashes as 16 hexadecimal digits, whatever the locale. The file appears under
/// its name, in the place of an earlier one, with the first frame, and always holds whole frames.
class FrameCsv {
 public:
  /// Writes the header of the channels that `data` has now; later ones are left out.
  [[nodiscard]] static Result<FrameCsv> create(const std::filesystem::path& file, const FrameData& data);

  FrameCsv(FrameCsv&&) noexcept;
  FrameCsv& operator=(FrameCsv&&) noexcept;
  ~FrameCsv();

  /// Adds the current frame, or nothing and fails.
  [[nodiscard]] Result<void> write(const FrameData& data);

  /// Waits until all is on the disk; without a frame there is a file with a header. Nothing may be written
  /// afterwards.
  [[nodiscard]] Result<void> finish();

 private:
  FrameCsv(std::unique_ptr<GrowingFile> file, std::string header, std::size_t channels);

  std::unique_ptr<GrowingFile> file_;
  std::string header_;  // until the first frame
  std::size_t channels_;
};

/// The same file from a whole run at once.
[[nodiscard]] Result<void> writeFrameCsv(const std::filesystem::path& file, const FrameTable& table);

/// Such a file as it was when it was read, so that all columns are as long while a run still adds to it. A
/// last line without an end is that of a program that was killed, and left out.
class FrameFile {
 public:
  [[nodiscard]] static Result<FrameFile> read(const std::filesystem::path& file);

  [[nodiscard]] bool has(std::string_view column) const;

  /// Of real or whole numbers, filled in every frame. Fails if there is no such column, no frames, or a cell
  /// in it that is no finite number; the message names the file and the line.
  [[nodiscard]] Result<std::vector<double>> column(std::string_view name) const;

 private:
  FrameFile(std::filesystem::path file, std::string lines);

  std::filesystem::path file_;
  std::string lines_;
};

/// A whole file. Its columns must be `channels`, in that order; fails on anything that FrameCsv does not
/// write.
[[nodiscard]] Result<FrameTable> readFrameTable(const std::filesystem::path& file,
                                                const std::vector<Channel>& channels);

}  // namespace scatter
