#include "lab/page/page_blobs.h"

#include <cstdint>

#include "recording/compression.h"

namespace scatter::lab {

namespace {

std::string base64(std::string_view bytes) {
  static constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = bytes.size() - i;
    std::uint32_t three = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      three = three << 8U | (j < left ? static_cast<std::uint8_t>(bytes[i + j]) : 0U);
    }
    for (std::size_t j = 0; j < 4; ++j) {
      text.push_back(j <= left ? kDigits[three >> (18U - 6U * j) & 63U] : '=');
    }
  }
  return text;
}

}  // namespace

std::size_t PageBlobs::add(std::string_view bytes) {
  html_ += R"(<script type="application/octet-stream" id="blob-)" + std::to_string(count_) + "\">" +
           base64(recording::compressWell(bytes)) + "</script>\n";
  return count_++;
}

}  // namespace scatter::lab
