#include "levels/text.h"

#include <array>
#include <cstdio>

namespace scatter::levels {

std::string toText(double value, int digits) {
  std::array<char, 48> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.*g", digits, value);
  return buffer.data();
}

std::string toText(const Vec3& value) {
  const auto coordinate = [](float v) { return toText(static_cast<double>(v), 4); };
  return "(" + coordinate(value.x) + ", " + coordinate(value.y) + ", " + coordinate(value.z) + ")";
}

}  // namespace scatter::levels
