#include "io/document_check.h"

#include <scatter/levels/mass_properties.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>
#include <string_view>

#include "io/numbers.h"
#include "io/utf8.h"

namespace scatter::io {
namespace {

constexpr float kMaxLength = 1e5F;
constexpr float kMaxTurn = 1e6F;  // radians per second
constexpr float kMinMass = 1e-9F;
constexpr float kMostMass = 1e12F;

/// What is wrong; thrown within this file only.
struct Defect {
  std::string what;
};

void require(bool holds, const char* what) {
  if (!holds) {
    throw Defect{what};
  }
}

/// False for what is not a number, too.
bool isWithin(float value, float low, float high) {
  return value >= low && value <= high;
}

bool isWithin(const Vec3& v, float largest) {
  return isWithin(v.x, -largest, largest) && isWithin(v.y, -largest, largest) &&
         isWithin(v.z, -largest, largest);
}

bool hasUnitLength(const Vec3& v) {
  return std::abs(glm::length(v) - 1.0F) < 1e-4F;
}

/// Checks the parts of a document; each function throws a Defect.
class Check {
 public:
  Check(const PhysicsDocument& document, const DocumentBounds& bounds)
      : document_(document), bounds_(bounds) {}

  void all() const;
  void shape(const DocumentShape& shape) const;

  // The kinds of geometry.
  void operator()(const ConvexShape& convex) const { std::visit(*this, convex); }
  void operator()(const Box& box) const;
  void operator()(const Sphere& sphere) const;
  void operator()(const Capsule& capsule) const { round(capsule.radius, capsule.halfHeight); }
  void operator()(const Cylinder& cylinder) const { round(cylinder.radius, cylinder.halfHeight); }
  void operator()(const ConvexHull& hull) const { mesh({hull.vertices, {}}); }
  void operator()(const DocumentPlane& plane) const;
  void operator()(const VisualMesh& triangles) const;

 private:
  /// Checks each entry, and puts its kind, number and name before what is wrong.
  template <class Entry>
  void each(const char* kind, const std::vector<Entry>& list, void (Check::*one)(const Entry&) const) const;

  void world() const;
  void material(const DocumentMaterial& material) const;
  void model(const DocumentModel& model) const;
  void levels(const DocumentModel& model) const;
  void massFrame(const DocumentMassFrame& massFrame) const;
  void body(const DocumentBody& body) const;
  void names() const;
  void joint(const DocumentJoint& joint) const;
  void field(const DocumentField& field) const;

  void name(const std::string& name) const;
  void pose(const Transform& pose) const;
  void mesh(const VisualMesh& mesh) const;
  void round(float radius, float halfHeight) const;
  void mass(const std::optional<float>& mass) const;
  void materialIndex(const std::optional<std::size_t>& material) const;

  const PhysicsDocument& document_;
  const DocumentBounds& bounds_;
};

template <class Entry>
void Check::each(const char* kind, const std::vector<Entry>& list,
                 void (Check::*one)(const Entry&) const) const {
  for (std::size_t i = 0; i < list.size(); ++i) {
    try {
      name(list[i].name);
      (this->*one)(list[i]);
    } catch (const Defect& defect) {
      throw Defect{std::string(kind) + " " + std::to_string(i) + " (\"" + list[i].name +
                   "\"): " + defect.what};
    }
  }
}

void Check::all() const {
  world();
  each("material", document_.materials, &Check::material);
  each("model", document_.models, &Check::model);
  each("body", document_.bodies, &Check::body);
  names();
  each("joint", document_.joints, &Check::joint);
  each("field", document_.fields, &Check::field);
}

void Check::world() const {
  name(document_.name);
  require(!bounds_.needsModel || !document_.models.empty(), "it has no model");
  require(isWithin(document_.gravity, bounds_.maxGravity), "gravity is not finite or too large");
  if (document_.timeStep && !isWithin(*document_.timeStep, bounds_.minTimeStep, 1e3F)) {
    throw Defect{"the time step is not from " + formatNumber(bounds_.minTimeStep) + " to 1000 s"};
  }
}

void Check::name(const std::string& name) const {
  require(!bounds_.keepsNames || isUtf8(name), "its name is not UTF-8");
}

void Check::pose(const Transform& pose) const {
  require(isWithin(pose.position, kMaxLength) && glm::length(pose.position) <= bounds_.maxDistance,
          "a position is not finite or too far from the origin");
  require(std::abs(glm::dot(pose.rotation, pose.rotation) - 1.0F) < 1e-5F, "a rotation is not of length 1");
}

void Check::mesh(const VisualMesh& mesh) const {
  require(std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                      [](const Vec3& v) { return isWithin(v, kMaxLength); }),
          "a vertex is not finite or too far from the origin");
  for (const auto& [a, b, c] : mesh.triangles) {
    require(std::max({a, b, c}) < mesh.vertices.size(), "a triangle names a vertex that does not exist");
  }
}

void Check::operator()(const Box& box) const {
  const Vec3& h = box.halfExtents;
  require(isWithin(h, bounds_.maxHalfExtent) && std::min({h.x, h.y, h.z}) >= bounds_.minSize,
          "a box has no sound size");
}

void Check::operator()(const Sphere& sphere) const {
  require(isWithin(sphere.radius, bounds_.minSize, kMaxLength), "a sphere has no sound size");
}

void Check::round(float radius, float halfHeight) const {
  require(isWithin(radius, bounds_.minSize, kMaxLength) &&
              isWithin(2.0F * halfHeight, bounds_.minSize, kMaxLength),
          "a capsule or cylinder has no sound size");
}

void Check::operator()(const DocumentPlane& plane) const {
  require(hasUnitLength(plane.normal) && isWithin(plane.offset, -kMaxLength, kMaxLength),
          "a plane's normal is not of length 1, or its offset is not finite");
}

void Check::operator()(const VisualMesh& triangles) const {
  require(!triangles.triangles.empty(), "a mesh that bodies collide with has no triangles");
  mesh(triangles);
}

void Check::shape(const DocumentShape& shape) const {
  pose(shape.pose);
  std::visit(*this, shape.geometry);
  const auto* convex = std::get_if<ConvexShape>(&shape.geometry);
  if (bounds_.needsVolume && convex != nullptr) {
    if (const auto solid = massProperties({{*convex, shape.pose}}); !solid) {
      throw Defect{solid.error().message};
    }
  }
}

void Check::materialIndex(const std::optional<std::size_t>& material) const {
  require(!material || *material < document_.materials.size(), "it names a material that does not exist");
}

void Check::mass(const std::optional<float>& mass) const {
  if (mass && !isWithin(*mass, kMinMass, kMostMass)) {
    throw Defect{"its mass of " + formatNumber(*mass) + " kg is not positive and finite"};
  }
}

void Check::material(const DocumentMaterial& material) const {
  require(isWithin(material.staticFriction, 0.0F, 1e3F) && isWithin(material.dynamicFriction, 0.0F, 1e3F),
          "a friction is not from 0 to 1000");
  require(isWithin(material.restitution, 0.0F, 1.0F), "its restitution is not from 0 to 1");
}

void Check::model(const DocumentModel& model) const {
  require(!model.shapes.empty(), "it has no shapes");
  for (const DocumentShape& one : model.shapes) {
    shape(one);
    materialIndex(one.material);
    for (const auto& weight : {one.mass, one.density}) {
      require(!weight || isWithin(*weight, bounds_.minShapeWeight, bounds_.maxShapeWeight),
              "the mass or density of a shape is not positive and finite");
    }
  }
  mesh(model.mesh);
  mass(model.mass);
  materialIndex(model.material);
  if (model.massFrame) {
    massFrame(*model.massFrame);
  }
  if (model.levels) {
    levels(model);
  }
}

void Check::massFrame(const DocumentMassFrame& massFrame) const {
  pose(massFrame.pose);
  const Vec3 inertia = massFrame.inertia.value_or(Vec3(1.0F));
  require(isWithin(inertia, bounds_.maxInertia) &&
              std::min({inertia.x, inertia.y, inertia.z}) >= bounds_.minInertia,
          "its inertia is not positive and finite");
}

void Check::levels(const DocumentModel& model) const {
  require(!bounds_.keepsNames || isUtf8(model.levels->name()), "the name of its levels is not UTF-8");
  require(std::all_of(model.shapes.begin(), model.shapes.end(),
                      [](const DocumentShape& s) { return std::holds_alternative<ConvexShape>(s.geometry); }),
          "it has levels and a shape that is not convex");
  require(!bounds_.finestIsShapes || model.levels->finest().parts.size() == model.shapes.size(),
          "its shapes are not those of its finest level");
}

void Check::body(const DocumentBody& body) const {
  require(body.model < document_.models.size(), "it is of a model that does not exist");
  pose(body.pose);
  require(isWithin(body.linearVelocity, bounds_.maxSpeed) && isWithin(body.angularVelocity, kMaxTurn),
          "a velocity is not finite or too large");
  mass(body.mass);
  require(std::isfinite(body.gravityFactor), "its gravity factor is not finite");
  require(!body.filter || *body.filter < document_.filters.size(),
          "it has a collision filter that does not exist");
}

void Check::names() const {
  std::set<std::string_view> names;
  for (const DocumentBody& body : document_.bodies) {
    if (bounds_.keepsNames && !names.insert(body.name).second) {
      throw Defect{"body \"" + body.name + "\": another body has the same name"};
    }
  }
}

void Check::joint(const DocumentJoint& joint) const {
  for (const auto& body : {joint.bodyA, joint.bodyB}) {
    require(!body || *body < document_.bodies.size(), "it joins a body that does not exist");
  }
  require(joint.bodyA != joint.bodyB, "it joins a body or the world to itself");
  pose(joint.frameA);
  pose(joint.frameB);
  const auto limits = [](const std::array<DocumentLimit, 3>& axes, float most) {
    for (const DocumentLimit& limit : axes) {
      const bool free = limit.lower > limit.upper;
      if (!free && !(isWithin(limit.lower, -most, most) && isWithin(limit.upper, -most, most))) {
        throw Defect{"a limit is not from " + formatNumber(-most) + " to " + formatNumber(most)};
      }
    }
  };
  limits(joint.linear, bounds_.maxLinearLimit);
  limits(joint.angular, bounds_.maxAngularLimit);
}

void Check::field(const DocumentField& field) const {
  require(isWithin(field.center, kMaxLength) &&
              isWithin(field.acceleration, -bounds_.maxFieldAcceleration, bounds_.maxFieldAcceleration) &&
              isWithin(field.radius, 0.0F, bounds_.maxFieldRadius),
          "a value of it is not finite or too large");
}

}  // namespace

std::optional<std::string> findShapeDefect(const DocumentShape& shape, const DocumentBounds& bounds) {
  try {
    Check(PhysicsDocument{}, bounds).shape(shape);
  } catch (const Defect& defect) {
    return defect.what;
  }
  return std::nullopt;
}

Result<void> checkDocument(const PhysicsDocument& document, const DocumentBounds& bounds) {
  try {
    Check(document, bounds).all();
  } catch (const Defect& defect) {
    return fail(defect.what);
  }
  return {};
}

}  // namespace scatter::io
