#include <scatter/lab/figures.h>

#include "lab/synthetic_table.h"
#include "lab/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <initializer_list>
#include <set>
#include <string>

namespace scatter {
namespace {

using test::contentOf;
using test::syntheticTable;
using test::TemporaryFolder;
using testing::HasSubstr;
using testing::Not;

TEST(DrawFigures, DrawsEachAsSvgAndPng) {
  const FrameTable standard = syntheticTable(300, 1.0, false);
  const FrameTable hybrid = syntheticTable(300, 0.2, true);
  TemporaryFolder folder;
  const auto figures = drawFigures({{"standard", &standard}, {"hybrid", &hybrid}},
                                   {.scene = "o'clock_scene", .folder = folder.path()});
  ASSERT_TRUE(figures) << figures.error().message;
  std::set<std::string> names;
  for (const Figure& figure : *figures) {
    names.insert(figure.name);
    const std::string svg = contentOf(folder.path() / (figure.name + ".svg"));
    EXPECT_THAT(svg, HasSubstr("<svg"));
    EXPECT_THAT(svg, HasSubstr("</svg>"));
    EXPECT_THAT(svg, HasSubstr("o'clock_scene"));
    EXPECT_EQ(contentOf(folder.path() / (figure.name + ".png")).substr(0, 8), "\x89PNG\r\n\x1a\n");
    EXPECT_GT(figure.caption.size(), 60U);
  }
  EXPECT_EQ(names,
            (std::set<std::string>{"overview", "manifolds_pairs", "manifolds_pairs_peak", "hybrid_pairs",
                                   "objects_contacts", "switching", "stages", "stages_peak"}));
  // Data and scripts are gone.
  EXPECT_EQ(folder.entries(), 16U);
}

TEST(DrawFigures, AWorldWithABudgetHasALineForIt) {
  const FrameTable standard = syntheticTable(300, 1.0, false);
  const FrameTable hybrid = syntheticTable(300, 0.2, true);
  TemporaryFolder folder;
  ASSERT_TRUE(drawFigures({{"standard", &standard}, {"hybrid-7ms", &hybrid, 7.0}},
                          {.scene = "s", .folder = folder.path()}));
  EXPECT_THAT(contentOf(folder.path() / "overview.svg"), HasSubstr("its budget 7.00 ms"));
  EXPECT_THAT(contentOf(folder.path() / "overview.svg"), Not(HasSubstr("budget 16.7 ms")));
  ASSERT_TRUE(
      drawFigures({{"standard", &standard}, {"hybrid", &hybrid}}, {.scene = "s", .folder = folder.path()}));
  EXPECT_THAT(contentOf(folder.path() / "overview.svg"), Not(HasSubstr("its budget")));
  EXPECT_THAT(contentOf(folder.path() / "overview.svg"), HasSubstr("budget 16.7 ms"));
}

TEST(DrawFigures, TheCaptionNamesThePeaks) {
  const FrameTable standard = syntheticTable(300, 1.0, false);
  TemporaryFolder folder;
  const auto figures = drawFigures({{"standard", &standard}}, {.scene = "s", .folder = folder.path()});
  ASSERT_TRUE(figures);
  const auto& times = standard.values("physics_cpu_ms");
  const auto peak = std::max_element(times.begin(), times.end()) - times.begin() + 1;
  EXPECT_THAT(figures->front().caption, HasSubstr("(frame " + std::to_string(peak) + ")"));
}

TEST(DrawFigures, AnInterruptedFrameLeavesTheAxisAndIsNamed) {
  FrameTable table = syntheticTable(200, 1.0, false);
  std::vector<double> times = table.values("physics_ms");
  times[20] = 1000.0;
  table.setValues("physics_ms", times);
  TemporaryFolder folder;
  ASSERT_TRUE(drawFigures({{"standard", &table}}, {.scene = "s", .folder = folder.path()}));
  EXPECT_THAT(contentOf(folder.path() / "stages.svg"), HasSubstr("beyond the axis: 1 frame, 1000 ms"));
  EXPECT_THAT(contentOf(folder.path() / "stages_peak.svg"), Not(HasSubstr("beyond the axis")));
}

TEST(DrawFigures, DrawsRunsWithOneFrameAndWithNothingInThem) {
  const FrameTable one = syntheticTable(1, 1.0, false);
  FrameTable nothing = syntheticTable(10, 1.0, false);
  for (const FrameColumn& column : nothing.columns()) {
    if (column.channel.kind != ChannelKind::kHash && column.channel.name != "frame") {
      nothing.setValues(column.channel.name, std::vector<double>(10, 0.0));
    }
  }
  for (const FrameTable* table : std::initializer_list<const FrameTable*>{&one, &nothing}) {
    TemporaryFolder folder;
    const auto figures = drawFigures({{"standard", table}}, {.scene = "s", .folder = folder.path()});
    EXPECT_TRUE(figures) << figures.error().message;
  }
}

TEST(DrawFigures, RefusesWorldsWithoutFramesAndFoldersThatAreFiles) {
  const FrameTable empty;
  const FrameTable table = syntheticTable(5, 1.0, false);
  TemporaryFolder folder;
  EXPECT_FALSE(drawFigures({{"standard", &empty}}, {.scene = "s", .folder = folder.path()}));
  EXPECT_FALSE(drawFigures({}, {.scene = "s", .folder = folder.path()}));
  std::ofstream(folder.path() / "plain") << "x";
  EXPECT_FALSE(drawFigures({{"standard", &table}}, {.scene = "s", .folder = folder.path() / "plain"}));
}

class WithPath : public testing::Test {
 protected:
  void SetUp() override { setenv("PATH", folder.path().c_str(), 1); }
  void TearDown() override { setenv("PATH", before.c_str(), 1); }

  TemporaryFolder folder;
  TemporaryFolder out;
  std::string before = std::getenv("PATH");
};

TEST_F(WithPath, MissingGnuplotNamesThePackage) {
  const auto checked = checkGnuplot();
  ASSERT_FALSE(checked);
  EXPECT_THAT(checked.error().message, HasSubstr("gnuplot-nox"));
  EXPECT_THAT(checked.error().message, Not(HasSubstr("\n")));
}

TEST_F(WithPath, WhatGnuplotComplainsAboutIsReportedOnOneLine) {
  std::ofstream(folder.path() / "gnuplot") << "#!/bin/sh\necho 'no such\nterminal' >&2\nexit 1\n";
  std::filesystem::permissions(folder.path() / "gnuplot", std::filesystem::perms::owner_all);
  const FrameTable table = syntheticTable(5, 1.0, false);
  const auto figures = drawFigures({{"standard", &table}}, {.scene = "s", .folder = out.path()});
  ASSERT_FALSE(figures);
  EXPECT_THAT(figures.error().message, HasSubstr("no such terminal"));
  EXPECT_THAT(figures.error().message, Not(HasSubstr("\n")));
  EXPECT_EQ(out.entries(), 0U);
}

}  // namespace
}  // namespace scatter
