#include <scatter/io/collada.h>
#include <scatter/io/file.h>

#include <algorithm>
#include <cmath>
#include <pugixml.hpp>
#include <span>
#include <string>
#include <utility>

#include "io/collada_shapes.h"
#include "io/numbers.h"
#include "io/xml_source.h"

namespace scatter::io {
namespace {

constexpr const char* kMeshId = "mesh";
constexpr const char* kMaterialId = "material";
constexpr const char* kNodeId = "node";
constexpr const char* kBodyId = "body";

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

std::string link(const std::string& id) {
  return std::string("#").append(id);
}

std::string formatVector(const Vec3& v) {
  return formatNumber(v.x) + " " + formatNumber(v.y) + " " + formatNumber(v.z);
}

/// The name as an XML NCName, which is all that COLLADA's attributes allow.
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

/// Axis and degrees with as few digits as give back the same quaternion.
std::string formatRotation(const Quat& rotation) {
  const double x = rotation.x;
  const double y = rotation.y;
  const double z = rotation.z;
  const double length = std::hypot(x, y, z);
  const double degrees = 2.0 * std::atan2(length, static_cast<double>(rotation.w)) * 57.295779513082320877;
  std::string text;
  for (int digits = 3; digits <= 17; ++digits) {
    const std::string words[] = {formatNumber(x / length, digits), formatNumber(y / length, digits),
                                 formatNumber(z / length, digits), formatNumber(degrees, digits)};
    text = words[0] + " " + words[1] + " " + words[2] + " " + words[3];
    if (rotationFromDegrees(parseNumber(words[0]).value_or(0.0), parseNumber(words[1]).value_or(0.0),
                            parseNumber(words[2]).value_or(0.0),
                            parseNumber(words[3]).value_or(0.0)) == rotation) {
      break;
    }
  }
  return text;
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

void writeMesh(pugi::xml_node& library, const VisualMesh& visual) {
  constexpr std::size_t kPerLine = 8;
  pugi::xml_node geometry = append(library, "geometry");
  setAttribute(geometry, "id", kMeshId);
  pugi::xml_node mesh = append(geometry, "mesh");
  writePositions(mesh, kMeshId, visual.vertices);
  std::string corners;
  for (std::size_t i = 0; i < visual.triangles.size(); ++i) {
    const auto& [a, b, c] = visual.triangles[i];
    corners.append(i % kPerLine == 0 ? "\n" : " ").append(std::to_string(a));
    corners.append(" ").append(std::to_string(b)).append(" ").append(std::to_string(c));
  }
  pugi::xml_node triangles = append(mesh, "triangles");
  setAttribute(triangles, "count", std::to_string(visual.triangles.size()));
  pugi::xml_node input = append(triangles, "input");
  setAttribute(input, "semantic", "VERTEX");
  setAttribute(input, "source", link(std::string(kMeshId) + "-vertices"));
  setAttribute(input, "offset", "0");
  appendText(triangles, "p", corners + "\n");
}

std::string hullId(int level, std::size_t part) {
  return "level" + std::to_string(level) + "-hull" + std::to_string(part);
}

void writeGeometries(pugi::xml_node& root, const Model& model) {
  pugi::xml_node library = append(root, "library_geometries");
  if (!model.mesh.vertices.empty()) {
    writeMesh(library, model.mesh);
  }
  for (int index = 1; index <= model.levels->count(); ++index) {
    const std::vector<ConvexPart>& parts = model.levels->level(index).parts;
    for (std::size_t part = 0; part < parts.size(); ++part) {
      const auto* hull = std::get_if<ConvexHull>(&parts[part].shape);
      if (hull == nullptr) {
        continue;
      }
      pugi::xml_node geometry = append(library, "geometry");
      setAttribute(geometry, "id", hullId(index, part));
      pugi::xml_node convex = append(geometry, "convex_mesh");
      writePositions(convex, hullId(index, part), hull->vertices);
    }
  }
  // The schema wants no library without an entry.
  if (!library.first_child()) {
    root.remove_child(library);
  }
}

/// Adds the geometry of a shape to its `<shape>` element.
struct ShapeWriter {
  pugi::xml_node& shape;
  std::string hull;

  void operator()(const Box& box) {
    pugi::xml_node node = append(shape, "box");
    appendText(node, "half_extents", formatVector(box.halfExtents));
  }
  void operator()(const Sphere& sphere) {
    pugi::xml_node node = append(shape, "sphere");
    appendText(node, "radius", formatNumber(sphere.radius));
  }
  void operator()(const Capsule& capsule) { writeRound("capsule", capsule.radius, capsule.halfHeight); }
  void operator()(const Cylinder& cylinder) { writeRound("cylinder", cylinder.radius, cylinder.halfHeight); }
  void operator()(const ConvexHull&) {
    pugi::xml_node node = append(shape, "instance_geometry");
    setAttribute(node, "url", link(hull));
  }

  void writeRound(const char* name, float radius, float halfHeight) {
    pugi::xml_node node = append(shape, name);
    appendText(node, "height", formatNumber(2.0F * halfHeight));
    appendText(node, "radius", formatNumber(radius) + " " + formatNumber(radius));
  }
};

void writeShapes(pugi::xml_node& parent, const LevelSet& levels, int index) {
  const std::vector<ConvexPart>& parts = levels.level(index).parts;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    pugi::xml_node shape = append(parent, "shape");
    std::visit(ShapeWriter{shape, hullId(index, part)}, parts[part].shape);
    const Transform& pose = parts[part].pose;
    if (pose.position != Vec3(0.0F)) {
      appendText(shape, "translate", formatVector(pose.position));
    }
    if (pose.rotation != kNoRotation) {
      appendText(shape, "rotate", formatRotation(pose.rotation));
    }
  }
}

void writeMaterial(pugi::xml_node& root, const Model& model) {
  pugi::xml_node library = append(root, "library_physics_materials");
  pugi::xml_node material = append(library, "physics_material");
  setAttribute(material, "id", kMaterialId);
  pugi::xml_node technique = append(material, "technique_common");
  appendText(technique, "dynamic_friction", formatNumber(model.friction));
  appendText(technique, "restitution", formatNumber(model.restitution));
  appendText(technique, "static_friction", formatNumber(model.friction));
}

void writeCoarserLevels(pugi::xml_node& body, const LevelSet& levels) {
  pugi::xml_node extra = append(body, "extra");
  pugi::xml_node technique = append(extra, "technique");
  setAttribute(technique, "profile", "SCATTER");
  pugi::xml_node list = append(technique, "levels");
  setAttribute(list, "margin", formatNumber(levels.hullMargin()));
  setAttribute(list, "count", std::to_string(levels.count()));
  for (int index = 1; index < levels.count(); ++index) {
    pugi::xml_node level = append(list, "level");
    setAttribute(level, "index", std::to_string(index));
    writeShapes(level, levels, index);
  }
}

void writePhysicsModel(pugi::xml_node& root, const Model& model) {
  pugi::xml_node library = append(root, "library_physics_models");
  pugi::xml_node physics = append(library, "physics_model");
  setAttribute(physics, "id", "physics_model");
  setAttribute(physics, "name", formatName(model.name));
  pugi::xml_node body = append(physics, "rigid_body");
  setAttribute(body, "sid", kBodyId);
  pugi::xml_node common = append(body, "technique_common");
  appendText(common, "dynamic", "true");
  appendText(common, "mass", formatNumber(model.mass));
  pugi::xml_node material = append(common, "instance_physics_material");
  setAttribute(material, "url", link(kMaterialId));
  writeShapes(common, *model.levels, model.levels->count());
  writeCoarserLevels(body, *model.levels);
}

void writeScenes(pugi::xml_node& root, bool hasMesh) {
  pugi::xml_node visuals = append(root, "library_visual_scenes");
  pugi::xml_node visual = append(visuals, "visual_scene");
  setAttribute(visual, "id", "visual_scene");
  pugi::xml_node node = append(visual, "node");
  setAttribute(node, "id", kNodeId);
  if (hasMesh) {
    pugi::xml_node instance = append(node, "instance_geometry");
    setAttribute(instance, "url", link(kMeshId));
  }
  pugi::xml_node scenes = append(root, "library_physics_scenes");
  pugi::xml_node physics = append(scenes, "physics_scene");
  setAttribute(physics, "id", "physics_scene");
  pugi::xml_node instanceModel = append(physics, "instance_physics_model");
  setAttribute(instanceModel, "url", "#physics_model");
  pugi::xml_node instanceBody = append(instanceModel, "instance_rigid_body");
  setAttribute(instanceBody, "body", kBodyId);
  setAttribute(instanceBody, "target", link(kNodeId));
  append(instanceBody, "technique_common");
  append(physics, "technique_common");
  pugi::xml_node scene = append(root, "scene");
  pugi::xml_node instancePhysics = append(scene, "instance_physics_scene");
  setAttribute(instancePhysics, "url", "#physics_scene");
  pugi::xml_node instanceVisual = append(scene, "instance_visual_scene");
  setAttribute(instanceVisual, "url", "#visual_scene");
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

bool isFinite(const Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool isInRange(float value, float low, float high) {
  return value >= low && value <= high;
}

Result<void> checkWritable(const Model& model) {
  const std::string who = "model " + inQuotes(model.name) + " cannot be written: ";
  if (model.levels == nullptr) {
    return fail(who + "it has no levels");
  }
  if (!isInRange(model.mass, 1e-9F, 1e12F)) {
    return fail(who + "its mass of " + formatNumber(model.mass) + " kg is not positive and finite");
  }
  if (!isInRange(model.friction, 0.0F, 1e3F) || !isInRange(model.restitution, 0.0F, 1.0F)) {
    return fail(who + "friction is not from 0 to 1000 or restitution not from 0 to 1");
  }
  if (!std::all_of(model.mesh.vertices.begin(), model.mesh.vertices.end(), isFinite)) {
    return fail(who + "its mesh has a vertex that is not finite");
  }
  const auto isBeyond = [&](std::uint32_t corner) { return corner >= model.mesh.vertices.size(); };
  for (const auto& triangle : model.mesh.triangles) {
    if (std::any_of(triangle.begin(), triangle.end(), isBeyond)) {
      return fail(who + "a triangle of its mesh names a vertex that does not exist");
    }
  }
  return {};
}

struct StringWriter : pugi::xml_writer {
  std::string text;
  void write(const void* data, std::size_t size) override {
    text.append(static_cast<const char*>(data), size);
  }
};

}  // namespace
}  // namespace scatter::io

namespace scatter {

Result<void> writeCollada(const Model& model, const std::filesystem::path& path) {
  if (auto writable = io::checkWritable(model); !writable) {
    return writable;
  }
  pugi::xml_document document;
  pugi::xml_node root = io::writeRoot(document);
  io::writeGeometries(root, model);
  io::writeMaterial(root, model);
  io::writePhysicsModel(root, model);
  io::writeScenes(root, !model.mesh.vertices.empty());
  io::StringWriter text;
  document.save(text, "  ", pugi::format_default, pugi::encoding_utf8);
  return writeFile(path, text.text);
}

}  // namespace scatter
