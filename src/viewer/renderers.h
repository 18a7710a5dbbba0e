#pragma once

#include <string>
#include <vector>

#include "viewer/renderer.h"

namespace scatter::viewer {

/// The renderers of this build, the usual one first.
[[nodiscard]] std::vector<std::string> rendererNames();

/// Fails on a name that is not among them, listing those that are, and if the renderer cannot be made.
[[nodiscard]] Result<std::unique_ptr<Renderer>> makeRenderer(const std::string& name,
                                                             const WindowDef& window);

}  // namespace scatter::viewer
