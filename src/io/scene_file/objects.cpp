#include "io/scene_file/objects.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <utility>

#include "io/collada/xml_source.h"
#include "io/scene_file/ground.h"

namespace scatter::io {
namespace {

constexpr std::size_t kMostHullPoints = 256;
constexpr std::size_t kMostGibs = 256;

/// A Capsule or Cylinder.
template <class Round>
Round readRound(const SceneTable& object, std::string_view key, std::string_view section) {
  Round round;
  float length = 0.0F;
  if (const auto table = object.table(key, section)) {
    table->need("radius", round.radius);
    table->need("length", length);
  }
  round.halfHeight = 0.5F * length;
  return round;
}

SceneFileBall readBall(const SceneTable& object) {
  SceneFileBall ball;
  if (!object.is<TomlNode::Array>("sphere")) {
    object.read("sphere", ball.minRadius);
    ball.maxRadius = ball.minRadius;
    return ball;
  }
  std::vector<float> radii;
  object.read("sphere", radii);
  if (radii.size() != 2 || !(radii[0] <= radii[1])) {
    object.report("sphere", R"("sphere" must be a radius, or the least and the most of radii)");
    return ball;
  }
  return {radii[0], radii[1]};
}

ConvexHull readHull(const SceneTable& object) {
  ConvexHull hull;
  object.read("hull", hull.vertices);
  if (hull.vertices.size() < 4 || hull.vertices.size() > kMostHullPoints) {
    object.report("hull", R"("hull" must have 4 to )" + std::to_string(kMostHullPoints) + " points, not " +
                              std::to_string(hull.vertices.size()));
  }
  return hull;
}

std::string readModel(const SceneTable& object, std::string_view key, std::string name) {
  if (name.empty()) object.report(key, inQuotes(key) + " must be the name of a model or of a file");
  return name;
}

SceneFileShape readShape(const SceneTable& object) {
  const std::string_view kind = object.oneOf(
      {"model", "box", "sphere", "capsule", "cylinder", "hull", "plane", "mesh", "terrain"}, true);
  if (kind == "model") {
    SceneFileModel model;
    object.read("model", model.name);
    model.name = readModel(object, "model", std::move(model.name));
    object.readWhole("levels", model.levels);
    return model;
  }
  if (object.has("levels")) object.report("levels", R"("levels" goes with "model")");
  if (kind == "box") {
    Vec3 size(1.0F);
    object.read("box", size);
    for (int axis = 0; axis < 3; ++axis) size[axis] *= 0.5F;
    return Box{size};
  }
  if (kind == "capsule") return readRound<Capsule>(object, kind, "object.capsule");
  if (kind == "cylinder") return readRound<Cylinder>(object, kind, "object.cylinder");
  if (kind == "hull") return readHull(object);
  if (kind == "plane") {
    SceneFilePlane plane;
    object.needDirection("plane", plane.normal);
    return plane;
  }
  if (kind == "mesh") {
    SceneFileMesh mesh;
    object.read("mesh", mesh.file);
    if (mesh.file.empty()) object.report("mesh", R"("mesh" must be the name of a file)");
    return mesh;
  }
  if (kind == "terrain") return readTerrain(object);
  return readBall(object);
}

std::vector<Vec3> readGrid(const SceneTable& object) {
  std::vector<Vec3> places;
  const auto table = object.table("grid", "object.grid");
  if (!table) return places;
  std::vector<Vec3> counts;
  Vec3 count(1.0F);
  Vec3 spacing(0.0F);
  Vec3 center(0.0F);
  table->need("count", count);
  table->need("spacing", spacing);
  table->read("center", center);
  const bool whole = count == glm::floor(count);
  const double all =
      static_cast<double>(count.x) * static_cast<double>(count.y) * static_cast<double>(count.z);
  if (!whole) table->report("count", R"("count" in grid must be whole numbers)");
  if (all > static_cast<double>(kMostSceneBodies)) {
    table->report("count", "a grid of more than " + std::to_string(kMostSceneBodies) + " bodies");
  }
  if (object.problem().any()) return places;
  const Vec3 middle = 0.5F * (count - Vec3(1.0F));
  for (int y = 0; y < static_cast<int>(count.y); ++y) {
    for (int z = 0; z < static_cast<int>(count.z); ++z) {
      for (int x = 0; x < static_cast<int>(count.x); ++x) {
        places.push_back(center + spacing * (Vec3(x, y, z) - middle));
      }
    }
  }
  return places;
}

SceneFileStack readStack(const SceneTable& object, std::size_t& count) {
  SceneFileStack stack;
  if (const auto table = object.table("stack", "object.stack")) {
    if (table->require("count")) table->readWhole("count", count);
    table->read("base", stack.base);
    table->read("gap", stack.gap);
  }
  return stack;
}

void checkStack(const SceneTable& table, const SceneFileObject& object) {
  const auto* ball = std::get_if<SceneFileBall>(&object.shape);
  if (!staticKind(object.shape).empty() || (ball != nullptr && ball->minRadius != ball->maxRadius) ||
      object.orientation.kind == SceneFileOrientation::Kind::kRandom) {
    table.report("stack",
                 "a stack cannot be of planes, meshes, terrains, random orientations or random sizes");
  }
}

SceneFilePlacement readPlacement(const SceneTable& table, SceneFileObject& object, const SceneNames& names) {
  const std::string_view kind = table.oneOf({"at", "list", "grid", "stack", "in"}, false);
  if (kind != "in" && table.has("count")) {
    table.report("count", R"("count" in [[object]] goes with "in"; a grid or stack has its own)");
  }
  if (kind == "stack") return readStack(table, object.count);
  if (kind == "in") {
    table.readWhole("count", object.count);
    if (const std::string_view fixed = staticKind(object.shape); !fixed.empty()) {
      table.report("in", std::string(fixed) + " cannot be placed in a region");
    }
    return SceneFileRandomPlaces{names.find(table, "in", "region").value_or(0)};
  }
  std::vector<Vec3> places;
  if (kind == "list") {
    table.read("list", places);
    if (places.empty()) table.report("list", R"("list" in [[object]] has no places)");
  } else if (kind == "grid") {
    places = readGrid(table);
  } else {
    places.emplace_back(0.0F);
    table.read("at", places.front());
  }
  object.count = places.size();
  return places;
}

SceneFileOrientation readOrientation(const SceneTable& object) {
  using Kind = SceneFileOrientation::Kind;
  SceneFileOrientation orientation;
  if (object.is<std::string>("orientation")) {
    const auto choice = object.choose("orientation", {"random", "upright"});
    orientation.kind = choice == std::size_t{1} ? Kind::kUpright : Kind::kRandom;
    return orientation;
  }
  const auto table = object.table("orientation", "object.orientation");
  if (!table) return orientation;
  const std::string_view form = table->oneOf({"axis", "quaternion"}, true);
  if (form == "quaternion") {
    table->read("quaternion", orientation.rotation);
    if (table->has("angle")) table->report("angle", R"("angle" goes with "axis", not with "quaternion")");
    return orientation;
  }
  Vec3 axis(0.0F, 1.0F, 0.0F);
  float angle = 0.0F;
  table->needDirection("axis", axis);
  table->need("angle", angle);
  orientation.rotation = glm::angleAxis(glm::radians(angle), axis);
  return orientation;
}

SceneFileVelocity readVelocityTable(const SceneTable& table) {
  using Kind = SceneFileVelocity::Kind;
  SceneFileVelocity velocity;
  const std::string_view form = table.oneOf({"random", "toward", "away"}, true);
  const auto belongs = [&](std::string_view key, std::string_view to) {
    if (table.has(key) && form != to) {
      table.report(key, inQuotes(key) + " goes with " + inQuotes(to));
    }
  };
  belongs("speed", "toward");
  belongs("rate", "away");
  if (form == "random") {
    velocity.kind = Kind::kRandom;
    table.read("random", velocity.amount);
  } else if (form == "toward") {
    velocity.kind = Kind::kToward;
    table.read("toward", velocity.vector);
    table.need("speed", velocity.amount);
  } else {
    velocity.kind = Kind::kAway;
    table.read("away", velocity.vector);
    table.need("rate", velocity.amount);
  }
  return velocity;
}

SceneFileVelocity readVelocity(const SceneTable& object) {
  SceneFileVelocity velocity;
  if (object.is<TomlNode::Table>("velocity")) {
    if (const auto table = object.table("velocity", "object.velocity")) return readVelocityTable(*table);
  }
  object.read("velocity", velocity.vector);
  return velocity;
}

SceneFileVelocity readSpin(const SceneTable& object) {
  SceneFileVelocity spin;
  if (object.is<TomlNode::Table>("spin")) {
    spin.kind = SceneFileVelocity::Kind::kRandom;
    if (const auto table = object.table("spin", "object.spin")) table->need("random", spin.amount);
    return spin;
  }
  object.read("spin", spin.vector);
  return spin;
}

SceneFileMotion readMotion(const SceneTable& table, const SceneFileShape& shape) {
  const std::string_view fixed = staticKind(shape);
  const auto choice = table.choose("motion", {"static", "kinematic", "dynamic"});
  const auto standard =
      static_cast<std::size_t>(fixed.empty() ? SceneFileMotion::kDynamic : SceneFileMotion::kStatic);
  const auto motion = static_cast<SceneFileMotion>(choice.value_or(standard));
  if (!fixed.empty() && motion != SceneFileMotion::kStatic) {
    table.report("motion", std::string(fixed) + " can only be static");
  }
  return motion;
}

void readBody(const SceneTable& table, SceneFileObject& object,
              const std::vector<SceneFileMaterial>& materials, const SceneNames& names) {
  object.motion = readMotion(table, object.shape);
  table.checkOneOf({"mass", "density"}, false);
  table.read("mass", object.mass);
  table.read("density", object.density);
  if (const std::string_view fixed = staticKind(object.shape); object.density && !fixed.empty()) {
    table.report("density", std::string(fixed) + R"( has no volume; leave "density" out)");
  }
  if (table.has("material")) {
    if (const auto index = names.find(table, "material", "material")) object.material = materials[*index];
  }
  readSurface(table, object.material);
  table.read("may_rest", object.mayRest);
  table.read("in_fields", object.inFields);
  table.read("sensor", object.sensor);
  std::vector<std::string> gibs;
  table.readTexts("gibs", gibs);
  if (gibs.size() > kMostGibs) table.report("gibs", "more than " + std::to_string(kMostGibs) + " gibs");
  for (std::string& gib : gibs) {
    object.gibs.push_back({.name = readModel(table, "gibs", std::move(gib))});
  }
}

void nameBodies(SceneFile& scene, const SceneFileObject& object, SceneNames& names) {
  names.addBodies(object.line, object.name, object.firstBody, object.count);
  if (object.count == 1) {
    scene.bodies.push_back(object.name);
    return;
  }
  for (std::size_t i = 0; i < object.count; ++i) {
    scene.bodies.push_back(object.name + "-" + std::to_string(i + 1));
    names.addBodies(object.line, scene.bodies.back(), object.firstBody + i, 1);
  }
}

void readObject(const SceneTable& table, SceneFile& scene, const std::vector<SceneFileMaterial>& materials,
                SceneNames& names) {
  SceneFileObject object;
  object.line = table.line();
  table.demand("name");
  object.name = readName(table, "name");
  object.shape = readShape(table);
  readBody(table, object, materials, names);
  object.orientation = readOrientation(table);
  object.placement = readPlacement(table, object, names);
  if (std::holds_alternative<SceneFileStack>(object.placement)) checkStack(table, object);
  object.velocity = readVelocity(table);
  object.spin = readSpin(table);
  object.firstBody = scene.bodies.size();
  if (object.count > kMostSceneBodies - scene.bodies.size()) {
    table.problem().report(object.line, "more than " + std::to_string(kMostSceneBodies) + " bodies");
  }
  if (table.problem().any()) return;
  const std::string group = table.has("group") ? readName(table, "group") : kDefaultGroup;
  object.group = names.groupBit(table, group);
  names.addToGroup(object.line, group, object.firstBody, object.count);
  nameBodies(scene, object, names);
  scene.objects.push_back(std::move(object));
}

}  // namespace

void readSurface(const SceneTable& table, SceneFileMaterial& material) {
  table.read("friction", material.friction);
  table.read("rolling_friction", material.rollingFriction);
  table.read("spinning_friction", material.spinningFriction);
  table.read("restitution", material.restitution);
  table.read("linear_damping", material.linearDamping);
  table.read("angular_damping", material.angularDamping);
}

void readObjects(const SceneTable& file, SceneFile& scene, const std::vector<SceneFileMaterial>& materials,
                 SceneNames& names) {
  const std::vector<SceneTable> tables = file.tables("object", "object");
  for (const SceneTable& table : tables) {
    readObject(table, scene, materials, names);
    if (table.problem().any()) return;
  }
  // Groups may be named before their members.
  for (std::size_t i = 0; i < tables.size(); ++i) {
    SceneFileObject& object = scene.objects[i];
    if (tables[i].has("collides_with")) object.collidesWith = names.groupBits(tables[i], "collides_with");
    object.collidesWith &= ~names.groupBits(tables[i], "ignores");
  }
  names.addGroups();
}

}  // namespace scatter::io
