#pragma once

#include <scatter/lab/run_history.h>

#include <cstdint>
#include <map>

namespace scatter::viewer {

/// What has just happened to a body's levels, as strengths from 0 to 1.
struct LevelMark {
  float requested = 0.0F;  ///< A request waits: on and off, three times a second.
  float coarser = 0.0F;    ///< Switched: a pulse of a third of a second.
  float finer = 0.0F;
  float retracted = 0.0F;  ///< Fades over half a second.
};

/// The marks of all bodies at a frame, from the events that the history keeps of the two seconds before it;
/// bodies without a mark are left out. The same frame gives the same marks whenever it is looked at.
[[nodiscard]] std::map<BodyId, LevelMark> levelMarks(const RunHistory& history, std::uint64_t frame);

}  // namespace scatter::viewer
