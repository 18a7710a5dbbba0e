#pragma once

#include <scatter/lab/frame_data.h>
#include <scatter/lab/frame_table.h>
#include <scatter/result.h>

#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

namespace scatter {

class AtomicFile;

/// Streams frames to a CSV file: one header line, one row a frame, real numbers in the shortest form that
/// reads back to the same bits, hashes as 16 hexadecimal digits, whatever the locale. The file appears under
/// its name only in finish(); until then it has a temporary name beside it, which is removed on any error
/// and when this is destroyed.
class FrameCsv {
 public:
  /// Writes the header of the channels that `data` has now; later ones are left out.
  [[nodiscard]] static Result<FrameCsv> create(const std::filesystem::path& file, const FrameData& data);

  FrameCsv(FrameCsv&&) noexcept;
  FrameCsv& operator=(FrameCsv&&) noexcept;
  ~FrameCsv();

  /// Adds the current frame.
  [[nodiscard]] Result<void> write(const FrameData& data);

  /// Moves the file to its name; nothing may be written afterwards.
  [[nodiscard]] Result<void> finish();

 private:
  explicit FrameCsv(std::unique_ptr<AtomicFile> file, std::size_t channels);

  std::unique_ptr<AtomicFile> file_;
  std::size_t channels_;
};

/// The same file from a whole run at once.
[[nodiscard]] Result<void> writeFrameCsv(const std::filesystem::path& file, const FrameTable& table);

/// One column of such a file, which must be real or integer and filled in every frame. Fails if the file
/// cannot be read, has no such column, no frames, or a cell in it that is no finite number; the message names
/// the file and the line.
[[nodiscard]] Result<std::vector<double>> readFrameColumn(const std::filesystem::path& file,
                                                          std::string_view column);

}  // namespace scatter
