#include "lab/report_html.h"

#include "lab/fake_physics.h"
#include "lab/temporary_folder.h"
#include "lab/verdict.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <string>

namespace scatter::lab {
namespace {

using test::fakeRun;
using testing::HasSubstr;
using testing::Not;

constexpr PageBundle kBundle{.script = "theScript()", .style = "theStyle{}", .licences = "<the> licences"};

Comparison comparisonOf(std::vector<RunOptions> runs, CompareOptions options = {}) {
  options.runs = std::move(runs);
  auto comparison = compareWorlds(options);
  EXPECT_TRUE(comparison) << comparison.error().message;
  return std::move(*comparison);
}

Comparison twoWorlds(const std::string& scene = "boxes") {
  auto runs = std::vector{fakeRun(WorldKind::kStandard, 20), fakeRun(WorldKind::kHybrid, 20)};
  for (RunOptions& run : runs) run.scene = scene;
  return comparisonOf(std::move(runs), {.commandLine = "scatter compare <fake> & more"});
}

std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t from = text.find(begin);
  EXPECT_NE(from, std::string::npos) << begin;
  return text.substr(from + begin.size(), text.find(end, from + begin.size()) - from - begin.size());
}

nlohmann::json dataOf(const std::string& html) {
  return nlohmann::json::parse(
      between(html, R"(<script type="application/json" id="page-data">)", "</script>"));
}

const std::vector<Figure> kFigures{{.name = "overview", .title = "The whole", .caption = "What is seen."},
                                   {.name = "stages_peak", .title = "The peak", .caption = "Its stages."}};

TEST(ReportHtml, SaysFirstWhatCameOut) {
  const Comparison comparison = twoWorlds();
  const std::string html = reportHtml(comparison, kFigures, kBundle);
  EXPECT_THAT(verdict(comparison), testing::MatchesRegex("boxes in 2 worlds: the physics of hybrid took "
                                                         "[0-9.-]+ of the processor time of standard"));
  EXPECT_EQ(between(html, "<body>\n<h1>", "</h1>"), verdict(comparison));
  EXPECT_THAT(html, HasSubstr("The dearest of 20 frames took "));
}

TEST(ReportHtml, OneWorldAloneHasNothingToBeComparedTo) {
  const Comparison comparison = comparisonOf({fakeRun(WorldKind::kStandard, 20)});
  EXPECT_THAT(verdict(comparison), HasSubstr(" in the standard world: the physics of 20 frames took "));
  EXPECT_THAT(reportHtml(comparison, {}, kBundle), Not(HasSubstr("id=\"trial\"")));
}

TEST(ReportHtml, HoldsTheBundleAndAllNumbers) {
  const Comparison comparison = twoWorlds();
  const std::string html = reportHtml(comparison, kFigures, kBundle);
  for (const char* part :
       {"<style>theStyle{}</style>", "<script>theScript()</script>", "id=\"stage\"", "id=\"trial\"",
        "&lt;the&gt; licences", "<figure id=\"overview\">", "scatter compare &lt;fake&gt; &amp; more"}) {
    EXPECT_THAT(html, HasSubstr(part));
  }
  // The page looks at the peak itself.
  EXPECT_THAT(html, Not(HasSubstr("stages_peak")));
  const auto data = dataOf(html);
  ASSERT_EQ(data["worlds"].size(), 2U);
  for (std::size_t world = 0; world < 2; ++world) {
    const auto& said = data["worlds"][world];
    EXPECT_EQ(said["label"], comparison.worlds[world].label());
    EXPECT_EQ(said["frames"], 20);
    // All columns but the hash, of four bytes a number.
    const std::size_t columns = comparison.worlds[world].median.columns().size() - 1;
    EXPECT_EQ(said["data"]["columns"].size(), columns);
    EXPECT_EQ(said["data"]["bytes"], 80 * columns);
    EXPECT_THAT(html, HasSubstr("id=\"blob-" + std::to_string(said["data"]["blob"].get<int>()) + "\""));
    EXPECT_THAT(said["noMotion"].get<std::string>(), HasSubstr("was not recorded"));
  }
}

TEST(ReportHtml, WithoutABundleItSaysSoAndShowsTheFiguresFiles) {
  const std::string html = reportHtml(twoWorlds(), kFigures, {});
  EXPECT_THAT(html, HasSubstr("nodejs and npm are needed"));
  EXPECT_THAT(html, HasSubstr("<img src=\"figures/overview.svg\" alt=\"The whole\">"));
  EXPECT_THAT(html, HasSubstr("<img src=\"figures/stages_peak.svg\""));
  EXPECT_THAT(html, HasSubstr("<table>"));
  for (const char* part : {"<script", "id=\"stage\"", "id=\"trial\"", "Licences"})
    EXPECT_THAT(html, Not(HasSubstr(part)));
}

TEST(ReportHtml, NamesAreText) {
  const std::string name = "a</script><script>alert(1)</script>&\"'\xff";
  const std::string html = reportHtml(twoWorlds(name), kFigures, kBundle);
  EXPECT_THAT(html, Not(HasSubstr("<script>alert")));
  EXPECT_THAT(html, HasSubstr("&lt;/script&gt;&lt;script&gt;alert(1)"));
  // What is no UTF-8 is replaced: the page could not read it.
  EXPECT_EQ(dataOf(html)["scene"], "a</script><script>alert(1)</script>&\"'\xef\xbf\xbd");
}

TEST(ReportHtml, ARecordingThatCannotBeReadIsToldOf) {
  test::TemporaryFolder folder;
  Comparison comparison = twoWorlds();
  comparison.worlds[0].recording = folder.path() / "gone.rec";
  const auto data = dataOf(reportHtml(comparison, kFigures, kBundle));
  EXPECT_THAT(data["worlds"][0]["noMotion"].get<std::string>(), HasSubstr("gone.rec"));
  EXPECT_FALSE(data["worlds"][0].contains("motion"));
}

}  // namespace
}  // namespace scatter::lab
