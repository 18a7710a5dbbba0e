#include "io/collada_shapes.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "io/collada_geometry.h"

namespace scatter::io {
namespace {

constexpr double kDegreesToRadians = glm::pi<double>() / 180.0;

/// The positive sizes in a required child.
Result<std::vector<float>> readSizes(const ColladaFrame& frame, const pugi::xml_node& node, const char* name,
                                     std::size_t count) {
  return frame.xml().child(node, name, "a shape needs its size").and_then([&](const pugi::xml_node& child) {
    return frame.sizes(child, count);
  });
}

/// COLLADA gives two radii, along x and z; shapes here are round.
Result<float> readRoundRadius(const ColladaFrame& frame, const pugi::xml_node& node) {
  const auto radii = readSizes(frame, node, "radius", 0);
  if (!radii) {
    return tl::unexpected(radii.error());
  }
  if (radii->empty() || radii->size() > 2) {
    return frame.xml().failAt(node.child("radius"),
                              "should hold 1 or 2 numbers, but holds " + std::to_string(radii->size()));
  }
  if (std::abs(radii->front() - radii->back()) > 1e-4F * radii->front()) {
    return frame.xml().failAt(node.child("radius"),
                              "elliptic shapes are not supported; make both radii equal");
  }
  return radii->front();
}

Result<ConvexShape> readBox(const ColladaFrame& frame, const pugi::xml_node& node) {
  return readSizes(frame, node, "half_extents", 3).map([](const std::vector<float>& size) {
    return ConvexShape(Box{Vec3(size[0], size[1], size[2])});
  });
}

Result<ConvexShape> readSphere(const ColladaFrame& frame, const pugi::xml_node& node) {
  return readSizes(frame, node, "radius", 1).map([](const std::vector<float>& size) {
    return ConvexShape(Sphere{size[0]});
  });
}

template <class Round>
Result<ConvexShape> readRound(const ColladaFrame& frame, const pugi::xml_node& node) {
  const auto radius = readRoundRadius(frame, node);
  if (!radius) {
    return tl::unexpected(radius.error());
  }
  return readSizes(frame, node, "height", 1).map([&](const std::vector<float>& size) {
    return ConvexShape(Round{*radius, size[0] / 2.0F});
  });
}

Result<ConvexShape> readHull(const ColladaFrame& frame, const pugi::xml_node& node) {
  return frame.xml()
      .follow(node, "url", "geometry")
      .and_then([&](const pugi::xml_node& geometry) { return readConvexMesh(frame, geometry); })
      .map([](std::vector<Vec3> vertices) { return ConvexShape(ConvexHull{std::move(vertices)}); });
}

struct ShapeReader {
  const char* element;
  Result<ConvexShape> (*read)(const ColladaFrame& frame, const pugi::xml_node& node);
};

constexpr std::array<ShapeReader, 5> kShapeReaders{{{"box", readBox},
                                                    {"sphere", readSphere},
                                                    {"capsule", readRound<Capsule>},
                                                    {"cylinder", readRound<Cylinder>},
                                                    {"instance_geometry", readHull}}};

Result<ConvexShape> readGeometry(const ColladaFrame& frame, const pugi::xml_node& shape) {
  for (const ShapeReader& reader : kShapeReaders) {
    if (const pugi::xml_node node = shape.child(reader.element)) {
      return reader.read(frame, node);
    }
  }
  return frame.xml().failAt(shape, "holds no <box>, <sphere>, <capsule>, <cylinder> or <instance_geometry>");
}

Result<Transform> readTransform(const ColladaFrame& frame, const pugi::xml_node& node) {
  if (std::string_view(node.name()) == "translate") {
    return frame.vector(node).map([](const Vec3& offset) { return Transform{offset, kNoRotation}; });
  }
  const auto values = frame.numbers(node, 4);
  if (!values) {
    return tl::unexpected(values.error());
  }
  const std::vector<double>& v = *values;
  const double length = std::hypot(v[0], v[1], v[2]);
  if (v[3] != 0.0 && !(length > 1e-9 && length < 1e9)) {
    return frame.xml().failAt(node, "the axis of rotation should have length 1");
  }
  return Transform{Vec3(0.0F), v[3] == 0.0 ? kNoRotation : rotationFromDegrees(v[0], v[1], v[2], v[3])};
}

/// `<translate>` and `<rotate>` in the order in which they stand, each in the frame of the one before.
Result<Transform> readPose(const ColladaFrame& frame, const pugi::xml_node& shape) {
  Transform pose;
  for (const pugi::xml_node& child : shape.children()) {
    const std::string_view name = child.name();
    if (name != "translate" && name != "rotate") {
      continue;
    }
    const auto step = readTransform(frame, child);
    if (!step) {
      return step;
    }
    const bool first = pose.rotation == kNoRotation;
    pose = pose * *step;
    if (!first) {
      pose.rotation = glm::normalize(pose.rotation);
    }
  }
  if (glm::length(pose.position) > static_cast<float>(ColladaFrame::kMaxLength)) {
    return frame.xml().failAt(shape, "is too far from the origin");
  }
  return pose;
}

}  // namespace

Quat rotationFromDegrees(double x, double y, double z, double degrees) {
  // Whole turns are taken out first: a huge angle would overflow the sine's argument reduction.
  const double half = 0.5 * std::fmod(degrees, 720.0) * kDegreesToRadians;
  const double scale = std::sin(half) / std::hypot(x, y, z);
  return {static_cast<float>(std::cos(half)), static_cast<float>(x * scale), static_cast<float>(y * scale),
          static_cast<float>(z * scale)};
}

Result<Level> readShapes(const ColladaFrame& frame, const pugi::xml_node& parent) {
  Level level;
  for (const pugi::xml_node& node : parent.children("shape")) {
    auto shape = readGeometry(frame, node);
    if (!shape) {
      return tl::unexpected(shape.error());
    }
    const auto pose = readPose(frame, node);
    if (!pose) {
      return tl::unexpected(pose.error());
    }
    const bool turned = frame.toYUp() != kNoRotation;
    level.parts.push_back({std::move(*shape), turned ? Transform{Vec3(0.0F), frame.toYUp()} * *pose : *pose});
  }
  if (level.parts.empty()) {
    return frame.xml().failAt(parent, "has no <shape>; a level needs at least one");
  }
  return level;
}

}  // namespace scatter::io
