#pragma once

#include <scatter/math.h>

#include <string>

namespace scatter::levels {

/// Three significant digits, such as 0.031.
[[nodiscard]] std::string toText(double value);

/// Four significant digits each, such as (1.2, 0, 3.4).
[[nodiscard]] std::string toText(const Vec3& value);

}  // namespace scatter::levels
