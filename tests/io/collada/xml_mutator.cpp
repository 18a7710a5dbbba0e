#include "io/collada/xml_mutator.h"

#include <algorithm>
#include <array>
#include <pugixml.hpp>
#include <string_view>
#include <utility>
#include <vector>

namespace scatter::test {
namespace {

std::string saved(const pugi::xml_document& document) {
  struct : pugi::xml_writer {
    std::string text;
    void write(const void* data, std::size_t size) override {
      text.append(static_cast<const char*>(data), size);
    }
  } writer;
  document.save(writer, "", pugi::format_raw);
  return writer.text;
}

}  // namespace

std::string XmlMutator::mutate(std::string text) {
  for (std::size_t count = 1 + below(3); count > 0; --count) {
    text = mutateOnce(std::move(text));
  }
  return text;
}

std::size_t XmlMutator::below(std::size_t limit) {
  return limit == 0 ? 0 : static_cast<std::size_t>(random_() % limit);
}

std::string XmlMutator::mutateOnce(std::string text) {
  switch (below(8)) {
    case 0:
      return flipByte(std::move(text));
    case 1:
      return text.substr(0, below(text.size() + 1));
    case 2:
      return cutRange(std::move(text));
    case 3:
    case 4:
      return replaceNumber(std::move(text));
    default:
      return changeTree(text);
  }
}

std::string XmlMutator::flipByte(std::string text) {
  if (!text.empty()) {
    text[below(text.size())] = static_cast<char>(random_());
  }
  return text;
}

std::string XmlMutator::cutRange(std::string text) {
  const std::size_t begin = below(text.size());
  return text.erase(begin, below(200));
}

std::string XmlMutator::replaceNumber(std::string text) {
  constexpr std::array<std::string_view, 16> kNumbers{"nan",   "inf",   "-inf",       "1e38",
                                                      "-1e38", "1e-45", "1e999",      "",
                                                      "0",     "-1",    "4294967295", "99999999999999999999",
                                                      "0x10",  "1,5",   "2",          "1e-5"};
  constexpr std::string_view kDigits = "0123456789+-.eE";
  const std::size_t begin = text.find_first_of("0123456789", below(text.size()));
  if (begin != std::string::npos) {
    const std::size_t end = std::min(text.find_first_not_of(kDigits, begin), text.size());
    text.replace(begin, end - begin, kNumbers[below(kNumbers.size())]);
  }
  return text;
}

std::string XmlMutator::changeTree(const std::string& text) {
  pugi::xml_document document;
  document.load_buffer(text.data(), text.size());
  std::vector<pugi::xml_node> nodes;
  for (const pugi::xpath_node& found : document.select_nodes("//*")) {
    nodes.push_back(found.node());
  }
  if (nodes.empty()) {
    return text;
  }
  pugi::xml_node chosen = nodes[below(nodes.size())];
  pugi::xml_node other = nodes[below(nodes.size())];
  switch (below(4)) {
    case 0:
      chosen.parent().remove_child(chosen);
      break;
    case 1:
      other.append_copy(chosen);
      break;
    case 2:
      other.prepend_copy(chosen);
      break;
    default:
      if (chosen.first_attribute() && other.first_attribute()) {
        chosen.last_attribute().set_value(other.first_attribute().value());
      }
      break;
  }
  return saved(document);
}

}  // namespace scatter::test
