#include <scatter/lab/hand_script.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scatter {
namespace {

using testing::HasSubstr;
using testing::Not;

HandScript everything() {
  HandScript script;
  script.add(0, DragAction{BodyId{17}, Vec3(0.1F, 1.0F / 3.0F, -2.5e-9F)});
  script.add(1, DragToAction{Vec3(3.0F, 2.0F, 1.0F)});
  script.add(5, DropAction{});
  script.add(5, PushAction{BodyId{4}, Vec3(1.0F, 0.0F, 0.0F), Vec3(0.7F)});
  script.add(6, ThrowAction{BodyId{4}, Vec3(9.0F), Vec3(0.0F), 17.3F});
  script.add(7, SpawnAction{BodyId{4}, {Vec3(1.0F, 2.0F, 3.0F), Quat(0.6F, 0.8F, 0.0F, 0.0F)}});
  script.add(8, RemoveAction{BodyId{4}});
  script.add(9, GatherAction{Vec3(0.0F, 4.0F, 0.0F), {}});
  script.add(10, GatherAction{Vec3(0.0F, 4.0F, 0.0F), {BodyId{1}, BodyId{2}}});
  script.add(11, ReleaseAction{});
  script.add(12, FreezeAction{{BodyId{1}, BodyId{3}}});
  script.add(13, ThawAction{{BodyId{3}}});
  script.add(14, RequestAction{2, Scope::kGroup, {BodyId{1}, BodyId{2}}});
  script.add(15, RequestAction{1, Scope::kGlobal, {}});
  script.add(16, RetractAction{});
  return script;
}

TEST(HandScript, IsTextAndBack) {
  const std::string text = everything().text();
  EXPECT_THAT(text, HasSubstr("10 gather 0 4 0 1 2\n"));
  EXPECT_THAT(text, HasSubstr("14 request 2 group 1 2\n"));
  const auto back = HandScript::parse(text, "text");
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->text(), text);
  ASSERT_EQ(back->actions().size(), 15U);
  const auto& drag = std::get<DragAction>(back->actions()[0].action);
  EXPECT_EQ(drag.body, BodyId{17});
  EXPECT_EQ(drag.point, Vec3(0.1F, 1.0F / 3.0F, -2.5e-9F));
  EXPECT_EQ(std::get<SpawnAction>(back->actions()[5].action).pose.rotation, Quat(0.6F, 0.8F, 0.0F, 0.0F));
  EXPECT_EQ(std::get<ThrowAction>(back->actions()[4].action).speed, 17.3F);
}

TEST(HandScript, SkipsEmptyLinesAndRemarks) {
  const auto script = HandScript::parse("# a drag\n\n  3 drop # done\r\n", "remarks");
  ASSERT_TRUE(script) << script.error().message;
  ASSERT_EQ(script->actions().size(), 1U);
  EXPECT_EQ(script->actions()[0].frame, 3U);
}

TEST(HandScript, SaysInOneLineWhatIsWrongAndWhere) {
  const auto expectRefused = [](const char* text, const char* words) {
    const auto script = HandScript::parse(text, "hands.txt");
    ASSERT_FALSE(script) << text;
    EXPECT_THAT(script.error().message, HasSubstr("hands.txt: line"));
    EXPECT_THAT(script.error().message, HasSubstr(words));
    EXPECT_THAT(script.error().message, Not(HasSubstr("\n")));
  };
  expectRefused("1 drop\nx drop\n", "line 2 has 'x'");
  expectRefused("1 juggle 3\n", "'juggle' where it should have one of drag, drag-to");
  expectRefused("1\n", "one of drag");
  expectRefused("1 drag 3 0 0\n", "ends where it should have a number");
  expectRefused("1 drag 3 0 nan 0\n", "'nan'");
  expectRefused("1 drag 3 0 1e99 0\n", "'1e99'");
  expectRefused("1 drag -3 0 0 0\n", "'-3'");
  expectRefused("1 drop 7\n", "'7' where it should have nothing more");
  expectRefused("1 request 1 all\n", "'all' where it should have local, group or global");
  expectRefused("1 gather 0 0 0 4 five\n", "'five'");
  expectRefused("4 drop\n3 drop\n", "line 2 goes back to frame 3");
}

}  // namespace
}  // namespace scatter
