#include <gmock/gmock.h>
#include <imgui.h>

#include "viewer/renderer_fixture.h"
#include "viewer/x11_user.h"

namespace scatter::test {
namespace {

InputEvent keyDown(Key key) {
  InputEvent event;
  event.kind = InputEvent::Kind::kKeyDown;
  event.key = key;
  return event;
}

InputEvent mouse(InputEvent::Kind kind, const glm::vec2& position) {
  InputEvent event;
  event.kind = kind;
  event.position = position;
  return event;
}

/// What holds with and without a window.
class RendererInput : public RendererTest {};
INSTANTIATE_TEST_SUITE_P(All, RendererInput, testing::ValuesIn(viewer::rendererNames()), testName);

TEST_P(RendererInput, KnowsItsNameAndSize) {
  EXPECT_EQ(renderer_->name(), GetParam());
  EXPECT_EQ(renderer_->size(), glm::ivec2(640, 400));
}

TEST_P(RendererInput, InjectedEventsArriveOnceAndInOrder) {
  (void)shoot(Picture{});
  renderer_->inject(keyDown(Key::kShift));
  renderer_->inject(keyDown(Key::kW));
  renderer_->inject(keyDown(Key::kW));
  const auto events = renderer_->pollInput();
  ASSERT_EQ(events.size(), 3U);
  EXPECT_EQ(events[0].key, Key::kShift);
  EXPECT_EQ(events[1].key, Key::kW);
  EXPECT_TRUE(events[1].shift);
  EXPECT_FALSE(events[1].control);
  EXPECT_FALSE(events[1].repeated);
  EXPECT_TRUE(events[2].repeated);
  EXPECT_TRUE(renderer_->pollInput().empty());
}

TEST_P(RendererInput, InjectedResizeChangesTheSize) {
  renderer_->inject(mouse(InputEvent::Kind::kResize, {500.0F, 300.0F}));
  EXPECT_EQ(await(InputEvent::Kind::kResize).position, glm::vec2(500.0F, 300.0F));
  EXPECT_EQ(renderer_->size(), glm::ivec2(500, 300));
  const Image shot = shoot(Picture{});
  EXPECT_EQ(shot.width, 500);
  EXPECT_EQ(shot.rgb.size(), 450000U);
}

TEST_P(RendererInput, AClickReachesAPanelAndIsTakenByIt) {
  int clicks = 0;
  const viewer::Panels panels = [&] {
    ImGui::SetNextWindowPos({100.0F, 100.0F});
    ImGui::SetNextWindowSize({200.0F, 100.0F});
    ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoTitleBar);
    if (ImGui::Button("press", {180.0F, 80.0F})) ++clicks;
    ImGui::End();
  };
  const auto frame = [&] { renderer_->draw({}, panels); };
  frame();
  renderer_->inject(mouse(InputEvent::Kind::kMouseMove, {200.0F, 150.0F}));
  (void)renderer_->pollInput();
  frame();
  frame();
  // Both in one frame, as a quick click may come.
  renderer_->inject(mouse(InputEvent::Kind::kMouseDown, {200.0F, 150.0F}));
  renderer_->inject(mouse(InputEvent::Kind::kMouseUp, {200.0F, 150.0F}));
  const auto events = renderer_->pollInput();
  ASSERT_EQ(events.size(), 2U);
  EXPECT_TRUE(events[0].takenByPanels);
  EXPECT_FALSE(events[1].takenByPanels) << "a release is for everybody";
  frame();
  frame();
  EXPECT_EQ(clicks, 1);
  renderer_->inject(mouse(InputEvent::Kind::kMouseMove, {500.0F, 350.0F}));
  (void)renderer_->pollInput();
  frame();
  frame();
  renderer_->inject(mouse(InputEvent::Kind::kMouseDown, {500.0F, 350.0F}));
  EXPECT_FALSE(renderer_->pollInput().at(0).takenByPanels) << "beside the panel";
}

TEST_P(RendererInput, TextGoesIntoTheFieldThatHasTheFocus) {
  char text[32] = "";
  const auto frame = [&] {
    renderer_->draw({}, [&] {
      ImGui::Begin("panel");
      ImGui::SetKeyboardFocusHere();
      ImGui::InputText("field", text, sizeof text);
      ImGui::End();
    });
  };
  for (int i = 0; i < 3; ++i) frame();
  for (const char letter : {'h', 'i'}) {
    InputEvent event;
    event.kind = InputEvent::Kind::kText;
    event.text = static_cast<char32_t>(letter);
    renderer_->inject(event);
  }
  renderer_->inject(keyDown(Key::kH));
  const auto events = renderer_->pollInput();
  ASSERT_EQ(events.size(), 3U);
  EXPECT_TRUE(events[0].takenByPanels);
  EXPECT_TRUE(events[2].takenByPanels) << "the letter is no command now";
  frame();
  EXPECT_STREQ(text, "hi");
}

TEST_P(RendererInput, CountsWhatItDraws) {
  const MeshId box = renderer_->addMesh(boxMesh());
  Picture picture;
  picture.views.push_back(viewFromFront());
  picture.views[0].items = {shining(box, {}, kRed), shining(box, {0.0F, 0.0F, 30.0F}, kRed),
                            shining(box, {100.0F, 0.0F, 0.0F}, kRed)};
  picture.views[0].lines.resize(4);
  renderer_->draw(picture, [] {
    ImGui::GetForegroundDrawList()->AddRectFilled({1.0F, 1.0F}, {9.0F, 9.0F}, ~0U);
  });
  EXPECT_EQ(renderer_->statistics().items, 1U);
  EXPECT_EQ(renderer_->statistics().culled, 2U) << "one behind the camera, one beside the view";
  EXPECT_EQ(renderer_->statistics().triangles, 12U);
  EXPECT_EQ(renderer_->statistics().lines, 4U);
  EXPECT_GE(renderer_->statistics().panelVertices, 4U);
}

/// What a user does at a real window.
class RendererWindow : public RendererTest {};
INSTANTIATE_TEST_SUITE_P(All, RendererWindow, testing::ValuesIn(windowedRenderers()), testName);

TEST_P(RendererWindow, KeysArriveAsKeysAndText) {
  (void)shoot(Picture{});
  X11User user;
  user.press("w");
  EXPECT_EQ(await(InputEvent::Kind::kKeyDown).key, Key::kW);
  user.release("w");
  EXPECT_EQ(await(InputEvent::Kind::kKeyUp).key, Key::kW);
  user.press("7");
  EXPECT_EQ(await(InputEvent::Kind::kText).text, U'7');
  for (const auto& [name, key] :
       {std::pair{"F5", Key::kF5}, std::pair{"Left", Key::kLeft}, std::pair{"space", Key::kSpace},
        std::pair{"Shift_L", Key::kShift}, std::pair{"comma", Key::kComma}, std::pair{"Escape", Key::kEscape},
        std::pair{"Prior", Key::kPageUp}, std::pair{"minus", Key::kMinus},
        std::pair{"Control_L", Key::kControl}, std::pair{"Return", Key::kEnter}}) {
    user.press(name);
    EXPECT_EQ(await(InputEvent::Kind::kKeyDown).key, key) << name;
    user.release(name);
  }
}

TEST_P(RendererWindow, MouseArrivesInPixels) {
  (void)shoot(Picture{});
  X11User user;
  user.move({123, 45});
  EXPECT_EQ(await(InputEvent::Kind::kMouseMove).position, glm::vec2(123.0F, 45.0F));
  user.button(1, true);
  const InputEvent down = await(InputEvent::Kind::kMouseDown);
  EXPECT_EQ(down.button, MouseButton::kLeft);
  EXPECT_EQ(down.position, glm::vec2(123.0F, 45.0F));
  user.button(1, false);
  EXPECT_EQ(await(InputEvent::Kind::kMouseUp).button, MouseButton::kLeft);
  user.button(3, true);
  EXPECT_EQ(await(InputEvent::Kind::kMouseDown).button, MouseButton::kRight);
  user.button(4, true);
  EXPECT_EQ(await(InputEvent::Kind::kWheel).wheel, 1.0F);
  user.button(5, true);
  EXPECT_EQ(await(InputEvent::Kind::kWheel).wheel, -1.0F);
}

TEST_P(RendererWindow, WindowResizedByTheUserTells) {
  (void)shoot(Picture{});
  X11User user;
  user.resize({700, 300});
  EXPECT_EQ(await(InputEvent::Kind::kResize).position, glm::vec2(700.0F, 300.0F));
  EXPECT_EQ(renderer_->size(), glm::ivec2(700, 300));
}

TEST_P(RendererWindow, TitleIsThatOfTheFrame) {
  (void)shoot(Picture{});
  X11User user;
  EXPECT_EQ(user.title(), "Scatter");
  renderer_->setTitle("Scatter: duel");
  EXPECT_EQ(user.title(), "Scatter: duel");
}

TEST_P(RendererWindow, ClosingTells) {
  (void)shoot(Picture{});
  X11User user;
  user.close();
  (void)await(InputEvent::Kind::kClose);
  EXPECT_TRUE(renderer_->pollInput().empty()) << "only once";
  EXPECT_EQ(shoot(Picture{}).width, 640) << "it is the program that ends";
}

}  // namespace
}  // namespace scatter::test
