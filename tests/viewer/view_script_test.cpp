#include "viewer/view_script.h"

#include <gmock/gmock.h>

#include <string>

namespace scatter::viewer {
namespace {

using testing::HasSubstr;

std::string mistake(const std::string& text) {
  const auto script = ViewScript::parse(text, "s.txt");
  return script ? "" : script.error().message;
}

TEST(ViewScript, ReadsEveryAction) {
  const auto script = ViewScript::parse(
      "# by hand\n1 key p\n2 do pause   # stop\n2 set contacts on\n3 look 0 1 2 30 -20 60\n4 point hunter-3\n"
      "5 move 640 360\n6 down left\n7 up right\n8 wheel -2\n\n9 resize 1920 1080\n10 screenshot a.png\n11 "
      "close\n",
      "s.txt");
  ASSERT_TRUE(script.has_value()) << script.error().message;
  ASSERT_EQ(script->lines().size(), 12U);
  EXPECT_EQ(std::get<DoInput>(script->lines()[0].action).event.key, Key::kP);
  EXPECT_EQ(std::get<DoCommand>(script->lines()[1].action).name, "pause");
  EXPECT_TRUE(std::get<SetCommand>(script->lines()[2].action).on);
  EXPECT_EQ(std::get<LookFrom>(script->lines()[3].action).distance, 60.0F);
  EXPECT_EQ(std::get<PointAt>(script->lines()[4].action).object, "hunter-3");
  EXPECT_EQ(std::get<DoInput>(script->lines()[5].action).event.position, glm::vec2(640.0F, 360.0F));
  EXPECT_EQ(std::get<DoInput>(script->lines()[7].action).event.button, MouseButton::kRight);
  EXPECT_EQ(std::get<DoInput>(script->lines()[8].action).event.wheel, -2.0F);
  EXPECT_EQ(script->lines()[11].loop, 11U);
}

TEST(ViewScript, TakesWhatHandsDoByItsFrames) {
  const auto script =
      ViewScript::parse("1 open duel\n30 gather 0 1 0\n20 do pause # the loop\n40 release\n", "s.txt");
  ASSERT_TRUE(script.has_value()) << script.error().message;
  EXPECT_EQ(script->lines().size(), 2U);
  EXPECT_EQ(std::get<OpenScene>(script->lines()[0].action).name, "duel");
  EXPECT_EQ(script->hands().text(), "30 gather 0 1 0\n40 release\n");
  EXPECT_THAT(mistake("1 gather 0 1\n"), HasSubstr("s.txt: line 1: "));
  EXPECT_THAT(mistake("2 drop\n1 drop\n"), HasSubstr("line 2: frames may not decrease"));
}

TEST(ViewScript, NamesTheLineOfAMistake) {
  EXPECT_THAT(mistake("1 do pause\n2 jump\n"),
              HasSubstr("s.txt: line 2: \"jump\" is no action; known: key, do, "));
  EXPECT_THAT(mistake("x do pause\n"), HasSubstr("line 1: \"x\" is not the number of a loop"));
  EXPECT_THAT(mistake("-1 do pause\n"), HasSubstr("is not the number of a loop"));
  EXPECT_THAT(mistake("2 do pause\n1 do pause\n"), HasSubstr("line 2: loops may not decrease"));
  EXPECT_THAT(mistake("1 key Hyper\n"), HasSubstr("no key is called \"Hyper\""));
  EXPECT_THAT(mistake("1 down up\n"), HasSubstr("left, right or middle"));
  EXPECT_THAT(mistake("1 move 3\n"), HasSubstr("pixels"));
  EXPECT_THAT(mistake("1 move -3 nan\n"), HasSubstr("pixels"));
  EXPECT_THAT(mistake("1 look 0 0 0 0 0 0\n"), HasSubstr("above 0 m"));
  EXPECT_THAT(mistake("1 set contacts maybe\n"), HasSubstr("set NAME on"));
  EXPECT_THAT(mistake("1 do pause now\n"), HasSubstr("\"now\" is too much"));
  EXPECT_THAT(mistake("1 screenshot\n"), HasSubstr("the file is missing"));
}

}  // namespace
}  // namespace scatter::viewer
