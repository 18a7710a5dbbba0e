#include <gmock/gmock.h>

#include <cstdlib>

#include "viewer/renderer_fixture.h"

namespace scatter::test {
namespace {

using testing::HasSubstr;
using testing::Not;

class NoDisplay : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(All, NoDisplay, testing::ValuesIn(windowedRenderers()), testName);

TEST_P(NoDisplay, IsOneClearLine) {
  unsetenv("DISPLAY");
  const auto unset = viewer::makeRenderer(GetParam(), {});
  ASSERT_FALSE(unset.has_value());
  EXPECT_EQ(unset.error().message, "no display: set DISPLAY, or use --renderer null");
  setenv("DISPLAY", ":64321", 1);
  const auto wrong = viewer::makeRenderer(GetParam(), {});
  ASSERT_FALSE(wrong.has_value());
  EXPECT_THAT(wrong.error().message, HasSubstr("DISPLAY is :64321"));
  EXPECT_THAT(wrong.error().message, Not(HasSubstr("\n")));
}

TEST(Renderers, NullNeedsNoDisplay) {
  unsetenv("DISPLAY");
  EXPECT_TRUE(viewer::makeRenderer("null", {}).has_value());
}

TEST(Renderers, UnknownNameListsTheKnown) {
  const auto made = viewer::makeRenderer("irlicht", {});
  ASSERT_FALSE(made.has_value());
  EXPECT_THAT(made.error().message,
              testing::AllOf(HasSubstr("irlicht"), HasSubstr("irrlicht"), HasSubstr("null")));
}

}  // namespace
}  // namespace scatter::test
