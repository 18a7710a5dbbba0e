#pragma once

#include <scatter/result.h>

#include <memory>
#include <string>
#include <string_view>

struct _XDisplay;  // NOLINT(bugprone-reserved-identifier, readability-identifier-naming): Xlib's Display

namespace scatter::viewer {

struct DisplayClose {
  void operator()(_XDisplay* display) const;
};

/// A connection to an X server. An X server may start anew when its last connection goes: hold one while
/// another is made.
using DisplayConnection = std::unique_ptr<_XDisplay, DisplayClose>;

/// Fails, with a line that says what to do, if there is no X display that windows can be opened on.
[[nodiscard]] Result<DisplayConnection> openDisplay();

/// What a window's frame says, in UTF-8.
void nameWindow(_XDisplay* display, unsigned long window, const std::string& name);

/// Whether what OpenGL calls its renderer is a program, such as Mesa's "llvmpipe (LLVM 15.0.6, 256 bits)".
[[nodiscard]] bool isSoftwareRenderer(std::string_view name);

}  // namespace scatter::viewer
