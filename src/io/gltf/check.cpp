#include "io/gltf/check.h"

#include <scatter/levels/mass_properties.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "io/gltf/models.h"

namespace scatter::io {
namespace {

constexpr float kMaxLength = 1e5F;
constexpr float kMinSize = 1e-6F;
constexpr float kMaxSpeed = 1e6F;

/// What is wrong; thrown within this file only.
struct Defect {
  std::string what;
};

void require(bool holds, const char* what) {
  if (!holds) {
    throw Defect{what};
  }
}

bool isWithin(float value, float low, float high) {
  return value >= low && value <= high;
}

bool isWithin(const Vec3& v, float largest) {
  return isWithin(v.x, -largest, largest) && isWithin(v.y, -largest, largest) &&
         isWithin(v.z, -largest, largest);
}

bool isMass(const std::optional<float>& mass) {
  return !mass || isWithin(*mass, static_cast<float>(kMinGltfMass), static_cast<float>(kMaxGltfMass));
}

bool isUtf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const std::size_t length = lead < 0x80                   ? 1
                               : lead >= 0xC2 && lead < 0xE0 ? 2
                               : lead >= 0xE0 && lead < 0xF0 ? 3
                               : lead >= 0xF0 && lead < 0xF5 ? 4
                                                             : 0;
    if (length == 0 || i + length > text.size()) {
      return false;
    }
    for (std::size_t j = 1; j < length; ++j) {
      const auto next = static_cast<unsigned char>(text[i + j]);
      // Overlong forms, surrogates and what lies beyond Unicode show in the second byte.
      const unsigned low = j != 1 ? 0x80 : lead == 0xE0 ? 0xA0 : lead == 0xF0 ? 0x90 : 0x80;
      const unsigned high = j != 1 ? 0xBF : lead == 0xED ? 0x9F : lead == 0xF4 ? 0x8F : 0xBF;
      if (next < low || next > high) {
        return false;
      }
    }
    i += length;
  }
  return true;
}

void checkName(const std::string& name) {
  require(isUtf8(name), "its name is not UTF-8");
}

void checkPose(const Transform& pose) {
  require(isWithin(pose.position, kMaxLength), "a position is not finite or too far from the origin");
  require(std::abs(glm::dot(pose.rotation, pose.rotation) - 1.0F) < 1e-5F, "a rotation is not of length 1");
}

void checkMesh(const VisualMesh& mesh) {
  require(std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                      [](const Vec3& v) { return isWithin(v, kMaxLength); }),
          "a vertex is not finite or too far from the origin");
  for (const auto& [a, b, c] : mesh.triangles) {
    require(std::max({a, b, c}) < mesh.vertices.size(), "a triangle names a vertex that does not exist");
  }
}

struct ConvexCheck {
  void operator()(const Box& box) const {
    const Vec3& h = box.halfExtents;
    require(isWithin(h, kMaxLength / 2.0F) && std::min({h.x, h.y, h.z}) >= kMinSize,
            "a box has no sound size");
  }
  void operator()(const Sphere& sphere) const {
    require(isWithin(sphere.radius, kMinSize, kMaxLength), "a sphere has no sound size");
  }
  void operator()(const Capsule& capsule) const { checkRound(capsule.radius, capsule.halfHeight); }
  void operator()(const Cylinder& cylinder) const { checkRound(cylinder.radius, cylinder.halfHeight); }
  void operator()(const ConvexHull& hull) const { checkMesh({hull.vertices, {}}); }

  static void checkRound(float radius, float halfHeight) {
    require(isWithin(radius, kMinSize, kMaxLength) && isWithin(halfHeight, kMinSize, kMaxLength / 2.0F),
            "a capsule or cylinder has no sound size");
  }
};

void checkGeometry(const DocumentShape& shape) {
  if (const auto* convex = std::get_if<ConvexShape>(&shape.geometry)) {
    std::visit(ConvexCheck{}, *convex);
    if (const auto solid = massProperties({{*convex, shape.pose}}); !solid) {
      throw Defect{solid.error().message};
    }
  } else if (const auto* plane = std::get_if<DocumentPlane>(&shape.geometry)) {
    require(std::abs(glm::length(plane->normal) - 1.0F) < 1e-4F &&
                isWithin(plane->offset, -kMaxLength, kMaxLength),
            "a plane's normal is not of length 1, or its offset is not finite");
  } else {
    const auto& mesh = std::get<VisualMesh>(shape.geometry);
    require(!mesh.triangles.empty(), "a mesh that bodies collide with has no triangles");
    checkMesh(mesh);
  }
}

void checkMaterialIndex(const std::optional<std::size_t>& material, const PhysicsDocument& document) {
  require(!material || *material < document.materials.size(), "it names a material that does not exist");
}

void checkModel(const DocumentModel& model, const PhysicsDocument& document) {
  checkName(model.name);
  require(!model.shapes.empty(), "it has no shapes");
  for (const DocumentShape& shape : model.shapes) {
    checkPose(shape.pose);
    checkGeometry(shape);
    checkMaterialIndex(shape.material, document);
    require(isMass(shape.mass) && isMass(shape.density),
            "the mass or density of a shape is not positive and finite");
  }
  checkMesh(model.mesh);
  require(!model.mesh.vertices.empty() || model.mesh.triangles.empty(), "its mesh has no vertices");
  require(isMass(model.mass) && isMass(static_cast<float>(documentMass(model))),
          "its mass is not positive and finite");
  checkMaterialIndex(model.material, document);
  if (model.massFrame) {
    checkPose(model.massFrame->pose);
    const Vec3 inertia = model.massFrame->inertia.value_or(Vec3(1.0F));
    require(isWithin(inertia, static_cast<float>(kMaxGltfInertia)) &&
                std::min({inertia.x, inertia.y, inertia.z}) >= static_cast<float>(kMinGltfInertia),
            "its inertia is not positive and finite");
  }
  if (model.levels) {
    require(isUtf8(model.levels->name()), "the name of its levels is not UTF-8");
    require(
        std::all_of(model.shapes.begin(), model.shapes.end(),
                    [](const DocumentShape& s) { return std::holds_alternative<ConvexShape>(s.geometry); }),
        "it has levels and a shape that is not convex");
  }
}

void checkBody(const DocumentBody& body, const PhysicsDocument& document) {
  checkName(body.name);
  require(body.model < document.models.size(), "it is of a model that does not exist");
  checkPose(body.pose);
  require(isWithin(body.linearVelocity, kMaxSpeed) && isWithin(body.angularVelocity, kMaxSpeed),
          "a velocity is not finite or too large");
  require(isMass(body.mass), "its mass is not positive and finite");
}

void checkJoint(const DocumentJoint& joint, const PhysicsDocument& document) {
  checkName(joint.name);
  for (const auto& body : {joint.bodyA, joint.bodyB}) {
    require(!body || *body < document.bodies.size(), "it joins a body that does not exist");
  }
  require(joint.bodyA != joint.bodyB, "it joins a body or the world to itself");
  checkPose(joint.frameA);
  checkPose(joint.frameB);
  for (const auto& axes : {joint.linear, joint.angular}) {
    for (const DocumentLimit& limit : axes) {
      require(!std::isnan(limit.lower) && !std::isnan(limit.upper), "a limit is not a number");
    }
  }
}

/// What reading a model will cost.
std::size_t costOf(const DocumentModel& model) {
  const auto ofMesh = [](const VisualMesh& mesh) {
    return 2 * mesh.vertices.size() + 4 * mesh.triangles.size();
  };
  std::size_t cost = ofMesh(model.mesh);
  for (const DocumentShape& shape : model.shapes) {
    const auto* convex = std::get_if<ConvexShape>(&shape.geometry);
    const auto* hull = convex != nullptr ? std::get_if<ConvexHull>(convex) : nullptr;
    const auto* mesh = std::get_if<VisualMesh>(&shape.geometry);
    // A hull of n corners has less than 2 n triangles.
    cost += 1 + (hull != nullptr ? 10 * hull->vertices.size() : mesh != nullptr ? ofMesh(*mesh) : 0);
  }
  if (model.levels) {
    std::vector<Level> levels;
    for (int i = 1; i <= model.levels->count(); ++i) {
      levels.push_back(model.levels->level(i));
    }
    cost += levelCost(levels);
  }
  return cost;
}

void checkCost(const PhysicsDocument& document) {
  std::size_t cost = 0;
  for (const DocumentModel& model : document.models) {
    cost += costOf(model);
  }
  require(cost <= GltfBudget::kMost, "it has too many vertices, triangles or parts to be read again");
}

void checkRest(const PhysicsDocument& document) {
  checkName(document.name);
  require(isWithin(document.gravity, kMaxSpeed), "gravity is not finite or too large");
  require(!document.timeStep || isWithin(*document.timeStep, 1e-6F, 1e3F),
          "the time step is not from 1e-6 to 1000 s");
}

void checkMaterial(const DocumentMaterial& material) {
  checkName(material.name);
  require(isWithin(material.staticFriction, 0.0F, 1e3F) && isWithin(material.dynamicFriction, 0.0F, 1e3F),
          "a friction is not from 0 to 1000");
  require(isWithin(material.restitution, 0.0F, 1.0F), "its restitution is not from 0 to 1");
}

void checkField(const DocumentField& field) {
  checkName(field.name);
  require(isWithin(field.center, kMaxLength) && isWithin(field.acceleration, -kMaxSpeed, kMaxSpeed) &&
              isWithin(field.radius, 0.0F, kMaxLength),
          "a value of it is not finite or too large");
}

/// Checks each entry, and puts its kind, number and name before what is wrong.
template <class List, class Check>
void checkEach(const char* kind, const List& list, const Check& check) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    try {
      check(list[i]);
    } catch (const Defect& defect) {
      throw Defect{std::string(kind) + " " + std::to_string(i) + " (\"" + list[i].name +
                   "\"): " + defect.what};
    }
  }
}

}  // namespace

std::optional<std::string> findShapeDefect(const DocumentShape& shape) {
  try {
    checkPose(shape.pose);
    checkGeometry(shape);
  } catch (const Defect& defect) {
    return defect.what;
  }
  return std::nullopt;
}

Result<void> checkDocument(const PhysicsDocument& document) {
  try {
    checkRest(document);
    checkEach("material", document.materials, checkMaterial);
    checkEach("model", document.models, [&](const DocumentModel& m) { checkModel(m, document); });
    std::set<std::string> names;
    checkEach("body", document.bodies, [&](const DocumentBody& body) {
      checkBody(body, document);
      require(names.insert(body.name).second, "another body has the same name");
    });
    checkEach("joint", document.joints, [&](const DocumentJoint& j) { checkJoint(j, document); });
    checkEach("field", document.fields, checkField);
    checkCost(document);
  } catch (const Defect& defect) {
    return fail(defect.what);
  }
  return {};
}

}  // namespace scatter::io
