#pragma once

#include <scatter/lab/figures.h>
#include <scatter/lab/run.h>
#include <scatter/result.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace scatter {

/// How many tests the report has (Table 5.1).
inline constexpr int kReportTests = 4;

/// A moment of a report test.
struct StoryLine {
  std::uint64_t frame = 0;  ///< Counts from 1.
  std::string text;         ///< What happened, in a few words.
};

/// A number of the report beside ours.
struct ReportMeasure {
  std::string name;     ///< The same in every test that has it.
  std::string report;   ///< What the report says; "-" where it says nothing.
  double ours = 0.0;    ///< Not a number where it did not happen.
  bool isTime = false;  ///< Depends on the machine and its clock.
};

/// One of the report's tests, as it went.
struct ReportTest {
  int number = 0;
  std::string title;
  std::string command;           ///< `scatter run …` that makes the same run.
  Run run;                       ///< With its events.
  std::vector<StoryLine> story;  ///< By frame.
  std::vector<ReportMeasure> measures;
};

/// Runs Test `number`, from 1: Scene 1 in the default build, Scene 1 in the hybrid build, Scene 2 in the
/// default build, Scene 2 in the hybrid build (report, section 5.1). The default build is the plain engine;
/// the hybrid build switches bodies as the report does, with the engine's own narrowphase. Writes frames.csv,
/// events.csv and summary.json into `out`. Fails as runScene does, and on a number that there is not.
[[nodiscard]] Result<ReportTest> runReportTest(int number, const EngineFactory& engine,
                                               const std::filesystem::path& out,
                                               const Progress& progress = {});

/// The time line and the numbers as text of at most 80 columns; ends with a new line.
[[nodiscard]] std::string formatReportTest(const ReportTest& test);

/// Draws the report's figures of one scene as fig-5-05 … fig-5-11 into a folder: the default build's panel
/// above that of the hybrid build. One test or two tests of the same scene. Fails as drawFigures does.
[[nodiscard]] Result<std::vector<Figure>> drawReportFigures(const std::vector<const ReportTest*>& tests,
                                                            const std::filesystem::path& folder);

}  // namespace scatter
