#include "build_progress.h"

#include <gtest/gtest.h>

namespace scatter::app {
namespace {

TEST(BuildProgress, GrowsFromStageToStage) {
  double last = 0.0;
  for (const char* stage : {"shells", "distances", "patches", "merging", "parts", "levels", "check"}) {
    EXPECT_NEAR(shareOfBuild(stage, 0.0), last, 1e-12) << stage;
    EXPECT_GT(shareOfBuild(stage, 0.5), last) << stage;
    last = shareOfBuild(stage, 1.0);
  }
  EXPECT_NEAR(last, 1.0, 1e-12);
  EXPECT_EQ(shareOfBuild("parts", 7.0), shareOfBuild("parts", 1.0));
  EXPECT_EQ(shareOfBuild("something new", 0.0), 1.0);
}

TEST(BuildProgress, TimesAreSaidInTheirUnit) {
  EXPECT_EQ(aboutSeconds(0.2), "1 s");
  EXPECT_EQ(aboutSeconds(41.3), "42 s");
  EXPECT_EQ(aboutSeconds(119.0), "119 s");
  EXPECT_EQ(aboutSeconds(121.0), "3 min");
  EXPECT_EQ(aboutSeconds(7300.0), "3 h");
}

}  // namespace
}  // namespace scatter::app
