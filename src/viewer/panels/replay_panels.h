#pragma once

#include <scatter/lab/run_history.h>

#include <optional>
#include <string>

#include "viewer/layout.h"
#include "viewer/recorded_curves.h"
#include "viewer/replay_time.h"

namespace scatter::viewer {

/// What the panels of a recording's window show and change.
struct ReplayPanels {
  const RunHistory& history;  ///< Of a recording.
  const RecordedCurves& curves;
  ReplayTime& time;
  OpenPanels& open;
  std::optional<BodyId> picked;
  std::string& channel;  ///< That is plotted beside the usual ones; empty: none.
};

/// Curves of the whole recording, in which a click goes to a frame, and all values of the frame that is
/// shown.
void showReplayNumbers(const ReplayPanels& panels, const Layout& layout);

/// What the recording has of the picked body in the frame that is shown, if one is picked.
void showReplayInspector(const ReplayPanels& panels, const Layout& layout);

}  // namespace scatter::viewer
