#pragma once

#include <string>

#include "viewer/panel_frame.h"

struct _XDisplay;  // NOLINT(bugprone-reserved-identifier, readability-identifier-naming): Xlib's Display

namespace scatter::viewer {

/// Puts what the X server tells of Ogre's window into the queue: Ogre itself does not listen to it.
class OgreInput {
 public:
  /// `display` is the connection that made the window.
  OgreInput(_XDisplay* display, unsigned long window, InputQueue& queue);

  void poll();

  /// Asks the X server for another size.
  void resize(const glm::ivec2& size);

  void setTitle(const std::string& title);

 private:
  _XDisplay* display_;
  unsigned long window_;
  unsigned long closeAtom_;
  bool isClosed_ = false;
  InputQueue& queue_;
};

}  // namespace scatter::viewer
