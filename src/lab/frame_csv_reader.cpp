#include <scatter/io/file.h>
#include <scatter/lab/frame_csv.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <string>

namespace scatter {

namespace {

// What comes before the next `end`, which is taken away with it.
std::string_view takeUntil(std::string_view& text, char end) {
  const std::size_t at = text.find(end);
  const std::string_view taken = text.substr(0, at);
  text.remove_prefix(at == std::string_view::npos ? text.size() : at + 1);
  return taken;
}

std::string_view takeLine(std::string_view& text) {
  std::string_view line = takeUntil(text, '\n');
  if (line.ends_with('\r')) {
    line.remove_suffix(1);
  }
  return line;
}

std::optional<std::size_t> findCell(std::string_view line, std::string_view wanted) {
  for (std::size_t index = 0; !line.empty(); ++index) {
    if (takeUntil(line, ',') == wanted) {
      return index;
    }
  }
  return std::nullopt;
}

std::optional<double> numberAt(std::string_view line, std::size_t index) {
  std::string_view cell = takeUntil(line, ',');
  for (; index > 0; --index) {
    cell = takeUntil(line, ',');
  }
  double number = 0.0;
  const auto [stop, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
  const bool whole = error == std::errc() && stop == cell.data() + cell.size();
  return whole && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

}  // namespace

Result<std::vector<double>> readFrameColumn(const std::filesystem::path& file, std::string_view column) {
  const auto content = readFile(file);
  if (!content) {
    return tl::unexpected(content.error());
  }
  std::string_view text = *content;
  const auto index = findCell(takeLine(text), column);
  if (!index) {
    return fail(file.string() + " has no column " + std::string(column) + "; give the frames.csv of a run");
  }
  std::vector<double> values;
  while (!text.empty()) {
    const auto number = numberAt(takeLine(text), *index);
    if (!number) {
      return fail(file.string() + ", line " + std::to_string(values.size() + 2) + ": " + std::string(column) +
                  " is not a number; give the whole frames.csv of a run");
    }
    values.push_back(*number);
  }
  if (values.empty()) {
    return fail(file.string() + " has no frames; give the frames.csv of a run");
  }
  return values;
}

}  // namespace scatter
