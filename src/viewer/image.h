#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace scatter::viewer {

/// A picture of what a window showed.
struct Image {
  int width = 0;                    ///< In pixels.
  int height = 0;                   ///< In pixels.
  std::vector<std::uint8_t> rgb{};  ///< Three bytes a pixel, red first, row by row from the top.

  /// The first of the three bytes of a pixel, which lies in the image; (0, 0) is at the top left.
  [[nodiscard]] const std::uint8_t* pixel(int x, int y) const {
    return &rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                     static_cast<std::size_t>(x))];
  }
};

}  // namespace scatter::viewer
