#pragma once

#include <png.h>

#include <filesystem>

#include "viewer/image.h"

namespace scatter::test {

/// Empty if it cannot be read.
[[nodiscard]] inline viewer::Image readPng(const std::filesystem::path& file) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  viewer::Image image;
  if (png_image_begin_read_from_file(&png, file.c_str()) == 0) return image;
  png.format = PNG_FORMAT_RGB;
  image.width = static_cast<int>(png.width);
  image.height = static_cast<int>(png.height);
  image.rgb.resize(PNG_IMAGE_SIZE(png));
  png_image_finish_read(&png, nullptr, image.rgb.data(), 0, nullptr);
  return image;
}

}  // namespace scatter::test
