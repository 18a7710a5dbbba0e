#pragma once

#include <scatter/levels/convex_part.h>
#include <scatter/result.h>

#include <optional>
#include <string>
#include <vector>

namespace scatter::levels {

/// What is wrong with the values of a part, as a phrase such as "box: half extents (1, 0, 2) must be
/// positive and finite"; nothing if all is well. Whether a hull's vertices span a volume is not looked at.
[[nodiscard]] std::optional<std::string> findDefect(const ConvexPart& part);

/// Fails if there is no part, or one that massOfUnion() fails on.
[[nodiscard]] Result<void> checkVolumes(const std::vector<ConvexPart>& parts);

/// Whether every component is finite.
[[nodiscard]] bool isFinite(const Vec3& value);

}  // namespace scatter::levels
