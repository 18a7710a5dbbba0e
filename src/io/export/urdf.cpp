#include <scatter/io/file.h>
#include <scatter/io/level_export.h>

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <pugixml.hpp>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include "io/export/export_parts.h"

namespace scatter {
namespace {

namespace fs = std::filesystem;

/// What is written beside the URDF file.
struct Piece {
  fs::path file;
  std::string text;
};

/// Turns about the fixed axes x, y, z in this order, as URDF has them.
Vec3 rollPitchYaw(const Quat& turn) {
  const Mat3 m(turn);
  const float sine = std::clamp(-m[0][2], -1.0F, 1.0F);
  // Where the nose points straight up, roll and yaw are one turn.
  if (std::abs(sine) > 0.999999F) {
    return {0.0F, std::copysign(glm::half_pi<float>(), sine), std::atan2(-m[1][0], m[1][1])};
  }
  return {std::atan2(m[1][2], m[2][2]), std::asin(sine), std::atan2(m[0][1], m[0][0])};
}

void addOrigin(pugi::xml_node parent, const Transform& pose) {
  pugi::xml_node origin = parent.append_child("origin");
  const Vec3& p = pose.position;
  const Vec3 turn = rollPitchYaw(pose.rotation);
  origin.append_attribute("xyz") = io::words({p.x, p.y, p.z}).c_str();
  origin.append_attribute("rpy") = io::words({turn.x, turn.y, turn.z}).c_str();
}

/// The link's collision elements, and the files that they name.
class Collisions {
 public:
  Collisions(pugi::xml_node link, std::string folder) : link_(link), folder_(std::move(folder)) {}

  Result<void> add(const ConvexPart& part) {
    ++count_;
    return std::visit([&](const auto& shape) { return addShape(shape, part); }, part.shape);
  }

  [[nodiscard]] std::vector<Piece>& pieces() { return pieces_; }

 private:
  Result<void> addShape(const Box& box, const ConvexPart& part) {
    const Vec3 size = 2.0F * box.halfExtents;
    pugi::xml_node shape = geometry(io::zUp(part.pose)).append_child("box");
    shape.append_attribute("size") = io::words({size.x, size.z, size.y}).c_str();
    return {};
  }
  Result<void> addShape(const Sphere& sphere, const ConvexPart& part) {
    addSphere(sphere.radius, io::zUp(part.pose));
    return {};
  }
  Result<void> addShape(const Capsule& capsule, const ConvexPart& part) {
    const Transform pose = io::zUp(part.pose);
    addCylinder(capsule.radius, capsule.halfHeight, pose);
    for (const float end : {-capsule.halfHeight, capsule.halfHeight}) {
      addSphere(capsule.radius, {pose(Vec3(0.0F, 0.0F, end)), pose.rotation});
    }
    return {};
  }
  Result<void> addShape(const Cylinder& cylinder, const ConvexPart& part) {
    addCylinder(cylinder.radius, cylinder.halfHeight, io::zUp(part.pose));
    return {};
  }
  Result<void> addShape(const ConvexHull&, const ConvexPart& part) {
    const Result<SurfaceMesh> surface = io::surfaceOf(part);
    if (!surface) return fail("part " + std::to_string(count_) + ": " + surface.error().message);
    const std::string file = folder_ + "/part" + std::to_string(count_) + ".obj";
    pieces_.push_back({file, io::objObject("part" + std::to_string(count_), io::zUp(*surface), 0)});
    geometry({}).append_child("mesh").append_attribute("filename") = file.c_str();
    return {};
  }

  void addSphere(float radius, const Transform& pose) {
    geometry(pose).append_child("sphere").append_attribute("radius") = io::words({radius}).c_str();
  }
  void addCylinder(float radius, float halfHeight, const Transform& pose) {
    pugi::xml_node shape = geometry(pose).append_child("cylinder");
    shape.append_attribute("radius") = io::words({radius}).c_str();
    shape.append_attribute("length") = io::words({2.0F * halfHeight}).c_str();
  }

  pugi::xml_node geometry(const Transform& pose) {
    pugi::xml_node collision = link_.append_child("collision");
    addOrigin(collision, pose);
    return collision.append_child("geometry");
  }

  pugi::xml_node link_;
  std::string folder_;
  std::vector<Piece> pieces_;
  int count_ = 0;
};

void addLinkInertial(pugi::xml_node link, const Model& model) {
  const MassProperties& mass = model.levels->mass();
  pugi::xml_node inertial = link.append_child("inertial");
  addOrigin(inertial, {io::zUp(mass.centerOfMass), kNoRotation});
  inertial.append_child("mass").append_attribute("value") = io::words({model.mass}).c_str();
  const Mat3 tensor = model.mass * io::zUp(mass.inertia);
  pugi::xml_node inertia = inertial.append_child("inertia");
  constexpr const char* kNames[3][3] = {{"ixx", "ixy", "ixz"}, {"", "iyy", "iyz"}, {"", "", "izz"}};
  for (int row = 0; row < 3; ++row) {
    for (int column = row; column < 3; ++column) {
      inertia.append_attribute(kNames[row][column]) = io::words({tensor[column][row]}).c_str();
    }
  }
}

Result<void> writePieces(const fs::path& folder, const std::vector<Piece>& pieces) {
  for (const Piece& piece : pieces) {
    const fs::path file = folder / piece.file;
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    if (error) return fail("cannot make the folder " + file.parent_path().string() + ": " + error.message());
    if (auto written = writeFile(file, piece.text); !written) return written;
  }
  return {};
}

}  // namespace

Result<void> writeUrdf(const Model& model, int level, const fs::path& path) {
  const auto parts = io::partsOf(model, level);
  if (!parts) return fail(parts.error().message);
  pugi::xml_document document;
  pugi::xml_node robot = document.append_child("robot");
  robot.append_attribute("name") = io::wordOf(model.name).c_str();
  pugi::xml_node link = robot.append_child("link");
  link.append_attribute("name") = io::wordOf(model.name).c_str();
  addLinkInertial(link, model);
  const std::string folder = path.stem().string() + "_meshes";
  std::vector<Piece> visual;
  if (!model.mesh.triangles.empty()) {
    const std::string file = folder + "/visual.obj";
    visual.push_back({file, io::objObject("visual", io::zUp(model.mesh), 0)});
    pugi::xml_node shown = link.append_child("visual").append_child("geometry").append_child("mesh");
    shown.append_attribute("filename") = file.c_str();
  }
  Collisions collisions(link, folder);
  for (const ConvexPart& part : *parts) {
    if (auto added = collisions.add(part); !added) return added;
  }
  // The file that names the others comes last.
  if (auto written = writePieces(path.parent_path(), visual); !written) return written;
  if (auto written = writePieces(path.parent_path(), collisions.pieces()); !written) return written;
  std::ostringstream text;
  document.save(text, "  ", pugi::format_default, pugi::encoding_utf8);
  return writeFile(path, text.str());
}

}  // namespace scatter
