#include "docs/checks.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace scatter::test {

namespace {

std::vector<double> numbersOf(const std::filesystem::path& csv, const std::string& column) {
  std::vector<double> numbers;
  for (const std::string& cell : columnOf(csv, column)) {
    numbers.push_back(std::strtod(cell.c_str(), nullptr));
  }
  return numbers;
}

}  // namespace

Check operator+(Check first, Check second) {
  return [first = std::move(first), second = std::move(second)](const Called& called) {
    first(called);
    second(called);
  };
}

Check says(const std::string& text) {
  return [text](const Called& called) { EXPECT_THAT(called.outcome.output, testing::HasSubstr(text)); };
}

Check leaves(const std::string& file) {
  return [file](const Called& called) { EXPECT_NE(readText(called.folder / file), "") << file; };
}

Check has(const std::string& csv, const std::string& column) {
  return [csv, column](const Called& called) {
    EXPECT_GT(highestIn(called.folder / csv, column), 0.0) << csv << ", " << column;
  };
}

Check grows(const std::string& csv, const std::string& column) {
  return [csv, column](const Called& called) {
    const auto numbers = numbersOf(called.folder / csv, column);
    ASSERT_FALSE(numbers.empty()) << csv << ", " << column;
    EXPECT_GT(*std::max_element(numbers.begin(), numbers.end()), numbers.front()) << csv << ", " << column;
  };
}

Check same(const std::string& csv, const std::string& other, const std::string& column) {
  return [csv, other, column](const Called& called) {
    const auto cells = columnOf(called.folder / csv, column);
    EXPECT_FALSE(cells.empty()) << csv << ", " << column;
    EXPECT_EQ(cells, columnOf(called.folder / other, column));
  };
}

Check differs(const std::string& csv, const std::string& other, const std::string& column) {
  return [csv, other, column](const Called& called) {
    const auto cells = columnOf(called.folder / csv, column);
    EXPECT_FALSE(cells.empty()) << csv << ", " << column;
    EXPECT_NE(cells, columnOf(called.folder / other, column));
  };
}

double highestIn(const std::filesystem::path& csv, const std::string& column) {
  const auto numbers = numbersOf(csv, column);
  return numbers.empty() ? -1.0 : *std::max_element(numbers.begin(), numbers.end());
}

int firstIn(const std::filesystem::path& csv, const std::string& column) {
  const auto numbers = numbersOf(csv, column);
  const auto found = std::find_if(numbers.begin(), numbers.end(), [](double number) { return number > 0.0; });
  return found == numbers.end() ? 0 : static_cast<int>(found - numbers.begin()) + 1;
}

}  // namespace scatter::test
