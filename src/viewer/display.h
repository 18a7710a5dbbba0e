#pragma once

#include <scatter/result.h>

#include <memory>

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

}  // namespace scatter::viewer
