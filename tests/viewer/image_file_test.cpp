#include "viewer/image_file.h"

#include <gmock/gmock.h>
#include <png.h>
#include <scatter/io/file.h>
#include <unistd.h>

#include <filesystem>
#include <string>

namespace scatter::test {
namespace {

using viewer::Image;

TEST(ImageFile, ReadsBackAsItWas) {
  Image image{3, 2, {}};
  for (std::uint8_t i = 0; i < 18; ++i) image.rgb.push_back(static_cast<std::uint8_t>(13 * i));
  const auto file =
      std::filesystem::temp_directory_path() / ("scatter-image-" + std::to_string(getpid()) + ".png");
  ASSERT_TRUE(viewer::writePng(image, file).has_value());
  const std::string bytes = readFile(file).value();
  std::filesystem::remove(file);
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()), 0);
  png.format = PNG_FORMAT_RGB;
  EXPECT_EQ(png.width, 3U);
  EXPECT_EQ(png.height, 2U);
  std::vector<std::uint8_t> rgb(PNG_IMAGE_SIZE(png));
  ASSERT_NE(png_image_finish_read(&png, nullptr, rgb.data(), 0, nullptr), 0);
  EXPECT_EQ(rgb, image.rgb);
}

TEST(ImageFile, RefusesWhatIsNoPicture) {
  EXPECT_FALSE(viewer::toPng({}).has_value());
  const auto written = viewer::writePng({1, 1, {1, 2, 3}}, "picture.jpg");
  ASSERT_FALSE(written.has_value());
  EXPECT_THAT(written.error().message, testing::HasSubstr("picture.jpg"));
}

TEST(ImageFile, SaysWhereItCannotWrite) {
  const auto written = viewer::writePng({1, 1, {1, 2, 3}}, "/nowhere/picture.png");
  ASSERT_FALSE(written.has_value());
  EXPECT_THAT(written.error().message, testing::HasSubstr("/nowhere"));
}

}  // namespace
}  // namespace scatter::test
