#include "viewer/x11_user.h"

#include <X11/Xlib.h>
#include <X11/extensions/XTest.h>

#include <stdexcept>

namespace scatter::test {

struct X11User::Connection {
  Display* display = nullptr;
  Window window = 0;
};

X11User::X11User() : connection_(std::make_unique<Connection>()) {
  connection_->display = XOpenDisplay(nullptr);
  Display* display = connection_->display;
  if (display == nullptr) throw std::runtime_error("no display");
  Window root = 0;
  Window parent = 0;
  Window* children = nullptr;
  unsigned count = 0;
  XQueryTree(display, DefaultRootWindow(display), &root, &parent, &children, &count);
  for (unsigned i = 0; i < count; ++i) {
    XWindowAttributes attributes;
    if (XGetWindowAttributes(display, children[i], &attributes) != 0 && attributes.map_state == IsViewable)
      connection_->window = children[i];
  }
  if (children != nullptr) XFree(children);
  if (connection_->window == 0) throw std::runtime_error("no window");
  // There is no window manager that would.
  XSetInputFocus(display, connection_->window, RevertToParent, CurrentTime);
  XSync(display, False);
}

X11User::~X11User() {
  XCloseDisplay(connection_->display);
}

void X11User::type(const std::string& key, bool down) {
  Display* display = connection_->display;
  XTestFakeKeyEvent(display, XKeysymToKeycode(display, XStringToKeysym(key.c_str())), down ? True : False,
                    CurrentTime);
  XSync(display, False);
}

void X11User::move(const glm::ivec2& pixel) {
  XWarpPointer(connection_->display, 0, connection_->window, 0, 0, 0, 0, pixel.x, pixel.y);
  XSync(connection_->display, False);
}

void X11User::button(unsigned number, bool down) {
  XTestFakeButtonEvent(connection_->display, number, down ? True : False, CurrentTime);
  XSync(connection_->display, False);
}

void X11User::resize(const glm::ivec2& size) {
  XResizeWindow(connection_->display, connection_->window, static_cast<unsigned>(size.x),
                static_cast<unsigned>(size.y));
  XSync(connection_->display, False);
}

std::string X11User::title() const {
  char* name = nullptr;
  XSync(connection_->display, False);
  if (XFetchName(connection_->display, connection_->window, &name) == 0) return {};
  std::string title(name);
  XFree(name);
  return title;
}

void X11User::close() {
  Display* display = connection_->display;
  XEvent event{};
  event.xclient.type = ClientMessage;
  event.xclient.window = connection_->window;
  event.xclient.message_type = XInternAtom(display, "WM_PROTOCOLS", False);
  event.xclient.format = 32;
  event.xclient.data.l[0] = static_cast<long>(XInternAtom(display, "WM_DELETE_WINDOW", False));
  event.xclient.data.l[1] = CurrentTime;
  XSendEvent(display, connection_->window, False, NoEventMask, &event);
  XSync(display, False);
}

}  // namespace scatter::test
