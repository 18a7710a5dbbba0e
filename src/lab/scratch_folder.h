#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

namespace scatter::lab {

/// A folder for files in between, gone with this.
class ScratchFolder {
 public:
  /// Its name begins with `name`.
  explicit ScratchFolder(const std::string& name) {
    std::string path = (std::filesystem::temp_directory_path() / (name + "-XXXXXX")).string();
    if (mkdtemp(path.data()) != nullptr) path_ = path;
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
  }

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }  ///< Empty if there is none.

 private:
  std::filesystem::path path_;
};

}  // namespace scatter::lab
