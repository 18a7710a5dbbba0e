#pragma once

#include "io/collada/xml_source.h"

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace scatter::io {

/// How strict a reader is, and what it has to tell.
class ColladaNotes {
 public:
  /// A reader that `mends` takes what exporters get wrong and says so; another one refuses it.
  explicit ColladaNotes(bool mends) : mends_(mends) {}

  [[nodiscard]] bool mends() const { return mends_; }

  /// Says `what` of an element. What is said again of another element of that name is only counted.
  void add(const XmlSource& xml, const pugi::xml_node& node, const std::string& what);

  /// One line for each thing said, in the order in which they came up.
  [[nodiscard]] std::vector<std::string> lines() const;

  /// Counts what the document takes from the file. A few bytes can name a big mesh a thousand times:
  /// fails once there is more than fits into memory.
  [[nodiscard]] Result<void> take(const XmlSource& xml, const pugi::xml_node& node, std::size_t elements);

 private:
  struct Line {
    std::string text;
    std::size_t count;
  };

  bool mends_;
  std::vector<Line> lines_;
  std::map<std::pair<std::string, std::string>, std::size_t> known_;
  std::size_t suppressed_ = 0;
  std::size_t taken_ = 0;
};

}  // namespace scatter::io
