#pragma once

#include <scatter/world/world.h>

#include <string>
#include <string_view>
#include <vector>

namespace scatter {

/// A name without the number at its end and what separates the two: "crate" of "crate-12".
[[nodiscard]] std::string_view nameStem(std::string_view name);

/// Those that share its levels or its mesh; of a shape of its own, objectsNamedLike(). In the order in which
/// they were added, as below.
[[nodiscard]] std::vector<BodyId> objectsOfModel(const World& world, const WorldObject& like);

/// Those whose names have its name's stem.
[[nodiscard]] std::vector<BodyId> objectsNamedLike(const World& world, const WorldObject& like);

}  // namespace scatter
