#include "io/collada_frame.h"

#include <algorithm>
#include <cmath>
#include <pugixml.hpp>
#include <string>

#include "io/numbers.h"

namespace scatter::io {
namespace {

constexpr float kHalfSqrt2 = 0.70710678F;

bool isText(const pugi::xml_node& node) {
  return node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata;
}

std::string countMismatch(std::size_t expected, std::size_t found) {
  return "should hold " + std::to_string(expected) + (expected == 1 ? " number" : " numbers") +
         ", but holds " + std::to_string(found);
}

}  // namespace

Result<ColladaFrame> ColladaFrame::read(const XmlSource& xml) {
  ColladaFrame frame(xml);
  const pugi::xml_node asset = xml.root().child("asset");
  if (const auto unit = frame.readUnit(asset); !unit) {
    return tl::unexpected(unit.error());
  }
  if (const auto up = frame.readUpAxis(asset); !up) {
    return tl::unexpected(up.error());
  }
  return frame;
}

Result<void> ColladaFrame::readUnit(const pugi::xml_node& asset) {
  const pugi::xml_node unit = asset.child("unit");
  const pugi::xml_attribute meter = unit.attribute("meter");
  if (!meter) {
    return {};
  }
  const auto value = parseNumber(meter.value());
  if (!value || !(*value >= 1e-6 && *value <= 1e6)) {
    return xml_->failAt(unit, "meter " + inQuotes(meter.value()) + " is not a number from 1e-6 to 1e6");
  }
  metersPerUnit_ = *value;
  return {};
}

Result<void> ColladaFrame::readUpAxis(const pugi::xml_node& asset) {
  const pugi::xml_node up = asset.child("up_axis");
  std::string_view text = up.child_value();
  const std::string_view axis = takeWord(text);
  if (axis == "Z_UP") {
    toYUp_ = Quat(kHalfSqrt2, -kHalfSqrt2, 0.0F, 0.0F);
  } else if (axis == "X_UP") {
    toYUp_ = Quat(kHalfSqrt2, 0.0F, 0.0F, kHalfSqrt2);
  } else if (up && axis != "Y_UP") {
    return xml_->failAt(up, inQuotes(axis) + " is not one of X_UP, Y_UP and Z_UP");
  }
  return {};
}

Result<std::vector<double>> ColladaFrame::numbers(const pugi::xml_node& node, std::size_t count) const {
  std::vector<double> values;
  for (const pugi::xml_node& piece : node.children()) {
    if (!isText(piece)) {
      continue;
    }
    std::string_view text = piece.value();
    for (std::string_view word = takeWord(text); !word.empty(); word = takeWord(text)) {
      const auto value = parseNumber(word);
      if (!value || !std::isfinite(*value)) {
        return xml_->failAt(node, inQuotes(word) + " is not a finite number");
      }
      values.push_back(*value);
    }
  }
  if (count != 0 && values.size() != count) {
    return xml_->failAt(node, countMismatch(count, values.size()));
  }
  return values;
}

Result<std::vector<float>> ColladaFrame::lengths(const pugi::xml_node& node, std::size_t count) const {
  const auto values = numbers(node, count);
  if (!values) {
    return tl::unexpected(values.error());
  }
  std::vector<float> result;
  result.reserve(values->size());
  for (const double value : *values) {
    const double meters = value * metersPerUnit_;
    if (std::abs(meters) > kMaxLength) {
      return xml_->failAt(node, formatNumber(meters, 6) + " m is too large; the limit is " +
                                    formatNumber(kMaxLength, 6) + " m");
    }
    result.push_back(static_cast<float>(meters));
  }
  return result;
}

Result<Vec3> ColladaFrame::vector(const pugi::xml_node& node) const {
  return lengths(node, 3).map([](const std::vector<float>& v) { return Vec3(v[0], v[1], v[2]); });
}

Result<std::vector<float>> ColladaFrame::sizes(const pugi::xml_node& node, std::size_t count) const {
  auto values = lengths(node, count);
  if (values) {
    const auto bad = std::find_if(values->begin(), values->end(), [](float v) { return !(v > 0.0F); });
    if (bad != values->end()) {
      return xml_->failAt(node, formatNumber(*bad) + " is not a positive length");
    }
  }
  return values;
}

Result<std::vector<std::uint32_t>> ColladaFrame::indices(const pugi::xml_node& node) const {
  std::vector<std::uint32_t> values;
  for (const pugi::xml_node& piece : node.children()) {
    std::string_view text = isText(piece) ? piece.value() : "";
    for (std::string_view word = takeWord(text); !word.empty(); word = takeWord(text)) {
      const auto value = parseIndex(word);
      if (!value) {
        return xml_->failAt(node, inQuotes(word) + " is not an index");
      }
      values.push_back(*value);
    }
  }
  return values;
}

Result<std::uint32_t> ColladaFrame::indexAttribute(const pugi::xml_node& node, const char* name,
                                                   std::uint32_t fallback) const {
  const pugi::xml_attribute attribute = node.attribute(name);
  if (!attribute) {
    return fallback;
  }
  std::string_view text = attribute.value();
  const auto value = parseIndex(takeWord(text));
  if (!value) {
    return xml_->failAt(node,
                        std::string(name) + " " + inQuotes(attribute.value()) + " is not a whole number");
  }
  return *value;
}

}  // namespace scatter::io
