#include "viewer/display.h"

#include <X11/Xlib.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>

namespace scatter::viewer {

void DisplayClose::operator()(Display* display) const {
  XCloseDisplay(display);
}

Result<DisplayConnection> openDisplay() {
  if (DisplayConnection display{XOpenDisplay(nullptr)}) return display;
  const char* name = std::getenv("DISPLAY");
  if (name == nullptr || *name == '\0') return fail("no display: set DISPLAY, or use --renderer null");
  return fail(std::string("no display: DISPLAY is ") + name +
              ", which does not answer; set it to one that does, or use --renderer null");
}

void nameWindow(Display* display, unsigned long window, const std::string& name) {
  // What window managers read, and what older programs do.
  XChangeProperty(display, window, XInternAtom(display, "_NET_WM_NAME", False),
                  XInternAtom(display, "UTF8_STRING", False), 8, PropModeReplace,
                  reinterpret_cast<const unsigned char*>(name.data()), static_cast<int>(name.size()));
  XStoreName(display, window, name.c_str());
  // Other programs see the name once this returns, not when the server comes round to it.
  XSync(display, False);
}

bool isSoftwareRenderer(std::string_view name) {
  static constexpr std::array<std::string_view, 4> kPrograms{"llvmpipe", "softpipe", "swrast", "Software"};
  return std::ranges::any_of(kPrograms,
                             [&](std::string_view one) { return name.find(one) != std::string_view::npos; });
}

}  // namespace scatter::viewer
