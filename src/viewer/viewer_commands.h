#pragma once

#include "viewer/viewer_state.h"

namespace scatter::viewer {

/// Fills the state's commands: time, views, camera, hands, levels, output. The state must outlive them.
void addCommands(ViewerState& state);

}  // namespace scatter::viewer
