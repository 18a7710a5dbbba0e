#include "io/collada/model_writer.h"

#include <algorithm>
#include <string>

#include "io/collada/joint_writer.h"
#include "io/collada/xml.h"
#include "io/numbers.h"

namespace scatter::io {
namespace {

/// The geometry of a shape: its model, its level (1 without levels) and its place in that level.
std::string geometryId(std::size_t model, int level, const char* kind, std::size_t part) {
  const std::string id = "level" + std::to_string(level) + "-" + kind + std::to_string(part);
  return model == 0 ? id : "model" + std::to_string(model + 1) + "-" + id;
}

int finestLevel(const DocumentModel& model) {
  return model.levels ? model.levels->count() : 1;
}

void writeMesh(pugi::xml_node& library, const std::string& id, const VisualMesh& visual) {
  constexpr std::size_t kPerLine = 8;
  pugi::xml_node geometry = append(library, "geometry");
  setAttribute(geometry, "id", id);
  pugi::xml_node mesh = append(geometry, "mesh");
  writePositions(mesh, id, visual.vertices);
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
  setAttribute(input, "source", link(id + "-vertices"));
  setAttribute(input, "offset", "0");
  appendText(triangles, "p", corners + "\n");
}

void writeHull(pugi::xml_node& library, const std::string& id, const ConvexShape& shape) {
  if (const auto* hull = std::get_if<ConvexHull>(&shape)) {
    pugi::xml_node geometry = append(library, "geometry");
    setAttribute(geometry, "id", id);
    pugi::xml_node convex = append(geometry, "convex_mesh");
    writePositions(convex, id, hull->vertices);
  }
}

void writeShapeGeometries(pugi::xml_node& library, const DocumentModel& model, std::size_t index) {
  for (int level = 1; level < finestLevel(model); ++level) {
    const std::vector<ConvexPart>& parts = model.levels->level(level).parts;
    for (std::size_t part = 0; part < parts.size(); ++part) {
      writeHull(library, geometryId(index, level, "hull", part), parts[part].shape);
    }
  }
  for (std::size_t part = 0; part < model.shapes.size(); ++part) {
    const auto& geometry = model.shapes[part].geometry;
    if (const auto* convex = std::get_if<ConvexShape>(&geometry)) {
      writeHull(library, geometryId(index, finestLevel(model), "hull", part), *convex);
    } else if (const auto* mesh = std::get_if<VisualMesh>(&geometry)) {
      writeMesh(library, geometryId(index, finestLevel(model), "mesh", part), *mesh);
    }
  }
}

/// Adds the geometry of a shape to its `<shape>` element.
struct ShapeWriter {
  pugi::xml_node& shape;
  std::size_t model;
  int level;
  std::size_t part;

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
  void operator()(const ConvexHull&) { writeInstance("hull"); }
  void operator()(const VisualMesh&) { writeInstance("mesh"); }
  void operator()(const ConvexShape& convex) { std::visit(*this, convex); }
  void operator()(const DocumentPlane& plane) {
    pugi::xml_node node = append(shape, "plane");
    appendText(node, "equation", formatVector(plane.normal) + " " + formatNumber(-plane.offset));
  }

  void writeInstance(const char* kind) {
    pugi::xml_node node = append(shape, "instance_geometry");
    setAttribute(node, "url", link(geometryId(model, level, kind, part)));
  }
  void writeRound(const char* name, float radius, float halfHeight) {
    pugi::xml_node node = append(shape, name);
    appendText(node, "height", formatNumber(2.0F * halfHeight));
    appendText(node, "radius", formatNumber(radius) + " " + formatNumber(radius));
  }
};

void writeMaterialLink(pugi::xml_node& parent, const std::optional<std::size_t>& material) {
  if (material) {
    pugi::xml_node instance = append(parent, "instance_physics_material");
    setAttribute(instance, "url", link(makeId("material", *material)));
  }
}

void writeNumber(pugi::xml_node& parent, const char* name, const std::optional<float>& value) {
  if (value) {
    appendText(parent, name, formatNumber(*value));
  }
}

void writeShapes(pugi::xml_node& common, const DocumentModel& model, std::size_t index) {
  for (std::size_t part = 0; part < model.shapes.size(); ++part) {
    const DocumentShape& shape = model.shapes[part];
    pugi::xml_node node = append(common, "shape");
    writeNumber(node, "mass", shape.mass);
    writeNumber(node, "density", shape.density);
    writeMaterialLink(node, shape.material);
    std::visit(ShapeWriter{node, index, finestLevel(model), part}, shape.geometry);
    writePose(node, shape.pose);
  }
}

void writeCoarserLevels(pugi::xml_node& body, const LevelSet& levels, std::size_t model) {
  pugi::xml_node technique = scatterTechnique(body);
  pugi::xml_node list = append(technique, "levels");
  setAttribute(list, "margin", formatNumber(levels.hullMargin()));
  setAttribute(list, "count", std::to_string(levels.count()));
  for (int index = 1; index < levels.count(); ++index) {
    pugi::xml_node level = append(list, "level");
    setAttribute(level, "index", std::to_string(index));
    const std::vector<ConvexPart>& parts = levels.level(index).parts;
    for (std::size_t part = 0; part < parts.size(); ++part) {
      pugi::xml_node shape = append(level, "shape");
      std::visit(ShapeWriter{shape, model, index, part}, parts[part].shape);
      writePose(shape, parts[part].pose);
    }
  }
}

void writeMassFrame(pugi::xml_node& common, const DocumentMassFrame& massFrame) {
  pugi::xml_node node = append(common, "mass_frame");
  writePose(node, massFrame.pose);
  // The schema wants no empty one.
  if (!node.first_child()) {
    appendText(node, "translate", "0 0 0");
  }
  if (massFrame.inertia) {
    appendText(common, "inertia", formatVector(*massFrame.inertia));
  }
}

bool isShown(const PhysicsDocument& document, std::size_t model) {
  return std::any_of(document.bodies.begin(), document.bodies.end(),
                     [&](const DocumentBody& body) { return body.model == model; });
}

void writePhysicsModel(pugi::xml_node& library, const PhysicsDocument& document, std::size_t index) {
  const DocumentModel& model = document.models[index];
  pugi::xml_node physics = append(library, "physics_model");
  setAttribute(physics, "id", makeId("physics_model", index));
  setAttribute(physics, "name", formatName(model.name));
  pugi::xml_node body = append(physics, "rigid_body");
  setAttribute(body, "sid", "body");
  pugi::xml_node common = append(body, "technique_common");
  appendText(common, "dynamic", model.motion == DocumentMotion::kDynamic ? "true" : "false");
  writeNumber(common, "mass", model.mass);
  if (model.massFrame) {
    writeMassFrame(common, *model.massFrame);
  }
  writeMaterialLink(common, model.material);
  writeShapes(common, model, index);
  if (model.levels) {
    writeCoarserLevels(body, *model.levels, index);
  }
  if (model.motion == DocumentMotion::kKinematic) {
    pugi::xml_node technique = scatterTechnique(body);
    appendText(technique, "motion", "kinematic");
  }
  // The mesh of a model with bodies hangs on their nodes.
  if (!model.mesh.vertices.empty() && !isShown(document, index)) {
    pugi::xml_node technique = scatterTechnique(body);
    // Not <mesh>, which the schema knows and would want to be one.
    pugi::xml_node mesh = append(technique, "shown_mesh");
    setAttribute(mesh, "url", link(makeId("mesh", index)));
  }
}

}  // namespace

void writeGeometries(pugi::xml_node& root, const PhysicsDocument& document) {
  pugi::xml_node library = append(root, "library_geometries");
  for (std::size_t index = 0; index < document.models.size(); ++index) {
    const DocumentModel& model = document.models[index];
    if (!model.mesh.vertices.empty()) {
      writeMesh(library, makeId("mesh", index), model.mesh);
    }
    writeShapeGeometries(library, model, index);
  }
  // The schema wants no library without an entry.
  if (!library.first_child()) {
    root.remove_child(library);
  }
}

void writeMaterials(pugi::xml_node& root, const PhysicsDocument& document) {
  writeLibrary(root, "physics_material", "material", document.materials,
               [](pugi::xml_node& node, const DocumentMaterial& material) {
                 pugi::xml_node technique = append(node, "technique_common");
                 appendText(technique, "dynamic_friction", formatNumber(material.dynamicFriction));
                 appendText(technique, "restitution", formatNumber(material.restitution));
                 appendText(technique, "static_friction", formatNumber(material.staticFriction));
               });
}

void writePhysicsModels(pugi::xml_node& root, const PhysicsDocument& document) {
  pugi::xml_node library = append(root, "library_physics_models");
  for (std::size_t index = 0; index < document.models.size(); ++index) {
    writePhysicsModel(library, document, index);
  }
  writeConstraints(library, document);
}

}  // namespace scatter::io
