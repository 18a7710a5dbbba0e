#pragma once

#include <IEventReceiver.h>

#include "viewer/panel_frame.h"

namespace scatter::viewer {

/// Puts what Irrlicht tells of the window into the queue.
class IrrlichtInput final : public irr::IEventReceiver {
 public:
  explicit IrrlichtInput(InputQueue& queue) : queue_(queue) {}

  bool OnEvent(const irr::SEvent& event) override;

 private:
  void onMouse(const irr::SEvent::SMouseInput& mouse);
  void onKey(const irr::SEvent::SKeyInput& key);

  InputQueue& queue_;
};

}  // namespace scatter::viewer
