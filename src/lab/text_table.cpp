#include "lab/text_table.h"

#include "lab/text.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace scatter::lab {

namespace {

using Cells = std::vector<std::string>;

std::string padded(const std::string& text, std::size_t width, bool right) {
  const std::string space(width - std::min(width, text.size()), ' ');
  return right ? space + text : text + space;
}

std::string lineOf(const Cells& cells, const std::vector<std::size_t>& widths) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    line += i == 0 ? "" : "  ";
    line += padded(cells[i], widths[i], i > 0);
  }
  return line + '\n';
}

}  // namespace

std::string textTable(const std::vector<Cells>& lines) {
  assert(!lines.empty());
  std::vector<std::size_t> widths(lines.front().size(), 0);
  for (const Cells& line : lines) {
    assert(line.size() == widths.size());
    for (std::size_t i = 0; i < line.size(); ++i) {
      widths[i] = std::max(widths[i], line[i].size());
    }
  }
  std::size_t width = 0;
  for (const std::size_t column : widths) {
    width += column + 2;
  }
  std::string text = lineOf(lines.front(), widths) + std::string(width - 2, '-') + '\n';
  for (std::size_t i = 1; i < lines.size(); ++i) {
    text += lineOf(lines[i], widths);
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

std::string ratioText(const Spread& spread, bool withExtremes) {
  if (std::isnan(spread.median)) {
    return "-";
  }
  const std::string median = ratioNumber(spread.median, spread.median);
  if (!withExtremes) {
    return median;
  }
  return median + " (" + ratioNumber(spread.min, spread.median) + "-" +
         ratioNumber(spread.max, spread.median) + ")";
}

}  // namespace scatter::lab
