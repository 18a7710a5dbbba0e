#include "io/collada/fields.h"

#include <cmath>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "io/numbers.h"

namespace scatter::io {
namespace {

/// A number in the file's unit of length, in metres.
Result<float> readScaled(const ColladaFrame& frame, const pugi::xml_node& point, const char* name) {
  const auto node = frame.xml().child(point, name, "a point field needs it");
  if (!node) {
    return tl::unexpected(node.error());
  }
  const auto values = frame.numbers(*node, 1);
  if (!values) {
    return tl::unexpected(values.error());
  }
  const double value = values->front() * frame.metersPerUnit();
  if (std::abs(value) > 1e12) {
    return frame.xml().failAt(*node, formatNumber(value, 6) + " is too large");
  }
  return static_cast<float>(value);
}

Result<DocumentField> readPoint(const ColladaFrame& frame, const pugi::xml_node& point) {
  DocumentField field;
  const auto center = frame.xml().child(point, "center", "a point field needs it").and_then([&](auto node) {
    return frame.vector(node);
  });
  const auto acceleration = readScaled(frame, point, "acceleration");
  const auto radius = readScaled(frame, point, "radius");
  if (!center) {
    return tl::unexpected(center.error());
  }
  if (!acceleration || !radius) {
    return tl::unexpected(acceleration ? radius.error() : acceleration.error());
  }
  if (*radius < 0.0F) {
    return frame.xml().failAt(point, "the radius should not be negative");
  }
  field.center = frame.turnYUp(*center);
  field.acceleration = *acceleration;
  field.radius = *radius;
  return field;
}

}  // namespace

Result<std::optional<DocumentField>> readField(const ColladaFrame& frame, const pugi::xml_node& instance,
                                               std::set<std::size_t>& used) {
  const auto node = frame.followOrMend(instance, "url", "force_field", "it is left out");
  if (!node || !*node) {
    return node.map([](const pugi::xml_node&) { return std::optional<DocumentField>(); });
  }
  used.insert(node->hash_value());
  const pugi::xml_node point =
      node->find_child_by_attribute("technique", "profile", "SCATTER").child("point");
  if (!point) {
    frame.note(*node, "has no <technique profile=\"SCATTER\"> with a <point> and is left out");
    return std::nullopt;
  }
  frame.noteUnknown(*node, {});
  const std::string_view name = node->attribute("name").value();
  return readPoint(frame, point).map([&](DocumentField field) {
    field.name = name.empty() ? node->attribute("id").value() : name;
    return std::optional(std::move(field));
  });
}

}  // namespace scatter::io
