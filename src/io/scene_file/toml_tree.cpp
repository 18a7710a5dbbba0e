#include "io/scene_file/toml_tree.h"

#include <algorithm>
#include <exception>
#include <optional>

#include "io/utf8.h"

namespace scatter::io {
namespace {

/// The parser met text that it does not expect where it is, and has no message for.
struct UnexpectedText : std::exception {};

[[noreturn]] void throwUnexpectedText() {
  throw UnexpectedText();
}

}  // namespace
}  // namespace scatter::io

// The parser has assertions that damaged files break. Without NDEBUG they are checked in every build, and
// thrown.
#undef NDEBUG
#define TOML_ASSERT(condition) ((condition) ? void() : scatter::io::throwUnexpectedText())
#define TOML_EXCEPTIONS 1
#define TOML_HEADER_ONLY 1
#define TOML_MAX_NESTED_VALUES 32
#include <toml++/toml.h>

namespace scatter::io {
namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 20U;
constexpr int kMostDots = 64;               // in one key
constexpr std::size_t kMostTables = 20000;  // the parser looks each of them up in a list

/// The line of a key with so many parts that its tables could not be nested, or 0. Text within quotes counts
/// as part of a key.
int lineOfLongKey(std::string_view text) {
  int line = 1;
  int dots = 0;
  for (const char c : text) {
    line += c == '\n' ? 1 : 0;
    const bool ends = c == '\n' || c == '=' || c == ',' || c == '#' || c == '{' || c == '}' || c == ']';
    dots = ends ? 0 : dots + (c == '.' ? 1 : 0);
    if (dots > kMostDots) return line;
  }
  return 0;
}

/// The parser is undefined on some characters beyond ASCII that stand where no text is. It gets each byte of
/// such characters as a character of private use, U+E080 to U+E0FF, on which it is not.
std::string shielded(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      result += c;
    } else {
      result += {'\xEE', static_cast<char>(0x80 | byte >> 6), static_cast<char>(0x80 | (byte & 0x3F))};
    }
  }
  return result;
}

/// The text before it was shielded.
std::string unshielded(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(text[at]); };
    if (byte(i) == 0xEE && i + 2 < text.size() && (byte(i + 1) == 0x82 || byte(i + 1) == 0x83)) {
      result += static_cast<char>((byte(i + 1) & 3) << 6 | (byte(i + 2) & 0x3F));
      i += 2;
    } else {
      result += text[i];
    }
  }
  // An escape in a text can name such a character, too.
  return isUtf8(result) ? result : std::string(text);
}

/// The parser's message as one short line of visible characters.
std::string onOneLine(std::string_view text) {
  constexpr std::size_t kMost = 200;
  std::string line(text.substr(0, kMost));
  for (char& c : line) c = static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? ' ' : c;
  return line + (text.size() > kMost ? "…" : "");
}

std::string place(std::string_view name, std::size_t line) {
  return std::string(name) + ":" + std::to_string(line) + ": ";
}

TomlNode convert(const toml::node& node, int line);

TomlNode::Array convertArray(const toml::array& array, int line) {
  TomlNode::Array result;
  result.reserve(array.size());
  for (const toml::node& element : array) result.push_back(convert(element, line));
  return result;
}

TomlNode::Table convertTable(const toml::table& table) {
  TomlNode::Table result;
  result.reserve(table.size());
  for (const auto& [key, node] : table) {
    const auto line = static_cast<int>(key.source().begin.line);
    result.push_back({.key = unshielded(key.str()), .line = line, .node = convert(node, line)});
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const TomlEntry& a, const TomlEntry& b) { return a.line < b.line; });
  return result;
}

/// `line` is that of what is around it, for nodes that have no line of their own.
TomlNode convert(const toml::node& node, int line) {
  TomlNode result;
  const auto own = static_cast<int>(node.source().begin.line);
  result.line = own > 0 ? own : line;
  if (const auto* table = node.as_table()) result.value = convertTable(*table);
  if (const auto* array = node.as_array()) result.value = convertArray(*array, result.line);
  if (const auto* text = node.as_string()) result.value = unshielded(text->get());
  if (const auto* whole = node.as_integer()) result.value = whole->get();
  if (const auto* number = node.as_floating_point()) result.value = number->get();
  if (const auto* flag = node.as_boolean()) result.value = flag->get();
  return result;
}

bool isUnexpected(std::string_view text) {
  try {
    static_cast<void>(toml::parse(text));
  } catch (const toml::parse_error&) {
  } catch (const UnexpectedText&) {
    return true;
  }
  return false;
}

/// The line in which the parser meets what it does not expect: the last of the shortest beginning with that
/// effect.
std::size_t lineOfUnexpected(std::string_view text) {
  std::vector<std::size_t> ends;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') ends.push_back(i + 1);
  }
  const auto line = std::partition_point(
      ends.begin(), ends.end(), [text](std::size_t end) { return !isUnexpected(text.substr(0, end)); });
  return static_cast<std::size_t>(line - ends.begin()) + 1;
}

std::optional<std::size_t> lineOfNoUtf8(std::string_view text) {
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t length = std::min(text.find('\n'), text.size() - 1) + 1;
    if (!isUtf8(text.substr(0, length))) return line;
    text.remove_prefix(length);
  }
  return std::nullopt;
}

/// How many headers and inline tables there can be at most.
std::size_t countTables(std::string_view text) {
  std::size_t count = static_cast<std::size_t>(std::count(text.begin(), text.end(), '{'));
  bool lineBegins = true;
  for (const char c : text) {
    count += lineBegins && c == '[' ? 1 : 0;
    lineBegins = c == '\n' || (lineBegins && (c == ' ' || c == '\t'));
  }
  return count;
}

}  // namespace

std::string_view TomlNode::kind() const {
  static constexpr std::string_view kKinds[] = {"a date", "true or false", "a whole number", "a number",
                                                "a text", "a list",        "a table"};
  return kKinds[value.index()];
}

Result<TomlNode::Table> parseToml(std::string_view text, std::string_view name) {
  if (text.size() > kMostBytes) {
    return fail(place(name, 1) + "the file is larger than 1 MiB; put large models into files of their own");
  }
  if (const int line = lineOfLongKey(text)) {
    return fail(place(name, static_cast<std::size_t>(line)) + "a key of more than " +
                std::to_string(kMostDots) + " parts");
  }
  if (countTables(text) > kMostTables) {
    return fail(place(name, 1) + "more than " + std::to_string(kMostTables) +
                " tables; place bodies that are alike with one [[object]]");
  }
  if (const auto line = lineOfNoUtf8(text)) {
    return fail(place(name, *line) + "is not UTF-8; save it as that");
  }
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  const std::string toParse =
      shielded(text.substr(text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0));
  try {
    return convertTable(toml::parse(toParse, name));
  } catch (const toml::parse_error& error) {
    return fail(place(name, error.source().begin.line) + onOneLine(unshielded(error.description())));
  } catch (const UnexpectedText&) {
    return fail(place(name, lineOfUnexpected(toParse)) + "expected a key, a value, a table or a comment");
  }
}

}  // namespace scatter::io
