#include "viewer/irrlicht/irrlicht_input.h"

#include <utility>

namespace scatter::viewer {

namespace {

constexpr std::pair<irr::EKEY_CODE, Key> kKeys[] = {
    {irr::KEY_SPACE, Key::kSpace},     {irr::KEY_RETURN, Key::kEnter},     {irr::KEY_ESCAPE, Key::kEscape},
    {irr::KEY_TAB, Key::kTab},         {irr::KEY_BACK, Key::kBackspace},   {irr::KEY_DELETE, Key::kDelete},
    {irr::KEY_INSERT, Key::kInsert},   {irr::KEY_LEFT, Key::kLeft},        {irr::KEY_RIGHT, Key::kRight},
    {irr::KEY_UP, Key::kUp},           {irr::KEY_DOWN, Key::kDown},        {irr::KEY_HOME, Key::kHome},
    {irr::KEY_END, Key::kEnd},         {irr::KEY_PRIOR, Key::kPageUp},     {irr::KEY_NEXT, Key::kPageDown},
    {irr::KEY_SHIFT, Key::kShift},     {irr::KEY_LSHIFT, Key::kShift},     {irr::KEY_RSHIFT, Key::kShift},
    {irr::KEY_CONTROL, Key::kControl}, {irr::KEY_LCONTROL, Key::kControl}, {irr::KEY_RCONTROL, Key::kControl},
    {irr::KEY_MENU, Key::kAlt},        {irr::KEY_LMENU, Key::kAlt},        {irr::KEY_RMENU, Key::kAlt},
    {irr::KEY_COMMA, Key::kComma},     {irr::KEY_PERIOD, Key::kPeriod},    {irr::KEY_MINUS, Key::kMinus},
    {irr::KEY_PLUS, Key::kPlus},       {irr::KEY_ADD, Key::kPlus},         {irr::KEY_SUBTRACT, Key::kMinus},
};

Key offset(Key first, int steps) {
  return static_cast<Key>(static_cast<int>(first) + steps);
}

Key keyOf(irr::EKEY_CODE code) {
  if (code >= irr::KEY_KEY_A && code <= irr::KEY_KEY_Z) return offset(Key::kA, code - irr::KEY_KEY_A);
  if (code >= irr::KEY_KEY_0 && code <= irr::KEY_KEY_9) return offset(Key::k0, code - irr::KEY_KEY_0);
  if (code >= irr::KEY_F1 && code <= irr::KEY_F12) return offset(Key::kF1, code - irr::KEY_F1);
  for (const auto& [theirs, ours] : kKeys) {
    if (theirs == code) return ours;
  }
  return Key::kNone;
}

}  // namespace

bool IrrlichtInput::OnEvent(const irr::SEvent& event) {
  if (event.EventType == irr::EET_MOUSE_INPUT_EVENT) onMouse(event.MouseInput);
  if (event.EventType == irr::EET_KEY_INPUT_EVENT) onKey(event.KeyInput);
  return false;
}

void IrrlichtInput::onMouse(const irr::SEvent::SMouseInput& mouse) {
  InputEvent event;
  event.position = {static_cast<float>(mouse.X), static_cast<float>(mouse.Y)};
  const auto button = [&](InputEvent::Kind kind, MouseButton which) {
    event.kind = kind;
    event.button = which;
  };
  switch (mouse.Event) {
    case irr::EMIE_LMOUSE_PRESSED_DOWN:
      button(InputEvent::Kind::kMouseDown, MouseButton::kLeft);
      break;
    case irr::EMIE_RMOUSE_PRESSED_DOWN:
      button(InputEvent::Kind::kMouseDown, MouseButton::kRight);
      break;
    case irr::EMIE_MMOUSE_PRESSED_DOWN:
      button(InputEvent::Kind::kMouseDown, MouseButton::kMiddle);
      break;
    case irr::EMIE_LMOUSE_LEFT_UP:
      button(InputEvent::Kind::kMouseUp, MouseButton::kLeft);
      break;
    case irr::EMIE_RMOUSE_LEFT_UP:
      button(InputEvent::Kind::kMouseUp, MouseButton::kRight);
      break;
    case irr::EMIE_MMOUSE_LEFT_UP:
      button(InputEvent::Kind::kMouseUp, MouseButton::kMiddle);
      break;
    case irr::EMIE_MOUSE_WHEEL:
      event.kind = InputEvent::Kind::kWheel;
      event.wheel = mouse.Wheel;
      break;
    case irr::EMIE_MOUSE_MOVED:
      event.kind = InputEvent::Kind::kMouseMove;
      break;
    default:
      // Double clicks come in addition to the presses that they are made of.
      return;
  }
  queue_.add(event);
}

void IrrlichtInput::onKey(const irr::SEvent::SKeyInput& key) {
  InputEvent event;
  event.key = keyOf(key.Key);
  event.kind = key.PressedDown ? InputEvent::Kind::kKeyDown : InputEvent::Kind::kKeyUp;
  if (event.key != Key::kNone) queue_.add(event);
  constexpr wchar_t kDeleteCharacter = 127;
  if (!key.PressedDown || key.Control || key.Char < L' ' || key.Char == kDeleteCharacter) return;
  InputEvent text;
  text.kind = InputEvent::Kind::kText;
  text.text = static_cast<char32_t>(key.Char);
  queue_.add(text);
}

}  // namespace scatter::viewer
