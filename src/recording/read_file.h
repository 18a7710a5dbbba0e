#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace scatter::recording {

/// A file that is read at any place. Closed with this.
class ReadFile {
 public:
  explicit ReadFile(const std::filesystem::path& path);
  ReadFile(const ReadFile&) = delete;
  ReadFile& operator=(const ReadFile&) = delete;
  ~ReadFile();

  [[nodiscard]] bool isOpen() const { return descriptor_ >= 0; }  ///< If not, errno says why.
  [[nodiscard]] std::uint64_t size() const { return size_; }      ///< When it was opened.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// Less at the end of the file, and where the disk fails.
  [[nodiscard]] std::string read(std::uint64_t where, std::size_t size) const;

 private:
  int descriptor_;
  std::filesystem::path path_;
  std::uint64_t size_ = 0;
};

/// From a file that is open; less at its end, and where the disk fails.
[[nodiscard]] std::string readAt(int descriptor, std::uint64_t where, std::size_t size);

}  // namespace scatter::recording
