#include <scatter/lab/output_folder.h>
#include <scatter/lab/report_test.h>
#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <deque>
#include <memory>

#include "choices.h"
#include "command.h"
#include "interrupt.h"
#include "messages.h"
#include "progress_line.h"
#include "unknown_name.h"

namespace scatter::app {

namespace {

struct ReportTestArguments {
  std::string test;
  std::optional<std::string> out;
  bool quiet = false;
};

// A test of the hybrid build is shown beside that of the default build.
struct ReportTestChoice {
  std::string name;
  std::vector<int> runs;
  std::vector<int> shown;
};

const std::vector<ReportTestChoice>& reportTestChoices() {
  static const std::vector<ReportTestChoice> choices{{"1", {1}, {1}},
                                                     {"2", {1, 2}, {2}},
                                                     {"3", {3}, {3}},
                                                     {"4", {3, 4}, {4}},
                                                     {"all", {1, 2, 3, 4}, {1, 2, 3, 4}}};
  return choices;
}

Result<ReportTest> runTest(int number, const std::filesystem::path& out, bool quiet) {
  ProgressLine line(quiet);
  return runReportTest(number, engineChoices().front().make, out / fmt::format("test-{}", number),
                       [&](const RunProgress& progress) {
                         throwIfInterrupted();
                         line.update(fmt::format("the report's Test {}", number), progress);
                       });
}

// Those of the first scene and those of the second one are figures of their own.
Result<void> drawTests(const std::deque<ReportTest>& tests, const std::filesystem::path& folder) {
  for (const bool firstScene : {true, false}) {
    std::vector<const ReportTest*> ofScene;
    for (const ReportTest& test : tests) {
      if ((test.number <= 2) == firstScene) {
        ofScene.push_back(&test);
      }
    }
    if (ofScene.empty()) {
      continue;
    }
    if (auto drawn = drawReportFigures(ofScene, folder); !drawn) {
      return tl::unexpected(drawn.error());
    }
  }
  return {};
}

void printTests(const std::deque<ReportTest>& tests, const ReportTestChoice& choice, const std::string& out) {
  for (const ReportTest& test : tests) {
    if (std::find(choice.shown.begin(), choice.shown.end(), test.number) != choice.shown.end()) {
      fmt::print("{}\n", formatReportTest(test));
    }
  }
  fmt::print("the figures: {}/figures\n", out);
  for (const ReportTest& test : tests) {
    fmt::print("every frame: {}/test-{}/frames.csv\n", out, test.number);
  }
}

ExitStatus reportTest(const ReportTestArguments& arguments) {
  const auto choice = choose(reportTestChoices(), "report test", arguments.test);
  if (!choice) {
    return refuse(choice.error());
  }
  const std::string out = arguments.out.value_or("out/report-test-" + choice->name);
  if (auto writable = checkGnuplot().and_then([&out] { return prepareOutputFolder(out); }); !writable) {
    return refuse(writable.error());
  }
  std::deque<ReportTest> tests;
  for (const int number : choice->runs) {
    auto test = runTest(number, out, arguments.quiet);
    if (!test) {
      return refuse(test.error());
    }
    tests.push_back(std::move(*test));
  }
  if (auto drawn = drawTests(tests, std::filesystem::path(out) / "figures"); !drawn) {
    return refuse(drawn.error());
  }
  printTests(tests, *choice, out);
  return ExitStatus::kOk;
}

}  // namespace

Command addReportTestCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "report-test",
      "Repeat one of the tests of the report, and tell what happens beside what the report says");
  auto arguments = std::make_shared<ReportTestArguments>();
  command
      ->add_option("TEST", arguments->test,
                   "1: two ships, plain Bullet; 2: the same, switching bodies; 3, 4: the crowd likewise; all")
      ->required();
  command->add_option("--out", arguments->out, "The folder for data and figures [out/report-test-TEST]")
      ->type_name("DIR");
  command->add_flag("--quiet", arguments->quiet, "No progress on standard error");
  return {command, [arguments] { return reportTest(*arguments); }};
}

}  // namespace scatter::app
