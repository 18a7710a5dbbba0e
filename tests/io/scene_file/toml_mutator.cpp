#include "io/scene_file/toml_mutator.h"

#include <algorithm>
#include <array>
#include <utility>

namespace scatter::test {
namespace {

constexpr std::array<const char*, 26> kValues{
    "0",           "-1",       "nan",   "inf",      "-inf",   "1e39", "1e308", "9223372036854775807",
    "1e-300",      "true",     "[]",    "{}",       "\"\"",   "'x'",  "[[]]",  "1979-05-27",
    "0x7f",        "1_000",    "20001", "\"ball\"", "[0, 0]", "-0.0", "1e5",   "{ random = 1 }",
    "\"\\u0001\"", "[1, 1, 1]"};
constexpr std::array<const char*, 14> kWords{"ball", "crate-1", "things",  "sky",   "random",
                                             "grid", "name",    "object",  "event", "a.b",
                                             "\"\"", "shell",   "default", "pole-9"};

bool isWordCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '_';
}

}  // namespace

std::string TomlMutator::mutate(std::string text) {
  for (std::size_t left = 1 + below(4); left > 0 && !text.empty(); --left) {
    switch (below(6)) {
      case 0:
        damageBytes(text);
        break;
      case 1:
      case 2:
        replaceWord(text, true);
        break;
      case 3:
        replaceWord(text, false);
        break;
      case 4:
        shuffleLines(text);
        break;
      default:
        repeatPart(text);
    }
  }
  return text;
}

void TomlMutator::damageBytes(std::string& text) {
  for (std::size_t i = 1 + below(3); i > 0; --i) text[below(text.size())] = static_cast<char>(below(256));
  if (below(8) == 0) text.resize(below(text.size()));
}

/// A number becomes another value, or a word another word.
void TomlMutator::replaceWord(std::string& text, bool number) {
  const std::size_t start = below(text.size());
  const auto begins = [&](char c) { return number ? (c >= '0' && c <= '9') : (c >= 'a' && c <= 'z'); };
  const auto first = std::find_if(text.begin() + static_cast<std::ptrdiff_t>(start), text.end(), begins);
  const auto last = std::find_if_not(first, text.end(), isWordCharacter);
  text.replace(first, last, number ? kValues[below(kValues.size())] : kWords[below(kWords.size())]);
}

void TomlMutator::shuffleLines(std::string& text) {
  std::vector<std::string> lines{""};
  for (const char c : text) {
    lines.back() += c;
    if (c == '\n') lines.emplace_back();
  }
  const std::size_t chosen = below(lines.size());
  switch (below(3)) {
    case 0:
      lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(chosen));
      break;
    case 1:
      std::swap(lines[chosen], lines[below(lines.size())]);
      break;
    default:
      lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(below(lines.size())),
                   std::string(lines[chosen]));
  }
  text.clear();
  for (const std::string& line : lines) text += line;
}

void TomlMutator::repeatPart(std::string& text) {
  const std::size_t from = below(text.size());
  const std::string part = text.substr(from, 1 + below(60));
  const std::size_t times = below(20) == 0 ? 2000 : 1 + below(4);
  std::string repeated;
  for (std::size_t i = 0; i < times; ++i) repeated += part;
  text.insert(from, repeated);
}

}  // namespace scatter::test
