#include "io/collada/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "io/collada/geometry.h"
#include "io/collada/round.h"
#include "io/collada/transforms.h"

namespace scatter::io {
namespace {

/// The positive sizes in a required child.
Result<std::vector<float>> readSizes(const ColladaFrame& frame, const pugi::xml_node& node, const char* name,
                                     std::size_t count, float thin = 0.0F) {
  return frame.xml().child(node, name, "a shape needs its size").and_then([&](const pugi::xml_node& child) {
    return frame.sizes(child, count, thin);
  });
}

bool isVersion15(const ColladaFrame& frame) {
  return std::string_view(frame.xml().root().attribute("version").value()).substr(0, 3) == "1.5";
}

/// Along x and z, and in COLLADA 1.5 a capsule's along y.
struct Radii {
  float x = 0.0F;
  float z = 0.0F;
  float y = 0.0F;
  bool round = true;
};

Result<Radii> readRadii(const ColladaFrame& frame, const pugi::xml_node& node, const char* name) {
  const auto values = readSizes(frame, node, name, 0);
  if (!values) {
    return tl::unexpected(values.error());
  }
  const std::size_t most = isVersion15(frame) ? 3 : 2;
  if (values->empty() || values->size() > most) {
    return frame.xml().failAt(node.child(name), "should hold 1 or " + std::to_string(most) +
                                                    " numbers, but holds " + std::to_string(values->size()));
  }
  const std::vector<float>& v = *values;
  const Radii radii =
      v.size() == 3 ? Radii{v[0], v[2], v[1]} : Radii{v[0], v.back(), std::sqrt(v[0] * v.back())};
  const auto differs = [&](float r) { return std::abs(r - radii.x) > 1e-4F * radii.x; };
  if (!differs(radii.z) && !differs(radii.y)) {
    return radii;
  }
  return frame
      .mend(node.child(name), "elliptic shapes are not supported; make both radii equal",
            "a convex hull in the place of the shape is taken")
      .map([&] {
        return Radii{radii.x, radii.z, radii.y, false};
      });
}

RoundEnd endAt(float height, const Radii& radii, bool capped) {
  return {height, {radii.x, radii.z}, capped ? radii.y : 0.0F};
}

Result<ConvexShape> readBox(const ColladaFrame& frame, const pugi::xml_node& node) {
  const bool misspelt = !node.child("half_extents") && node.child("half_extends");
  if (misspelt) {
    frame.note(node, "<half_extends> is taken as <half_extents>");
  }
  return readSizes(frame, node, misspelt ? "half_extends" : "half_extents", 3)
      .map([](const std::vector<float>& size) { return ConvexShape(Box{Vec3(size[0], size[1], size[2])}); });
}

Result<ConvexShape> readSphere(const ColladaFrame& frame, const pugi::xml_node& node) {
  return readSizes(frame, node, "radius", 1).map([](const std::vector<float>& size) {
    return ConvexShape(Sphere{size[0]});
  });
}

template <class Round>
Result<ConvexShape> readRound(const ColladaFrame& frame, const pugi::xml_node& node) {
  const auto radii = readRadii(frame, node, "radius");
  if (!radii) {
    return tl::unexpected(radii.error());
  }
  const float thin = 0.01F * radii->x;
  return readSizes(frame, node, "height", 1, thin).map([&](const std::vector<float>& size) {
    const float half = size[0] / 2.0F;
    constexpr bool kCapped = std::is_same_v<Round, Capsule>;
    return radii->round ? ConvexShape(Round{radii->x, half})
                        : ConvexShape(roundHull(endAt(-half, *radii, kCapped), endAt(half, *radii, kCapped)));
  });
}

/// The end of a cone has no radius.
Result<Radii> readEndRadii(const ColladaFrame& frame, const pugi::xml_node& node, const char* name) {
  const auto values = frame.lengths(node.child(name), 0);
  if (values && !values->empty() &&
      std::all_of(values->begin(), values->end(), [](float r) { return r == 0.0F; })) {
    return Radii{};
  }
  return readRadii(frame, node, name);
}

/// radius1 is that of the upper end.
Result<ConvexShape> readTapered(const ColladaFrame& frame, const pugi::xml_node& node) {
  const bool capped = std::string_view(node.name()) == "tapered_capsule";
  const auto upper = readEndRadii(frame, node, "radius1");
  const auto lower = readEndRadii(frame, node, "radius2");
  if (!upper || !lower) {
    return tl::unexpected(upper ? lower.error() : upper.error());
  }
  if (upper->x == 0.0F && lower->x == 0.0F) {
    return frame.xml().failAt(node, "has no radius at either end");
  }
  frame.note(node, "a convex hull in the place of the shape is taken");
  return readSizes(frame, node, "height", 1).map([&](const std::vector<float>& size) {
    const float half = size[0] / 2.0F;
    return ConvexShape(roundHull(endAt(-half, *lower, capped), endAt(half, *upper, capped)));
  });
}

Result<ConvexShape> readHullOf(const ColladaFrame& frame, const pugi::xml_node& geometry) {
  auto vertices = readConvexMesh(frame, geometry);
  if (!vertices) {
    return tl::unexpected(vertices.error());
  }
  return frame.take(geometry, vertices->size()).map([&] {
    return ConvexShape(ConvexHull{std::move(*vertices)});
  });
}

Result<ConvexShape> readHull(const ColladaFrame& frame, const pugi::xml_node& node) {
  const auto geometry = frame.follow(node, "url", "geometry");
  if (!geometry) {
    return tl::unexpected(geometry.error());
  }
  const auto convex = frame.xml().child(*geometry, "convex_mesh", "only convex geometry can be a shape");
  return convex.and_then([&](const pugi::xml_node&) { return readHullOf(frame, *geometry); });
}

Result<ConvexShape> readHullInPlace(const ColladaFrame& frame, const pugi::xml_node& node) {
  return readHullOf(frame, node.parent());
}

struct ShapeReader {
  const char* element;
  Result<ConvexShape> (*read)(const ColladaFrame& frame, const pugi::xml_node& node);
};

constexpr std::array<ShapeReader, 8> kShapeReaders{{{"box", readBox},
                                                    {"sphere", readSphere},
                                                    {"capsule", readRound<Capsule>},
                                                    {"cylinder", readRound<Cylinder>},
                                                    {"tapered_capsule", readTapered},
                                                    {"tapered_cylinder", readTapered},
                                                    {"convex_mesh", readHullInPlace},
                                                    {"instance_geometry", readHull}}};

constexpr const char* kNoGeometry = "holds no <box>, <sphere>, <capsule>, <cylinder> or <instance_geometry>";

Result<ConvexShape> readConvex(const ColladaFrame& frame, const pugi::xml_node& shape) {
  for (const ShapeReader& reader : kShapeReaders) {
    if (const pugi::xml_node node = shape.child(reader.element)) {
      return reader.read(frame, node);
    }
  }
  return frame.xml().failAt(shape, kNoGeometry);
}

Result<DocumentPlane> readPlane(const ColladaFrame& frame, const pugi::xml_node& plane) {
  const auto equation = frame.xml().child(plane, "equation", "a plane is given by it");
  if (!equation) {
    return tl::unexpected(equation.error());
  }
  const auto values = frame.numbers(*equation, 4);
  if (!values) {
    return tl::unexpected(values.error());
  }
  const std::vector<double>& v = *values;
  const double length = std::hypot(v[0], v[1], v[2]);
  const double offset = -v[3] / length * frame.metersPerUnit();
  if (!(length > 1e-9 && length < 1e9 && std::abs(offset) <= ColladaFrame::kMaxLength)) {
    return frame.xml().failAt(*equation, "the normal has no length, or the plane is too far away");
  }
  const glm::dvec3 normal(v[0], v[1], v[2]);
  const bool unit = std::abs(length - 1.0) < 1e-6;
  return DocumentPlane{Vec3(unit ? normal : normal / length),
                       unit ? frame.toMeters(-v[3]) : static_cast<float>(offset)};
}

/// Triangles that are a shape stay in the file's axes, like any other shape.
Result<VisualMesh> readMeshShape(const ColladaFrame& frame, const pugi::xml_node& geometry) {
  auto mesh = readMesh(frame, geometry.child("mesh"));
  if (!mesh) {
    return mesh;
  }
  if (mesh->triangles.empty()) {
    return frame.xml().failAt(geometry, "has no triangles, but is a shape");
  }
  for (Vec3& vertex : mesh->vertices) {
    vertex = frame.turnBack(vertex);
  }
  return frame.take(geometry, mesh->vertices.size() + mesh->triangles.size()).map([&] {
    return std::move(*mesh);
  });
}

/// What the shape's `<instance_geometry>` names; nothing, and a note, if that cannot be a shape.
Result<pugi::xml_node> findGeometry(const ColladaFrame& frame, const pugi::xml_node& instance) {
  const auto geometry = frame.followOrMend(instance, "url", "geometry", "the shape is left out");
  if (geometry && *geometry && !geometry->child("mesh") && !geometry->child("convex_mesh")) {
    frame.note(*geometry, "has no <mesh> or <convex_mesh>; shapes of it are left out");
    return pugi::xml_node();
  }
  return geometry;
}

/// Notes what else a shape holds than its size, and geometry beyond the first.
void noteRest(const ColladaFrame& frame, const pugi::xml_node& shape) {
  constexpr std::array<std::string_view, 7> kSized{
      "plane", "box", "sphere", "capsule", "cylinder", "tapered_capsule", "tapered_cylinder"};
  std::size_t count = 0;
  for (const pugi::xml_node& child : shape.children()) {
    const std::string_view name = child.name();
    const bool sized = std::find(kSized.begin(), kSized.end(), name) != kSized.end();
    if (sized) {
      frame.noteUnknown(
          child, {"equation", "half_extents", "half_extends", "radius", "radius1", "radius2", "height"});
    }
    count += sized || name == "instance_geometry" || name == "convex_mesh" ? 1 : 0;
  }
  if (count > 1) {
    frame.note(shape, "holds several geometries; one is read, give the others a <shape> of their own");
  }
}

Result<std::optional<DocumentShape>> readGeometry(const ColladaFrame& frame, const pugi::xml_node& shape) {
  DocumentShape result;
  if (const pugi::xml_node plane = shape.child("plane")) {
    const auto read = readPlane(frame, plane);
    if (!read) {
      return tl::unexpected(read.error());
    }
    result.geometry = *read;
    return result;
  }
  if (const pugi::xml_node instance = shape.child("instance_geometry")) {
    const auto geometry = findGeometry(frame, instance);
    if (!geometry || !*geometry) {
      return geometry.map([](const pugi::xml_node&) { return std::optional<DocumentShape>(); });
    }
    if (!geometry->child("convex_mesh")) {
      return readMeshShape(frame, *geometry).map([&](VisualMesh mesh) {
        result.geometry = std::move(mesh);
        return std::optional(std::move(result));
      });
    }
  }
  const bool known = std::any_of(kShapeReaders.begin(), kShapeReaders.end(),
                                 [&](const ShapeReader& reader) { return shape.child(reader.element); });
  if (!known) {
    frame.note(shape, std::string(kNoGeometry) + "; it is left out");
    return std::nullopt;
  }
  return readConvex(frame, shape).map([&](ConvexShape convex) {
    result.geometry = std::move(convex);
    return std::optional(std::move(result));
  });
}

/// A mass or density; none, and a note, if it is 0.
Result<std::optional<float>> readWeight(const ColladaFrame& frame, const pugi::xml_node& node) {
  const auto value = frame.scalar(node, 0.0, 1e18);
  if (value && *value && **value < 1e-12F) {
    frame.note(node, "is 0 and is ignored");
    return std::nullopt;
  }
  return value;
}

/// Mass, density and place of a shape.
Result<void> readRest(const ColladaFrame& frame, const pugi::xml_node& node, DocumentShape& shape) {
  const auto pose = readPose(frame, node);
  const auto mass = readWeight(frame, node.child("mass"));
  const auto density = readWeight(frame, node.child("density"));
  const auto hollow = frame.flag(node.child("hollow"), false);
  if (!pose) {
    return tl::unexpected(pose.error());
  }
  if (!mass || !density) {
    return tl::unexpected(mass ? density.error() : mass.error());
  }
  if (!hollow) {
    return tl::unexpected(hollow.error());
  }
  shape.pose = frame.inYUp(*pose);
  shape.mass = *mass;
  if (*density) {
    const double unit = frame.metersPerUnit();
    const double value = **density / (unit * unit * unit);
    if (!(value > 1e-12 && value < 1e18)) {
      return frame.xml().failAt(node.child("density"), "is beyond all matter in the file's unit");
    }
    shape.density = static_cast<float>(value);
  }
  if (*hollow) {
    frame.note(node.child("hollow"), "hollow shapes are not supported; it is taken as solid");
  }
  return {};
}

}  // namespace

Result<std::optional<DocumentShape>> readShape(const ColladaFrame& frame, const pugi::xml_node& shape) {
  frame.noteUnknown(shape, {"hollow", "mass", "density", "instance_physics_material", "physics_material",
                            "plane", "box", "sphere", "capsule", "cylinder", "tapered_capsule",
                            "tapered_cylinder", "convex_mesh", "instance_geometry", "translate", "rotate"});
  noteRest(frame, shape);
  auto result = readGeometry(frame, shape);
  if (!result || !*result) {
    return result;
  }
  return frame.take(shape, 1).and_then([&] { return readRest(frame, shape, **result); }).map([&] {
    return std::move(*result);
  });
}

Result<Level> readShapes(const ColladaFrame& frame, const pugi::xml_node& parent) {
  Level level;
  for (const pugi::xml_node& node : parent.children("shape")) {
    auto shape = readConvex(frame, node);
    if (!shape) {
      return tl::unexpected(shape.error());
    }
    const auto pose = readPose(frame, node);
    if (!pose) {
      return tl::unexpected(pose.error());
    }
    level.parts.push_back({std::move(*shape), frame.inYUp(*pose)});
  }
  if (level.parts.empty()) {
    return frame.xml().failAt(parent, "has no <shape>; a level needs at least one");
  }
  return level;
}

}  // namespace scatter::io
