#pragma once

#include <vector>

#include "viewer/renderer.h"

namespace scatter {
class Hands;
}

namespace scatter::viewer {

/// What pulls what hands drag, as a spring. Adds nothing while nothing is dragged.
void addSpring(const Hands& hands, std::vector<Line>& lines);

}  // namespace scatter::viewer
