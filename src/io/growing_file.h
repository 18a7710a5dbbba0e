#pragma once

#include <scatter/result.h>

#include <sys/types.h>

#include <filesystem>
#include <memory>
#include <string_view>

namespace scatter {

/// A file that can be read under its name while it grows. It appears, in the place of an earlier one, with
/// the first addition, and holds whole additions only, unless the program is killed within one.
class GrowingFile {
 public:
  [[nodiscard]] static Result<std::unique_ptr<GrowingFile>> create(const std::filesystem::path& file);

  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;
  ~GrowingFile();  ///< Keeps what was added; without an addition nothing has changed.

  /// Adds all of the text, or nothing and fails.
  [[nodiscard]] Result<void> add(std::string_view text);

  /// Takes the last addition away again.
  void dropLast() noexcept;

  /// Waits until all is on the disk.
  [[nodiscard]] Result<void> finish();

 private:
  GrowingFile(std::filesystem::path file, std::filesystem::path temporary, int descriptor);

  std::filesystem::path file_;
  std::filesystem::path temporary_;  ///< Empty once the file has its name.
  int descriptor_;
  off_t size_ = 0;
  off_t sizeBefore_ = 0;  ///< The last addition.
};

}  // namespace scatter
