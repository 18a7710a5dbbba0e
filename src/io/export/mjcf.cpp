#include <scatter/io/file.h>
#include <scatter/io/level_export.h>

#include <pugixml.hpp>
#include <sstream>
#include <string>
#include <variant>

#include "io/export/export_parts.h"
#include "levels/part_geometry.h"

namespace scatter {
namespace {

/// MuJoCo's own defaults of torsional and rolling friction.
constexpr float kTorsion = 0.005F;
constexpr float kRolling = 0.0001F;

void set(pugi::xml_node node, const char* name, const std::string& value) {
  node.append_attribute(name) = value.c_str();
}

std::string vectorWords(const Vec3& v) {
  return io::words({v.x, v.y, v.z});
}

/// Geoms of a body, and the meshes that they name.
class Geoms {
 public:
  Geoms(pugi::xml_node assets, pugi::xml_node body, float friction)
      : assets_(assets), body_(body), friction_(io::words({friction, kTorsion, kRolling})) {}

  Result<void> add(const ConvexPart& part) {
    ++count_;
    if (const auto* hull = std::get_if<ConvexHull>(&part.shape)) return addHull(*hull, part.pose);
    pugi::xml_node geom = append(io::zUp(part.pose));
    std::visit([&](const auto& shape) { describe(geom, shape); }, part.shape);
    return {};
  }

 private:
  static void describe(pugi::xml_node geom, const Box& box) {
    set(geom, "type", "box");
    set(geom, "size", io::words({box.halfExtents.x, box.halfExtents.z, box.halfExtents.y}));
  }
  static void describe(pugi::xml_node geom, const Sphere& sphere) {
    set(geom, "type", "sphere");
    set(geom, "size", io::words({sphere.radius}));
  }
  static void describe(pugi::xml_node geom, const Capsule& capsule) {
    set(geom, "type", "capsule");
    set(geom, "size", io::words({capsule.radius, capsule.halfHeight}));
  }
  static void describe(pugi::xml_node geom, const Cylinder& cylinder) {
    set(geom, "type", "cylinder");
    set(geom, "size", io::words({cylinder.radius, cylinder.halfHeight}));
  }
  static void describe(pugi::xml_node, const ConvexHull&) {}

  // Where MuJoCo moves a mesh to its own middle, it counts that in.
  Result<void> addHull(const ConvexHull& hull, const Transform& pose) {
    if (const auto solid = levels::placedHull(hull, pose); !solid) {
      return fail("part " + std::to_string(count_) + ": " + solid.error().message);
    }
    const std::string name = "part" + std::to_string(count_);
    pugi::xml_node mesh = assets_.append_child("mesh");
    set(mesh, "name", name);
    std::string vertices;
    for (const Vec3& vertex : hull.vertices) {
      vertices += (vertices.empty() ? "" : " ") + vectorWords(io::zUp(pose(vertex)));
    }
    set(mesh, "vertex", vertices);
    pugi::xml_node geom = append({});
    set(geom, "type", "mesh");
    set(geom, "mesh", name);
    return {};
  }

  pugi::xml_node append(const Transform& pose) {
    pugi::xml_node geom = body_.append_child("geom");
    const Quat& q = pose.rotation;
    set(geom, "pos", vectorWords(pose.position));
    set(geom, "quat", io::words({q.w, q.x, q.y, q.z}));
    set(geom, "friction", friction_);
    return geom;
  }

  pugi::xml_node assets_;
  pugi::xml_node body_;
  std::string friction_;
  int count_ = 0;
};

void addBodyInertial(pugi::xml_node body, const Model& model) {
  const MassProperties& mass = model.levels->mass();
  const Mat3 tensor = model.mass * io::zUp(mass.inertia);
  pugi::xml_node inertial = body.append_child("inertial");
  set(inertial, "pos", vectorWords(io::zUp(mass.centerOfMass)));
  set(inertial, "mass", io::words({model.mass}));
  set(inertial, "fullinertia",
      io::words({tensor[0][0], tensor[1][1], tensor[2][2], tensor[1][0], tensor[2][0], tensor[2][1]}));
}

}  // namespace

Result<void> writeMjcf(const Model& model, int level, const std::filesystem::path& path) {
  const auto parts = io::partsOf(model, level);
  if (!parts) return fail(parts.error().message);
  pugi::xml_document document;
  pugi::xml_node root = document.append_child("mujoco");
  set(root, "model", io::wordOf(model.name));
  pugi::xml_node assets = root.append_child("asset");
  pugi::xml_node body = root.append_child("worldbody").append_child("body");
  set(body, "name", io::wordOf(model.name));
  body.append_child("freejoint");
  addBodyInertial(body, model);
  Geoms geoms(assets, body, model.friction);
  for (const ConvexPart& part : *parts) {
    if (auto added = geoms.add(part); !added) return added;
  }
  std::ostringstream text;
  document.save(text, "  ", pugi::format_default, pugi::encoding_utf8);
  return writeFile(path, text.str());
}

}  // namespace scatter
