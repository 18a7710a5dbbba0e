#pragma once

#include <filesystem>

namespace scatter {

struct TemporaryFile {
  std::filesystem::path path;
  int descriptor = -1;  ///< The caller's to close; negative, with errno set, on failure.
};

/// A new file with another name in the folder of `file`, with the rights that open() would give it.
[[nodiscard]] TemporaryFile makeTemporaryBeside(const std::filesystem::path& file);

}  // namespace scatter
