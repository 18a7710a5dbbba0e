// docs/report-tests.md beside what the command says.

#include <gmock/gmock.h>

#include <cstdlib>

#include "apps/program.h"
#include "docs/page.h"

namespace scatter::test {
namespace {

using testing::Contains;

/// What `scatter report-test all` prints of one test.
std::vector<std::string> linesOfTest(const std::string& output, int number) {
  std::vector<std::string> lines;
  const std::string start = "Test " + std::to_string(number) + ":";
  bool inside = false;
  for (const std::string& line : linesOf(output)) {
    inside = line.starts_with("Test ") ? line.starts_with(start) : inside;
    if (inside) {
      lines.push_back(line);
    }
  }
  return lines;
}

/// Of a line such as "first contact, frame    140 to 180   139": name, report, here.
std::vector<std::string> columnsOf(const std::string& line) {
  std::vector<std::string> cells;
  std::size_t begin = line.find_first_not_of(' ');
  while (begin != std::string::npos) {
    const std::size_t end = line.find("  ", begin);
    cells.push_back(line.substr(begin, end - begin));
    begin = end == std::string::npos ? end : line.find_first_not_of(' ', end);
  }
  return cells;
}

std::vector<std::vector<std::string>> numbersOfTest(const std::vector<std::string>& lines) {
  std::vector<std::vector<std::string>> numbers;
  bool inTable = false;
  for (const std::string& line : lines) {
    if (line.starts_with("---")) {
      inTable = true;
    } else if (line.empty()) {
      inTable = false;
    } else if (inTable) {
      numbers.push_back(columnsOf(line));
    }
  }
  return numbers;
}

class ReportNumbers : public ProgramTest {
 protected:
  void expectPageOf(int number, const std::string& output, const std::string& page) const {
    const std::string heading = "Test " + std::to_string(number);
    const auto lines = linesOfTest(output, number);
    for (const std::string& line : codeBelow(page, heading)) {
      EXPECT_THAT(lines, Contains(line)) << heading;
    }
    const auto numbers = numbersOfTest(lines);
    const auto rows = tableBelow(page, heading);
    ASSERT_EQ(rows.size(), numbers.size()) << heading;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      expectRow(rows[i], numbers[i]);
    }
  }

 private:
  // Milliseconds depend on the machine.
  static void expectRow(const std::vector<std::string>& row, const std::vector<std::string>& number) {
    ASSERT_EQ(number.size(), 3U);
    ASSERT_GE(row.size(), 4U) << row.front();
    EXPECT_EQ(row[0], number[0]);
    EXPECT_EQ(row[1], number[1]) << row[0];
    if (row[0].ends_with(", ms")) {
      EXPECT_GT(std::strtod(row[2].c_str(), nullptr), 0.0) << row[0];
    } else {
      EXPECT_EQ(row[2], number[2]) << row[0];
    }
  }
};

TEST_F(ReportNumbers, ThePageHasThoseOfTheCommand) {
  const Outcome outcome = scatter({"report-test", "all", "--quiet"});
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const std::string page = readPage("docs/report-tests.md");
  for (int number = 1; number <= 4; ++number) {
    EXPECT_FALSE(codeBelow(page, "Test " + std::to_string(number)).empty());
    expectPageOf(number, outcome.output, page);
  }
}

TEST_F(ReportNumbers, FitInEightyColumns) {
  const Outcome outcome = scatter({"report-test", "all", "--quiet"});
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  for (const std::string& line : linesOf(outcome.output)) {
    EXPECT_LE(line.size(), 80U) << line;
  }
}

TEST_F(ReportNumbers, ATestIsTheRunThatItNames) {
  ASSERT_EQ(scatter({"report-test", "2", "--quiet", "--out", "told"}).status, 0);
  ASSERT_EQ(scatter({"run", "report_1", "--switching", "body", "--collision", "bullet", "--proximity-steps",
                     "0", "--quiet-steps", "100000", "--retry-interval", "2", "--load-fine-pairs", "1",
                     "--quiet", "--out", "alone"})
                .status,
            0);
  const auto hashes = columnOf(folder / "told/test-2/frames.csv", "state_hash");
  EXPECT_EQ(hashes.size(), 1300U);
  EXPECT_EQ(hashes, columnOf(folder / "alone/frames.csv", "state_hash"));
}

TEST_F(ReportNumbers, UnknownTestsAreRefused) {
  expectRefused(scatter({"report-test", "5"}), "unknown report test \"5\"");
  expectRefused(scatter({"report-test"}), "TEST");
}

}  // namespace
}  // namespace scatter::test
