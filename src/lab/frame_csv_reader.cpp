#include <scatter/io/file.h>
#include <scatter/lab/frame_csv.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>

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

// All of the cell, finite or not.
std::optional<double> numberIn(std::string_view cell) {
  double number = 0.0;
  const auto [stop, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
  const bool whole = error == std::errc() && stop == cell.data() + cell.size();
  return whole ? std::optional(number) : std::nullopt;
}

std::optional<double> numberAt(std::string_view line, std::size_t index) {
  std::string_view cell = takeUntil(line, ',');
  for (; index > 0; --index) {
    cell = takeUntil(line, ',');
  }
  const auto number = numberIn(cell);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

// The whole lines of a file; what a killed program has left of another one is left out.
Result<std::string> readLines(const std::filesystem::path& file) {
  auto content = readFile(file);
  if (content) {
    content->resize(content->rfind('\n') + 1);
  }
  return content;
}

std::optional<std::uint64_t> hashOf(std::string_view cell) {
  std::uint64_t hash = 0;
  const auto [stop, error] = std::from_chars(cell.data(), cell.data() + cell.size(), hash, 16);
  const bool whole = error == std::errc() && stop == cell.data() + cell.size();
  return whole ? std::optional(hash) : std::nullopt;
}

// An empty cell is a frame without a sample.
std::optional<double> valueOf(const Channel& channel, std::string_view cell) {
  if (cell.empty() && channel.sampled) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return numberIn(cell);
}

bool readRow(std::string_view line, std::vector<FrameColumn>& columns) {
  for (FrameColumn& column : columns) {
    const std::string_view cell = takeUntil(line, ',');
    const bool isHash = column.channel.kind == ChannelKind::kHash;
    const auto hash = isHash ? hashOf(cell) : std::nullopt;
    const auto value = isHash ? std::nullopt : valueOf(column.channel, cell);
    if (!hash && !value) {
      return false;
    }
    if (isHash) {
      column.hashes.push_back(*hash);
    } else {
      column.values.push_back(*value);
    }
  }
  return line.empty();
}

bool isHeaderOf(std::string_view line, const std::vector<FrameColumn>& columns) {
  return std::all_of(
             columns.begin(), columns.end(),
             [&line](const FrameColumn& column) { return takeUntil(line, ',') == column.channel.name; }) &&
         line.empty();
}

}  // namespace

Result<FrameTable> readFrameTable(const std::filesystem::path& file, const std::vector<Channel>& channels) {
  const auto content = readLines(file);
  if (!content) {
    return tl::unexpected(content.error());
  }
  std::string_view text = *content;
  std::vector<FrameColumn> columns;
  for (const Channel& channel : channels) {
    columns.push_back({.channel = channel, .values = {}, .hashes = {}});
  }
  if (!isHeaderOf(takeLine(text), columns)) {
    return fail(file.string() + " has other columns than this program writes; it is another version's");
  }
  for (std::size_t line = 2; !text.empty(); ++line) {
    if (!readRow(takeLine(text), columns)) {
      return fail(file.string() + ", line " + std::to_string(line) + " is not a row of a run; run it again");
    }
  }
  return FrameTable(std::move(columns));
}

FrameFile::FrameFile(std::filesystem::path file, std::string lines)
    : file_(std::move(file)), lines_(std::move(lines)) {}

Result<FrameFile> FrameFile::read(const std::filesystem::path& file) {
  return readLines(file).map([&file](std::string lines) { return FrameFile(file, std::move(lines)); });
}

bool FrameFile::has(std::string_view column) const {
  std::string_view text = lines_;
  return findCell(takeLine(text), column).has_value();
}

Result<std::vector<double>> FrameFile::column(std::string_view name) const {
  std::string_view text = lines_;
  const auto index = findCell(takeLine(text), name);
  if (!index) {
    return fail(file_.string() + " has no column " + std::string(name) + "; give the frames.csv of a run");
  }
  std::vector<double> values;
  while (!text.empty()) {
    const auto number = numberAt(takeLine(text), *index);
    if (!number) {
      return fail(file_.string() + ", line " + std::to_string(values.size() + 2) + ": " + std::string(name) +
                  " is not a number; give the whole frames.csv of a run");
    }
    values.push_back(*number);
  }
  if (values.empty()) {
    return fail(file_.string() + " has no frames; give the frames.csv of a run");
  }
  return values;
}

}  // namespace scatter
