#pragma once

#include <scatter/result.h>

#include <filesystem>
#include <string>

#include "viewer/image.h"

namespace scatter::viewer {

/// The image as a PNG file's bytes. Fails if it has no pixels.
[[nodiscard]] Result<std::string> toPng(const Image& image);

/// Writes a .png file, whole or not at all.
[[nodiscard]] Result<void> writePng(const Image& image, const std::filesystem::path& file);

}  // namespace scatter::viewer
