#pragma once

#include <scatter/math.h>

#include <string>

namespace scatter::levels {

/// Up to `digits` significant digits, such as 0.031.
[[nodiscard]] std::string toText(double value, int digits = 3);

/// Such as (1.2, 0, 3.4).
[[nodiscard]] std::string toText(const Vec3& value);

}  // namespace scatter::levels
