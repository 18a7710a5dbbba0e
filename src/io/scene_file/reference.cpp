#include <scatter/io/scene_file.h>

#include <string>

#include "io/numbers.h"
#include "io/scene_file/keys.h"

namespace scatter {
namespace {

std::string rangeOf(const io::SceneKey& key) {
  if (!key.hasRange()) return "";
  return io::formatNumber(key.least, 12) + " to " + io::formatNumber(key.most, 12);
}

/// The kinds that a key belongs to, as the beginning of its meaning.
std::string kindsOf(const io::SceneKey& key) {
  if (key.of.empty()) return "";
  std::string text = "Only for ";
  for (const char c : key.of) text += c == ' ' ? std::string(", ") : std::string(1, c);
  return text + (key.meaning.empty() ? "." : ". ");
}

std::string row(const io::SceneKey& key) {
  std::string text;
  const auto cell = [&text](std::string_view content) {
    text += content.empty() ? "| " : "| " + std::string(content) + " ";
  };
  cell("`" + std::string(key.name) + "`");
  cell(key.type);
  cell(key.unit);
  cell(rangeOf(key));
  cell(key.standard);
  cell(kindsOf(key) + std::string(key.meaning));
  return text + "|\n";
}

}  // namespace

std::string sceneFileReference() {
  std::string text;
  for (const io::SceneSection& section : io::sceneSections()) {
    const bool isTable = section.name.find('.') != std::string_view::npos;
    text += (text.empty() ? "" : "\n");
    text += section.name == "file" ? "### Sections\n\n"
                                   : (isTable ? "#### `" : "### `") + std::string(section.title) + "`\n\n";
    if (!section.meaning.empty()) text += std::string(section.meaning) + "\n\n";
    text += "| key | type | unit | range | default | meaning |\n|---|---|---|---|---|---|\n";
    for (const io::SceneKey& key : section.keys) text += row(key);
  }
  return text;
}

}  // namespace scatter
