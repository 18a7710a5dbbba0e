#include "viewer/ogre/ogre_input.h"

#include <X11/XKBlib.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/keysym.h>

#include <algorithm>
#include <array>
#include <utility>

#include "viewer/display.h"

namespace scatter::viewer {

namespace {

constexpr std::pair<KeySym, Key> kKeys[] = {
    {XK_space, Key::kSpace},         {XK_Return, Key::kEnter},      {XK_KP_Enter, Key::kEnter},
    {XK_Escape, Key::kEscape},       {XK_Tab, Key::kTab},           {XK_ISO_Left_Tab, Key::kTab},
    {XK_BackSpace, Key::kBackspace}, {XK_Delete, Key::kDelete},     {XK_Insert, Key::kInsert},
    {XK_Left, Key::kLeft},           {XK_Right, Key::kRight},       {XK_Up, Key::kUp},
    {XK_Down, Key::kDown},           {XK_Home, Key::kHome},         {XK_End, Key::kEnd},
    {XK_Prior, Key::kPageUp},        {XK_Next, Key::kPageDown},     {XK_Shift_L, Key::kShift},
    {XK_Shift_R, Key::kShift},       {XK_Control_L, Key::kControl}, {XK_Control_R, Key::kControl},
    {XK_Alt_L, Key::kAlt},           {XK_Alt_R, Key::kAlt},         {XK_comma, Key::kComma},
    {XK_period, Key::kPeriod},       {XK_minus, Key::kMinus},       {XK_KP_Subtract, Key::kMinus},
    {XK_plus, Key::kPlus},           {XK_KP_Add, Key::kPlus},
};

Key offset(Key first, KeySym steps) {
  return static_cast<Key>(static_cast<KeySym>(first) + steps);
}

Key keyOf(KeySym symbol) {
  if (symbol >= XK_a && symbol <= XK_z) return offset(Key::kA, symbol - XK_a);
  if (symbol >= XK_0 && symbol <= XK_9) return offset(Key::k0, symbol - XK_0);
  if (symbol >= XK_F1 && symbol <= XK_F12) return offset(Key::kF1, symbol - XK_F1);
  for (const auto& [theirs, ours] : kKeys) {
    if (theirs == symbol) return ours;
  }
  return Key::kNone;
}

void addKey(XKeyEvent& key, InputQueue& queue) {
  InputEvent event;
  // Without modifiers: A stays A when Shift is held.
  event.key = keyOf(XLookupKeysym(&key, 0));
  event.kind = key.type == KeyPress ? InputEvent::Kind::kKeyDown : InputEvent::Kind::kKeyUp;
  if (event.key != Key::kNone) queue.add(event);
  if (key.type != KeyPress || (key.state & ControlMask) != 0) return;
  std::array<char, 8> letters{};
  const int count = XLookupString(&key, letters.data(), static_cast<int>(letters.size()), nullptr, nullptr);
  // Latin-1, whose numbers are those of Unicode.
  const auto letter = static_cast<unsigned char>(letters[0]);
  constexpr unsigned char kDeleteCharacter = 127;
  if (count != 1 || letter < ' ' || letter == kDeleteCharacter) return;
  InputEvent text;
  text.kind = InputEvent::Kind::kText;
  text.text = letter;
  queue.add(text);
}

void addButton(const XButtonEvent& button, InputQueue& queue) {
  InputEvent event;
  event.position = {static_cast<float>(button.x), static_cast<float>(button.y)};
  if (button.button == Button4 || button.button == Button5) {
    event.kind = InputEvent::Kind::kWheel;
    event.wheel = button.button == Button4 ? 1.0F : -1.0F;
    if (button.type == ButtonPress) queue.add(event);
    return;
  }
  if (button.button > Button3) return;
  constexpr std::array kButtons{MouseButton::kLeft, MouseButton::kMiddle, MouseButton::kRight};
  event.button = kButtons.at(button.button - Button1);
  event.kind = button.type == ButtonPress ? InputEvent::Kind::kMouseDown : InputEvent::Kind::kMouseUp;
  queue.add(event);
}

void addMove(const XMotionEvent& move, InputQueue& queue) {
  InputEvent event;
  event.kind = InputEvent::Kind::kMouseMove;
  event.position = {static_cast<float>(move.x), static_cast<float>(move.y)};
  queue.add(event);
}

}  // namespace

OgreInput::OgreInput(Display* display, unsigned long window, InputQueue& queue)
    : display_(display),
      window_(window),
      closeAtom_(XInternAtom(display, "WM_DELETE_WINDOW", False)),
      queue_(queue) {
  XSelectInput(display, window,
               KeyPressMask | KeyReleaseMask | ButtonPressMask | ButtonReleaseMask | PointerMotionMask |
                   StructureNotifyMask | FocusChangeMask);
  // A key that is held is one that goes down many times, not up and down.
  XkbSetDetectableAutoRepeat(display, True, nullptr);
}

void OgreInput::poll() {
  while (XPending(display_) > 0) {
    XEvent event;
    XNextEvent(display_, &event);
    if (event.xany.window != window_) continue;
    if (event.type == KeyPress || event.type == KeyRelease) addKey(event.xkey, queue_);
    if (event.type == ButtonPress || event.type == ButtonRelease) addButton(event.xbutton, queue_);
    if (event.type == MotionNotify) addMove(event.xmotion, queue_);
    if (event.type == FocusOut) queue_.releaseAll();
    const bool closes =
        event.type == ClientMessage && static_cast<unsigned long>(event.xclient.data.l[0]) == closeAtom_;
    if (closes && !std::exchange(isClosed_, true)) {
      InputEvent close;
      close.kind = InputEvent::Kind::kClose;
      queue_.add(close);
    }
  }
}

void OgreInput::resize(const glm::ivec2& size) {
  XResizeWindow(display_, window_, static_cast<unsigned>(std::max(1, size.x)),
                static_cast<unsigned>(std::max(1, size.y)));
  XSync(display_, False);
}

void OgreInput::setTitle(const std::string& title) {
  nameWindow(display_, window_, title);
}

}  // namespace scatter::viewer
