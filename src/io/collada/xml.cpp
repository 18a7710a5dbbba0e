#include "io/collada/xml.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "io/collada/transforms.h"
#include "io/numbers.h"

namespace scatter::io {
namespace {

/// How far a number can be from `value` and still be rounded to it.
double roundingOf(float value) {
  const float away = std::nextafter(std::abs(value), 2.0F);
  return 0.499999 * (static_cast<double>(away) - static_cast<double>(std::abs(value)));
}

/// A unit quaternion that is rounded to `rotation`, if there is one.
glm::dquat unrounded(const Quat& rotation) {
  const auto at = [&](double share) {
    const auto moved = [&](float value) { return value + share * std::copysign(roundingOf(value), value); };
    return glm::dquat(moved(rotation.w), moved(rotation.x), moved(rotation.y), moved(rotation.z));
  };
  double low = -1.0;
  double high = 1.0;
  for (int step = 0; step < 60; ++step) {
    const double middle = 0.5 * (low + high);
    (glm::length(at(middle)) < 1.0 ? low : high) = middle;
  }
  return at(0.5 * (low + high));
}

/// What a reader makes of an axis and an angle.
Quat readAgain(const std::array<std::string, 4>& words) {
  std::array<double, 4> values{};
  for (std::size_t i = 0; i < 4; ++i) {
    values[i] = parseNumber(words[i]).value_or(0.0);
  }
  return rotationFromDegrees(values[0], values[1], values[2], values[3]);
}

std::array<std::string, 4> axisAndDegrees(const glm::dquat& source, int digits) {
  const double length = std::hypot(source.x, source.y, source.z);
  const double degrees = 2.0 * std::atan2(length, source.w) * 57.295779513082320877;
  return {formatNumber(source.x / length, digits), formatNumber(source.y / length, digits),
          formatNumber(source.z / length, digits), formatNumber(degrees, digits)};
}

/// Axis and degrees with as few digits as give back the same quaternion.
std::string formatRotation(const Quat& rotation) {
  constexpr int kAllDigits = 17;
  const glm::dquat source(rotation);
  std::array<std::string, 4> words;
  for (int digits = 3; digits <= kAllDigits; ++digits) {
    words = axisAndDegrees(source, digits);
    if (readAgain(words) == rotation) {
      break;
    }
  }
  // The cosine of 90 degrees is not quite 0.
  if (withoutNoise(readAgain(words)) != withoutNoise(rotation)) {
    words = axisAndDegrees(unrounded(rotation), kAllDigits);
  }
  return words[0] + " " + words[1] + " " + words[2] + " " + words[3];
}

struct StringWriter : pugi::xml_writer {
  std::string text;
  void write(const void* data, std::size_t size) override {
    text.append(static_cast<const char*>(data), size);
  }
};

}  // namespace

pugi::xml_node append(pugi::xml_node& parent, const char* name) {
  return parent.append_child(name);
}

pugi::xml_node appendText(pugi::xml_node& parent, const char* name, const std::string& text) {
  pugi::xml_node node = parent.append_child(name);
  node.text().set(text.c_str());
  return node;
}

void setAttribute(pugi::xml_node& node, const char* name, const std::string& value) {
  node.append_attribute(name).set_value(value.c_str());
}

std::string makeId(const char* kind, std::size_t index) {
  return index == 0 ? kind : std::string(kind).append("-").append(std::to_string(index + 1));
}

std::string link(const std::string& id) {
  return std::string("#").append(id);
}

std::string formatVector(const Vec3& v) {
  return formatNumber(v.x) + " " + formatNumber(v.y) + " " + formatNumber(v.z);
}

std::string formatName(const std::string& name) {
  const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  const auto isAllowed = [&](char c) {
    return isLetter(c) || (c >= '0' && c <= '9') || c == '-' || c == '.';
  };
  std::string result = name;
  std::replace_if(
      result.begin(), result.end(), [&](char c) { return !isAllowed(c); }, '_');
  return !result.empty() && isLetter(result.front()) ? result : std::string("_").append(result);
}

void setName(pugi::xml_node& node, const std::string& name) {
  if (!name.empty()) {
    setAttribute(node, "name", formatName(name));
  }
}

std::string formatDegrees(float radians) {
  const double degrees = static_cast<double>(radians) / kDegreesToRadians;
  std::string text;
  for (int digits = 3; digits <= 17; ++digits) {
    text = formatNumber(degrees, digits);
    if (static_cast<float>(parseNumber(text).value_or(0.0) * kDegreesToRadians) == radians) {
      break;
    }
  }
  return text;
}

void writePose(pugi::xml_node& parent, const Transform& pose) {
  if (pose.position != Vec3(0.0F)) {
    appendText(parent, "translate", formatVector(pose.position));
  }
  const Quat& q = pose.rotation;
  if (q.x != 0.0F || q.y != 0.0F || q.z != 0.0F) {
    appendText(parent, "rotate", formatRotation(q));
  }
}

pugi::xml_node scatterTechnique(pugi::xml_node& parent) {
  if (const pugi::xml_node extra = parent.child("extra")) {
    return extra.child("technique");
  }
  pugi::xml_node extra = append(parent, "extra");
  pugi::xml_node technique = append(extra, "technique");
  setAttribute(technique, "profile", "SCATTER");
  return technique;
}

void writePositions(pugi::xml_node& mesh, const std::string& id, const std::vector<Vec3>& positions) {
  constexpr std::size_t kPerLine = 4;
  std::string numbers;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    numbers.append(i % kPerLine == 0 ? "\n" : " ").append(formatVector(positions[i]));
  }
  pugi::xml_node source = append(mesh, "source");
  setAttribute(source, "id", id + "-positions");
  pugi::xml_node array = appendText(source, "float_array", numbers + "\n");
  setAttribute(array, "id", id + "-array");
  setAttribute(array, "count", std::to_string(3 * positions.size()));
  pugi::xml_node technique = append(source, "technique_common");
  pugi::xml_node accessor = append(technique, "accessor");
  setAttribute(accessor, "source", link(id + "-array"));
  setAttribute(accessor, "count", std::to_string(positions.size()));
  setAttribute(accessor, "stride", "3");
  for (const char* axis : {"X", "Y", "Z"}) {
    pugi::xml_node parameter = append(accessor, "param");
    setAttribute(parameter, "name", axis);
    setAttribute(parameter, "type", "float");
  }
  pugi::xml_node vertices = append(mesh, "vertices");
  setAttribute(vertices, "id", id + "-vertices");
  pugi::xml_node input = append(vertices, "input");
  setAttribute(input, "semantic", "POSITION");
  setAttribute(input, "source", link(id + "-positions"));
}

pugi::xml_node writeRoot(pugi::xml_document& document) {
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  setAttribute(declaration, "version", "1.0");
  setAttribute(declaration, "encoding", "utf-8");
  pugi::xml_node root = document.append_child("COLLADA");
  setAttribute(root, "xmlns", "http://www.collada.org/2005/11/COLLADASchema");
  setAttribute(root, "version", "1.4.1");
  pugi::xml_node asset = append(root, "asset");
  pugi::xml_node contributor = append(asset, "contributor");
  appendText(contributor, "authoring_tool", "Scatter");
  // The schema wants dates; the clock would make every file different.
  appendText(asset, "created", "1970-01-01T00:00:00Z");
  appendText(asset, "modified", "1970-01-01T00:00:00Z");
  pugi::xml_node unit = append(asset, "unit");
  setAttribute(unit, "name", "meter");
  setAttribute(unit, "meter", "1");
  appendText(asset, "up_axis", "Y_UP");
  return root;
}

std::string textOf(const pugi::xml_document& document) {
  StringWriter text;
  document.save(text, "  ", pugi::format_default, pugi::encoding_utf8);
  return std::move(text.text);
}

}  // namespace scatter::io
