#include "viewer/panel_frame.h"

#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <string_view>
#include <utility>

#include "viewer/panel_scale.h"

namespace scatter::viewer {

namespace {

std::size_t indexOf(Key key) {
  return static_cast<std::size_t>(key);
}
std::size_t indexOf(MouseButton button) {
  return static_cast<std::size_t>(button);
}

constexpr std::pair<ImGuiKey, Key> kPanelKeys[] = {
    {ImGuiKey_Tab, Key::kTab},
    {ImGuiKey_LeftArrow, Key::kLeft},
    {ImGuiKey_RightArrow, Key::kRight},
    {ImGuiKey_UpArrow, Key::kUp},
    {ImGuiKey_DownArrow, Key::kDown},
    {ImGuiKey_PageUp, Key::kPageUp},
    {ImGuiKey_PageDown, Key::kPageDown},
    {ImGuiKey_Home, Key::kHome},
    {ImGuiKey_End, Key::kEnd},
    {ImGuiKey_Insert, Key::kInsert},
    {ImGuiKey_Delete, Key::kDelete},
    {ImGuiKey_Backspace, Key::kBackspace},
    {ImGuiKey_Space, Key::kSpace},
    {ImGuiKey_Enter, Key::kEnter},
    {ImGuiKey_Escape, Key::kEscape},
    {ImGuiKey_A, Key::kA},
    {ImGuiKey_C, Key::kC},
    {ImGuiKey_V, Key::kV},
    {ImGuiKey_X, Key::kX},
    {ImGuiKey_Y, Key::kY},
    {ImGuiKey_Z, Key::kZ},
};

constexpr float kLetterPixels = 13.0F;

ImGuiStyle panelStyle(float scale) {
  ImGuiStyle style;
  ImGui::StyleColorsDark(&style);
  style.WindowBorderSize = 0.0F;
  style.FrameRounding = 3.0F;
  style.ScrollbarSize = 10.0F;
  style.WindowPadding = ImVec2(7.0F, 6.0F);
  style.ItemSpacing = ImVec2(5.0F, 4.0F);
  style.Colors[ImGuiCol_WindowBg] = ImVec4(0.055F, 0.065F, 0.085F, 1.0F);
  style.ScaleAllSizes(scale);
  return style;
}

/// Whether the panels keep the event from the program. Releases reach both, so that nothing stays held.
bool isTaken(const InputEvent& event, const ImGuiIO& io) {
  switch (event.kind) {
    case InputEvent::Kind::kKeyDown:
    case InputEvent::Kind::kText:
      return io.WantTextInput;
    case InputEvent::Kind::kMouseMove:
    case InputEvent::Kind::kMouseDown:
    case InputEvent::Kind::kWheel:
      return io.WantCaptureMouse;
    default:
      return false;
  }
}

}  // namespace

void InputQueue::releaseAll() {
  for (std::size_t i = 0; i < kKeys; ++i) {
    InputEvent event;
    event.kind = InputEvent::Kind::kKeyUp;
    event.key = static_cast<Key>(i);
    if (keysDown_[i]) add(event);
  }
  for (std::size_t i = 0; i < kButtons; ++i) {
    InputEvent event;
    event.kind = InputEvent::Kind::kMouseUp;
    event.button = static_cast<MouseButton>(i);
    event.position = pointer_;
    if (buttonsDown_[i]) add(event);
  }
}

void InputQueue::note(InputEvent& event) {
  switch (event.kind) {
    case InputEvent::Kind::kKeyDown:
      event.repeated = keysDown_[indexOf(event.key)];
      keysDown_[indexOf(event.key)] = true;
      keysSeen_[indexOf(event.key)] = true;
      break;
    case InputEvent::Kind::kKeyUp:
      keysDown_[indexOf(event.key)] = false;
      break;
    case InputEvent::Kind::kMouseDown:
      buttonsDown_[indexOf(event.button)] = true;
      buttonsSeen_[indexOf(event.button)] = true;
      pointer_ = event.position;
      break;
    case InputEvent::Kind::kMouseUp:
      buttonsDown_[indexOf(event.button)] = false;
      pointer_ = event.position;
      break;
    case InputEvent::Kind::kMouseMove:
      pointer_ = event.position;
      break;
    default:
      break;
  }
  event.shift = keysDown_[indexOf(Key::kShift)];
  event.control = keysDown_[indexOf(Key::kControl)];
  event.alt = keysDown_[indexOf(Key::kAlt)];
}

std::vector<InputEvent> InputQueue::take() {
  ImGuiIO& io = ImGui::GetIO();
  for (InputEvent& event : events_) {
    note(event);
    event.takenByPanels = isTaken(event, io);
    if (event.kind == InputEvent::Kind::kText && event.text <= IM_UNICODE_CODEPOINT_MAX)
      io.AddInputCharacter(static_cast<unsigned>(event.text));
    if (event.kind == InputEvent::Kind::kWheel) io.MouseWheel += event.wheel;
  }
  return std::exchange(events_, {});
}

void InputQueue::showToPanels() {
  ImGuiIO& io = ImGui::GetIO();
  io.MousePos = ImVec2(pointer_.x, pointer_.y);
  for (std::size_t i = 0; i < kButtons; ++i)
    io.MouseDown[i] = std::exchange(buttonsSeen_[i], false) || buttonsDown_[i];
  for (std::size_t i = 0; i < kKeys; ++i) io.KeysDown[i] = std::exchange(keysSeen_[i], false) || keysDown_[i];
  io.KeyShift = io.KeysDown[indexOf(Key::kShift)];
  io.KeyCtrl = io.KeysDown[indexOf(Key::kControl)];
  io.KeyAlt = io.KeysDown[indexOf(Key::kAlt)];
}

Result<void> setUpPanels() {
  if (std::string_view(ImGui::GetVersion()) != IMGUI_VERSION)
    return fail(std::string("panels were compiled for Dear ImGui ") + IMGUI_VERSION + " but " +
                ImGui::GetVersion() + " runs; build the viewer again on this machine");
  IMGUI_CHECKVERSION();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  for (const auto& [panelKey, key] : kPanelKeys) io.KeyMap[panelKey] = static_cast<int>(key);
  for (const float scale : kPanelScales) {
    ImFontConfig font;
    font.SizePixels = kLetterPixels * scale;
    io.Fonts->AddFontDefault(&font);
  }
  return {};
}

void beginPanels(InputQueue& input, const glm::ivec2& window, float seconds) {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = ImVec2(static_cast<float>(window.x), static_cast<float>(window.y));
  io.DeltaTime = seconds;
  io.FontDefault = io.Fonts->Fonts[static_cast<int>(panelScaleIndex(window))];
  ImGui::GetStyle() = panelStyle(panelScale(window));
  input.showToPanels();
  ImGui::NewFrame();
}

float FrameClock::next() {
  const double now =
      std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  const double elapsed = last_ < 0.0 ? 1.0 / 60.0 : now - last_;
  last_ = now;
  return static_cast<float>(std::clamp(elapsed, 1e-4, 0.25));
}

}  // namespace scatter::viewer
