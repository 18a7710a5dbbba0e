#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace scatter::lab {

/// Bytes that a page carries: each is compressed, and an element of its own that no browser looks into until
/// it is asked for.
class PageBlobs {
 public:
  /// The number by which the page finds it, from 0.
  std::size_t add(std::string_view bytes);

  /// The elements, `blob-0` and so on.
  [[nodiscard]] const std::string& html() const { return html_; }

 private:
  std::string html_;
  std::size_t count_ = 0;
};

}  // namespace scatter::lab
