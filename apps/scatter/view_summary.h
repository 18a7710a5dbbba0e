#pragma once

namespace scatter::app {

/// What both programs say of the window.
inline constexpr const char* kViewName = "view";
inline constexpr const char* kViewSummary = "Open a scene, a recording or a model with levels in a window";

/// The window's program, in the folder of the other one.
inline constexpr const char* kViewProgram = "scatter-view";

}  // namespace scatter::app
