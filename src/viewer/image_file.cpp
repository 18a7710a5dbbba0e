#include "viewer/image_file.h"

#include <png.h>
#include <scatter/io/file.h>

namespace scatter::viewer {

Result<std::string> toPng(const Image& image) {
  if (image.width <= 0 || image.height <= 0) return fail("a picture without pixels cannot be written");
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGB;
  // Frames of a video are written while the window runs: speed counts more than size.
  png.flags = PNG_IMAGE_FLAG_FAST;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&png, bytes.data(), &size, 0, image.rgb.data(), 0, nullptr) == 0)
    return fail(std::string("cannot make a PNG picture: ") + static_cast<const char*>(png.message));
  bytes.resize(size);
  return bytes;
}

Result<void> writePng(const Image& image, const std::filesystem::path& file) {
  if (file.extension() != ".png")
    return fail(file.string() + ": is no PNG picture by its extension; give it .png");
  return toPng(image).and_then([&](const std::string& bytes) { return writeFile(file, bytes); });
}

}  // namespace scatter::viewer
