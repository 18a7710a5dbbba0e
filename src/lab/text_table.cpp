#include "lab/text_table.h"

#include "lab/text.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace scatter::lab {

namespace {

using Cells = std::vector<std::string>;

constexpr std::size_t kColumnGap = 2;

std::string padded(const std::string& text, std::size_t width, bool right) {
  const std::string space(width - std::min(width, text.size()), ' ');
  return right ? space + text : text + space;
}

/// Columns that stand beside each other; the first one of the table always does.
struct Block {
  std::size_t first = 1;
  std::size_t last = 1;  ///< The one behind its last column.
  std::size_t width = 0;
};

std::vector<std::size_t> widthsOf(const std::vector<Cells>& lines) {
  std::vector<std::size_t> widths(lines.front().size(), 0);
  for (const Cells& line : lines) {
    assert(line.size() == widths.size());
    for (std::size_t i = 0; i < line.size(); ++i) {
      widths[i] = std::max(widths[i], line[i].size());
    }
  }
  return widths;
}

std::vector<Block> blocksOf(const std::vector<std::size_t>& widths) {
  std::vector<Block> blocks{{.first = 1, .last = 1, .width = widths.front()}};
  for (std::size_t column = 1; column < widths.size(); ++column) {
    const std::size_t more = kColumnGap + widths[column];
    if (blocks.back().width + more > kTerminalWidth && blocks.back().last > blocks.back().first) {
      blocks.push_back({.first = column, .last = column, .width = widths.front()});
    }
    blocks.back().width += more;
    ++blocks.back().last;
  }
  return blocks;
}

std::string lineOf(const Cells& cells, const std::vector<std::size_t>& widths, const Block& block) {
  std::string line = padded(cells.front(), widths.front(), false);
  for (std::size_t i = block.first; i < block.last; ++i) {
    line += std::string(kColumnGap, ' ') + padded(cells[i], widths[i], true);
  }
  return line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
}

}  // namespace

std::string textTable(const std::vector<Cells>& lines) {
  assert(!lines.empty());
  const std::vector<std::size_t> widths = widthsOf(lines);
  std::string text;
  for (const Block& block : blocksOf(widths)) {
    text += (text.empty() ? "" : "\n") + lineOf(lines.front(), widths, block) +
            std::string(block.width, '-') + '\n';
    for (std::size_t i = 1; i < lines.size(); ++i) {
      text += lineOf(lines[i], widths, block);
    }
  }
  return text;
}

std::string csvText(const std::vector<Cells>& lines) {
  std::string text;
  for (const Cells& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      assert(line[i].find_first_of(",\"\n") == std::string::npos);
      text += (i == 0 ? "" : ",") + line[i];
    }
    text += '\n';
  }
  return text;
}

std::string ratioNumber(double ratio, double scale) {
  return fixedNumber(ratio, scale > 0.0 && scale < 0.1 ? 3 : 2);
}

std::string extremesText(const Spread& spread) {
  if (std::isnan(spread.median)) {
    return {};
  }
  return ratioNumber(spread.min, spread.median) + "-" + ratioNumber(spread.max, spread.median);
}

std::string ratioText(const Spread& spread, bool withExtremes) {
  if (std::isnan(spread.median)) {
    return "-";
  }
  const std::string median = ratioNumber(spread.median, spread.median);
  return withExtremes ? median + " (" + extremesText(spread) + ")" : median;
}

}  // namespace scatter::lab
