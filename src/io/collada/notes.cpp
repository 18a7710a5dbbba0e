#include "io/collada/notes.h"

#include <pugixml.hpp>

namespace scatter::io {
namespace {

constexpr std::size_t kMaxLines = 500;
constexpr std::size_t kMaxElements = 20'000'000;

}  // namespace

void ColladaNotes::add(const XmlSource& xml, const pugi::xml_node& node, const std::string& what) {
  if (!mends_) {
    return;
  }
  const auto known = known_.find({node.name(), what});
  if (known != known_.end()) {
    ++lines_[known->second].count;
  } else if (lines_.size() == kMaxLines) {
    ++suppressed_;
  } else {
    known_.emplace(std::pair(std::string(node.name()), what), lines_.size());
    lines_.push_back({xml.describeAt(node, what), 1});
  }
}

std::vector<std::string> ColladaNotes::lines() const {
  std::vector<std::string> result;
  result.reserve(lines_.size());
  for (const Line& line : lines_) {
    result.push_back(line.text);
    if (line.count > 1) {
      result.back() += " (" + std::to_string(line.count) + " times)";
    }
  }
  if (suppressed_ > 0) {
    result.push_back("and " + std::to_string(suppressed_) + " more warnings of other kinds");
  }
  return result;
}

Result<void> ColladaNotes::take(const XmlSource& xml, const pugi::xml_node& node, std::size_t elements) {
  taken_ += elements;
  if (taken_ > kMaxElements) {
    return xml.failAt(node, "the file describes more than " + std::to_string(kMaxElements) +
                                " vertices, triangles and shapes; use fewer instances or simpler meshes");
  }
  return {};
}

}  // namespace scatter::io
