#pragma once

#include <scatter/levels/level_set.h>

namespace scatter::lab {

/// The longest side of the box, along the model's axes, around the finest level's parts without hull margins;
/// metres.
[[nodiscard]] double modelLength(const LevelSet& levels);

}  // namespace scatter::lab
