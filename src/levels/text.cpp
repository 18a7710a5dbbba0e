#include "levels/text.h"

#include <array>
#include <cstdio>

namespace scatter::levels {

std::string toText(double value) {
  std::array<char, 48> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.3g", value);
  return buffer.data();
}

std::string toText(const Vec3& value) {
  std::array<char, 96> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "(%.4g, %.4g, %.4g)", static_cast<double>(value.x),
                static_cast<double>(value.y), static_cast<double>(value.z));
  return buffer.data();
}

}  // namespace scatter::levels
