#pragma once

#include <scatter/result.h>

#include <filesystem>

namespace scatter {

struct TemporaryFile {
  std::filesystem::path place;  ///< Where it is to be in the end: behind symbolic links.
  std::filesystem::path path;
  int descriptor = -1;  ///< The caller's to close.
};

/// A new file in the same folder as `file` is to be, with the rights that open() would give that. Fails where
/// a folder, a device or a pipe is, which a file must not take the place of.
[[nodiscard]] Result<TemporaryFile> makeTemporaryFor(const std::filesystem::path& file);

}  // namespace scatter
