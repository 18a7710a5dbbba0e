#include "lab/html.h"

#include "lab/text.h"

#include <utility>

namespace scatter::lab {

std::string escaped(std::string text) {
  text = replaceAll(std::move(text), "&", "&amp;");
  text = replaceAll(std::move(text), "<", "&lt;");
  text = replaceAll(std::move(text), ">", "&gt;");
  return replaceAll(std::move(text), "\"", "&quot;");
}

std::string element(const std::string& tag, const std::string& text) {
  return '<' + tag + '>' + escaped(text) + "</" + tag + ">\n";
}

}  // namespace scatter::lab
