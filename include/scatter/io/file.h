#pragma once

#include <scatter/result.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace scatter {

/// The bytes of a file. Fails if it cannot be read or is larger than 1 GiB.
[[nodiscard]] Result<std::string> readFile(const std::filesystem::path& path);

/// Puts `content` at `path`, whole or not at all: it is written beside the target, flushed to the disk and
/// renamed, so that an error or a crash leaves the old file or none. A symbolic link is followed; a device
/// or pipe is written directly.
[[nodiscard]] Result<void> writeFile(const std::filesystem::path& path, std::string_view content);

}  // namespace scatter
