#pragma once

#include <scatter/result.h>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace scatter {

/// A file that appears under its name only when it is whole. Until commit() it has a temporary name in the
/// same folder, which is removed on any error and on destruction.
class AtomicFile {
 public:
  [[nodiscard]] static Result<std::unique_ptr<AtomicFile>> create(const std::filesystem::path& file);

  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  /// Buffered; an error may be that of an earlier write. Nothing can be written after an error.
  [[nodiscard]] Result<void> write(std::string_view text);

  /// Flushes to the disk and gives the file its name.
  [[nodiscard]] Result<void> commit();

 private:
  AtomicFile(std::filesystem::path file, std::filesystem::path temporary, int descriptor);
  [[nodiscard]] Result<void> flush();
  [[nodiscard]] tl::unexpected<Error> giveUp(int errorNumber);
  void discard() noexcept;

  std::filesystem::path file_;
  std::filesystem::path temporary_;
  int descriptor_;
  std::string buffer_;
};

/// One line that says why a file could not be written and how to mend it.
[[nodiscard]] tl::unexpected<Error> cannotWrite(const std::filesystem::path& file, int errorNumber);

}  // namespace scatter
