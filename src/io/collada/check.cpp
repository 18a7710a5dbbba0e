#include "io/collada/check.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "io/collada/frame.h"
#include "io/numbers.h"

namespace scatter::io {
namespace {

constexpr auto kFar = static_cast<float>(ColladaFrame::kMaxLength);
constexpr auto kLeastLength = static_cast<float>(ColladaFrame::kMinLength);

bool isInRange(float value, float low, float high) {
  return value >= low && value <= high;
}

bool isWithin(const Vec3& v, float most) {
  return std::abs(v.x) <= most && std::abs(v.y) <= most && std::abs(v.z) <= most;
}

bool isFinite(const Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool isSound(const Transform& pose) {
  return glm::length(pose.position) <= kFar && std::abs(glm::length(pose.rotation) - 1.0F) < 1e-3F;
}

bool isSize(float length) {
  return length >= kLeastLength && length <= kFar;
}

std::string cannotWrite(const char* kind, const std::string& name) {
  return std::string(kind) + " " + inQuotes(name) + " cannot be written: ";
}

Result<void> checkMesh(const std::string& who, const VisualMesh& mesh) {
  if (!std::all_of(mesh.vertices.begin(), mesh.vertices.end(), isFinite)) {
    return fail(who + "its mesh has a vertex that is not finite");
  }
  if (!std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                   [](const Vec3& v) { return isWithin(v, kFar); })) {
    return fail(who + "its mesh has a vertex that is more than " + formatNumber(kFar) + " m away");
  }
  for (const auto& triangle : mesh.triangles) {
    if (std::any_of(triangle.begin(), triangle.end(),
                    [&](std::uint32_t corner) { return corner >= mesh.vertices.size(); })) {
      return fail(who + "a triangle of its mesh names a vertex that does not exist");
    }
  }
  return {};
}

/// Whether the numbers of a shape can be written and read.
struct ShapeCheck {
  bool operator()(const Box& box) const {
    return isSize(box.halfExtents.x) && isSize(box.halfExtents.y) && isSize(box.halfExtents.z);
  }
  bool operator()(const Sphere& sphere) const { return isSize(sphere.radius); }
  bool operator()(const Capsule& capsule) const {
    return isSize(capsule.radius) && isSize(2.0F * capsule.halfHeight);
  }
  bool operator()(const Cylinder& cylinder) const {
    return isSize(cylinder.radius) && isSize(2.0F * cylinder.halfHeight);
  }
  bool operator()(const ConvexHull& hull) const {
    return std::all_of(hull.vertices.begin(), hull.vertices.end(),
                       [](const Vec3& v) { return isWithin(v, kFar); });
  }
  bool operator()(const ConvexShape& convex) const { return std::visit(*this, convex); }
  bool operator()(const DocumentPlane& plane) const {
    return std::abs(glm::length(plane.normal) - 1.0F) < 1e-3F && std::abs(plane.offset) <= kFar;
  }
  bool operator()(const VisualMesh& mesh) const {
    return !mesh.triangles.empty() && std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                                                  [](const Vec3& v) { return isWithin(v, kFar); });
  }
};

Result<void> checkMaterialIndex(const std::string& who, const std::optional<std::size_t>& material,
                                const PhysicsDocument& document) {
  if (material && *material >= document.materials.size()) {
    return fail(who + "it has a material that does not exist");
  }
  return {};
}

Result<void> checkShape(const std::string& who, const DocumentShape& shape, const PhysicsDocument& document) {
  if (!isWritable(shape)) {
    return fail(who + "a shape has a size or place that is not finite or out of range");
  }
  if (!isInRange(shape.mass.value_or(1.0F), 1e-12F, 1e18F) ||
      !isInRange(shape.density.value_or(1.0F), 1e-12F, 1e18F)) {
    return fail(who + "a shape has a mass or density that is not positive and finite");
  }
  if (const auto* mesh = std::get_if<VisualMesh>(&shape.geometry)) {
    if (auto checked = checkMesh(who, *mesh); !checked) {
      return checked;
    }
  }
  return checkMaterialIndex(who, shape.material, document);
}

Result<void> checkMass(const std::string& who, const std::optional<float>& mass) {
  if (!isInRange(mass.value_or(1.0F), 1e-9F, 1e12F)) {
    return fail(who + "its mass of " + formatNumber(*mass) + " kg is not positive and finite");
  }
  return {};
}

Result<void> checkMassFrame(const std::string& who, const std::optional<DocumentMassFrame>& massFrame) {
  if (!massFrame) {
    return {};
  }
  const Vec3 inertia = massFrame->inertia.value_or(Vec3(1.0F));
  const auto isMoment = [](float moment) { return isInRange(moment, 1e-18F, 1e18F); };
  if (!isSound(massFrame->pose) || !isMoment(inertia.x) || !isMoment(inertia.y) || !isMoment(inertia.z)) {
    return fail(who + "its mass frame has a number that is not finite or a moment that is not positive");
  }
  return {};
}

Result<void> checkModel(const DocumentModel& model, const PhysicsDocument& document) {
  const std::string who = cannotWrite("model", model.name);
  if (model.shapes.empty()) {
    return fail(who + "it has no shapes");
  }
  if (model.levels && model.levels->finest().parts.size() != model.shapes.size()) {
    return fail(who + "its shapes are not those of its finest level");
  }
  for (const DocumentShape& shape : model.shapes) {
    if (auto checked = checkShape(who, shape, document); !checked) {
      return checked;
    }
    if (model.levels && !std::holds_alternative<ConvexShape>(shape.geometry)) {
      return fail(who + "its shapes are not those of its finest level");
    }
  }
  return checkMass(who, model.mass)
      .and_then([&] { return checkMassFrame(who, model.massFrame); })
      .and_then([&] { return checkMesh(who, model.mesh); })
      .and_then([&] { return checkMaterialIndex(who, model.material, document); });
}

Result<void> checkMaterial(const DocumentMaterial& material) {
  if (!isInRange(material.dynamicFriction, 0.0F, 1e3F) || !isInRange(material.staticFriction, 0.0F, 1e3F) ||
      !isInRange(material.restitution, 0.0F, 1.0F)) {
    return fail(cannotWrite("material", material.name) +
                "friction is not from 0 to 1000 or restitution not from 0 to 1");
  }
  return {};
}

Result<void> checkBody(const DocumentBody& body, const PhysicsDocument& document) {
  const std::string who = cannotWrite("body", body.name);
  if (body.model >= document.models.size()) {
    return fail(who + "it has a model that does not exist");
  }
  if (!isSound(body.pose) || !isWithin(body.linearVelocity, kFar) ||
      !(glm::length(body.angularVelocity) < 1e6F)) {
    return fail(who + "its pose or velocity is not finite or out of range");
  }
  return checkMass(who, body.mass);
}

Result<void> checkLimits(const std::string& who, const std::array<DocumentLimit, 3>& limits, float most) {
  for (const DocumentLimit& limit : limits) {
    const bool free = limit.lower > limit.upper;
    if (!free && !(isInRange(limit.lower, -most, most) && isInRange(limit.upper, -most, most))) {
      return fail(who + "a limit is not from " + formatNumber(-most) + " to " + formatNumber(most));
    }
  }
  return {};
}

Result<void> checkJoint(const DocumentJoint& joint, const PhysicsDocument& document) {
  const std::string who = cannotWrite("joint", joint.name);
  const auto isBody = [&](const std::optional<std::size_t>& body) {
    return !body || *body < document.bodies.size();
  };
  if (!isBody(joint.bodyA) || !isBody(joint.bodyB)) {
    return fail(who + "it joins a body that does not exist");
  }
  if (joint.bodyA == joint.bodyB) {
    return fail(who + "it joins a body or the world with itself");
  }
  if (!isSound(joint.frameA) || !isSound(joint.frameB)) {
    return fail(who + "a frame is not finite or out of range");
  }
  return checkLimits(who, joint.linear, kFar).and_then([&] {
    return checkLimits(who, joint.angular, 6.28319F);
  });
}

Result<void> checkField(const DocumentField& field) {
  if (!isWithin(field.center, kFar) || !isInRange(field.acceleration, -1e12F, 1e12F) ||
      !isInRange(field.radius, 0.0F, 1e12F)) {
    return fail(cannotWrite("field", field.name) + "it has a number that is not finite or out of range");
  }
  return {};
}

template <class Items, class Check>
Result<void> checkAll(const Items& items, const Check& check) {
  for (const auto& item : items) {
    if (auto checked = check(item); !checked) {
      return checked;
    }
  }
  return {};
}

}  // namespace

bool isWritable(const DocumentShape& shape) {
  return std::visit(ShapeCheck{}, shape.geometry) && isSound(shape.pose);
}

Result<void> checkWritable(const PhysicsDocument& document) {
  const std::string who = cannotWrite("document", document.name);
  if (document.models.empty()) {
    return fail(who + "it has no model");
  }
  if (!isWithin(document.gravity, 1e9F) || !isInRange(document.timeStep.value_or(1.0F), 1e-9F, 1e3F)) {
    return fail(who + "its gravity is not finite or its time step is not from 1e-9 to 1000 s");
  }
  return checkAll(document.materials, checkMaterial)
      .and_then([&] {
        return checkAll(document.models, [&](const auto& model) { return checkModel(model, document); });
      })
      .and_then([&] {
        return checkAll(document.bodies, [&](const auto& body) { return checkBody(body, document); });
      })
      .and_then([&] {
        return checkAll(document.joints, [&](const auto& joint) { return checkJoint(joint, document); });
      })
      .and_then([&] { return checkAll(document.fields, checkField); });
}

}  // namespace scatter::io
