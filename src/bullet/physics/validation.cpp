#include "bullet/physics/validation.h"

#include <array>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <optional>

#include "bullet/shapes/conversions.h"

namespace scatter {

namespace {

/// What is wrong, if anything.
using Problem = std::optional<std::string>;

Problem checkLength(const char* what, float value) {
  if (isFinite(value) && value > 0.0F) return std::nullopt;
  return std::string(what) + " must be a positive number of metres, not " + numberText(value);
}

// Convex parts are checked where their mass is found.
template <class Convex>
Problem findProblem(const Convex&) {
  return std::nullopt;
}

Problem findProblem(const Plane& plane) {
  if (!isFinite(plane.normal) || !isFinite(plane.offset)) return "the plane is not finite";
  if (!(glm::length(plane.normal) > 1e-6F)) return "the plane's normal must not be zero";
  return std::nullopt;
}

Problem checkPose(const Transform& pose) {
  if (!isFinite(pose)) return "the pose is not finite";
  const float length = glm::length(pose.rotation);
  if (std::abs(length - 1.0F) > 1e-3F) {
    return "the rotation must be a unit quaternion, not one of length " + numberText(length);
  }
  return std::nullopt;
}

Problem findProblem(const std::shared_ptr<const TriangleMesh>& mesh) {
  if (!mesh || mesh->triangles.empty()) return "the mesh has no triangles";
  for (std::size_t i = 0; i < mesh->vertices.size(); ++i) {
    if (!isFinite(mesh->vertices[i])) return "vertex " + std::to_string(i + 1) + " is not finite";
  }
  for (std::size_t i = 0; i < mesh->triangles.size(); ++i) {
    for (const std::uint32_t index : mesh->triangles[i]) {
      if (index >= mesh->vertices.size()) {
        return "triangle " + std::to_string(i + 1) + " has the vertex index " + std::to_string(index) +
               ", but there are only " + std::to_string(mesh->vertices.size()) + " vertices";
      }
    }
  }
  return std::nullopt;
}

Problem findProblem(const std::shared_ptr<const HeightField>& field) {
  if (!field || field->columns < 2 || field->rows < 2) {
    return "the height field must have at least 2 columns and 2 rows";
  }
  if (field->heights.size() != std::size_t{field->columns} * field->rows) {
    return "the height field has " + std::to_string(field->heights.size()) + " heights, but " +
           std::to_string(field->columns) + " columns and " + std::to_string(field->rows) + " rows";
  }
  for (const float spacing : {field->spacingX, field->spacingZ}) {
    if (auto problem = checkLength("the height field's spacing", spacing)) return problem;
  }
  for (std::size_t i = 0; i < field->heights.size(); ++i) {
    if (!isFinite(field->heights[i])) return "height " + std::to_string(i + 1) + " is not finite";
  }
  return std::nullopt;
}

// A LevelSet checks itself when it is made.
Problem findProblem(const std::shared_ptr<const LevelSet>& levels) {
  if (!levels) return "there is no level set";
  return std::nullopt;
}

struct Limited {
  const char* name;
  float value;
  float most;
};

Problem findProblem(const Material& material) {
  constexpr float kAny = std::numeric_limits<float>::max();
  const std::array<Limited, 6> values{{{"friction", material.friction, kAny},
                                       {"rolling friction", material.rollingFriction, kAny},
                                       {"spinning friction", material.spinningFriction, kAny},
                                       {"restitution", material.restitution, 1.0F},
                                       {"linear damping", material.linearDamping, 1.0F},
                                       {"angular damping", material.angularDamping, 1.0F}}};
  for (const Limited& value : values) {
    if (value.value >= 0.0F && value.value <= value.most) continue;
    const std::string range = value.most == kAny ? "zero or more" : "between 0 and 1";
    return std::string(value.name) + " must be " + range + ", not " + numberText(value.value);
  }
  return std::nullopt;
}

Problem checkMotion(const BodyDef& def) {
  if (def.motion != Motion::kStatic) {
    if (std::holds_alternative<Plane>(def.shape)) return "a plane can only be static";
    if (std::holds_alternative<std::shared_ptr<const TriangleMesh>>(def.shape)) {
      return "a triangle mesh can only be static; use convex parts for a body that moves";
    }
    if (std::holds_alternative<std::shared_ptr<const HeightField>>(def.shape)) {
      return "a height field can only be static; use convex parts for a body that moves";
    }
  }
  if (def.motion == Motion::kDynamic && !(isFinite(def.mass) && def.mass > 0.0F)) {
    return "mass must be a positive number of kilograms, not " + numberText(def.mass);
  }
  return std::nullopt;
}

Problem checkVelocity(const BodyDef& def) {
  if (!isFinite(def.linearVelocity)) return "the linear velocity is not finite";
  if (!isFinite(def.angularVelocity)) return "the angular velocity is not finite";
  if (!isFinite(def.gravityFactor)) return "the gravity factor is not finite";
  return std::nullopt;
}

Problem findProblem(const PointJoint&) {
  return std::nullopt;
}
Problem findProblem(const FixedJoint&) {
  return std::nullopt;
}

Problem checkLimits(float lower, float upper) {
  if (isFinite(lower) && isFinite(upper)) return std::nullopt;
  return "the limits are not finite; give a lower one above the upper one for no limits";
}

Problem findProblem(const HingeJoint& hinge) {
  if (auto problem = checkLimits(hinge.lower, hinge.upper)) return problem;
  constexpr auto kPi = glm::pi<float>();
  if (hinge.lower <= hinge.upper && (hinge.lower < -kPi || hinge.upper > kPi)) {
    return "hinge limits must lie between -pi and pi, not " + numberText(hinge.lower) + " and " +
           numberText(hinge.upper);
  }
  return std::nullopt;
}

Problem findProblem(const SliderJoint& slider) {
  return checkLimits(slider.lower, slider.upper);
}

Problem findProblem(const SixDofJoint& joint) {
  for (int axis = 0; axis < 3; ++axis) {
    if (auto problem = checkLimits(joint.linearLower[axis], joint.linearUpper[axis])) return problem;
    if (auto problem = checkLimits(joint.angularLower[axis], joint.angularUpper[axis])) return problem;
  }
  return std::nullopt;
}

Problem findProblem(const WheelDef& wheel) {
  if (auto problem = checkLength("radius", wheel.radius)) return problem;
  if (auto problem = checkLength("suspension rest length", wheel.suspensionRest)) return problem;
  if (!isFinite(wheel.connection)) return "the connection is not finite";
  if (!isFinite(wheel.direction) || !isFinite(wheel.axle)) return "the direction or axle is not finite";
  if (!(glm::length(glm::cross(wheel.direction, wheel.axle)) > 1e-6F)) {
    return "the direction and the axle must not be zero or parallel";
  }
  return std::nullopt;
}

}  // namespace

std::string numberText(float value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

Result<void> validateBody(const BodyDef& def) {
  Problem problem = checkMotion(def);
  if (!problem) problem = std::visit([](const auto& shape) { return findProblem(shape); }, def.shape);
  if (!problem) problem = checkPose(def.pose);
  if (!problem) problem = checkVelocity(def);
  if (!problem) problem = findProblem(def.material);
  if (problem) return fail("body \"" + def.name + "\": " + *problem);
  return {};
}

Result<void> validateJoint(const JointDef& def, const std::string& joint) {
  Problem problem = checkPose(def.frame);
  if (!problem) problem = std::visit([](const auto& kind) { return findProblem(kind); }, def.kind);
  if (problem) return fail(joint + ": " + *problem);
  return {};
}

Result<void> validateVehicle(const VehicleDef& def, const std::string& vehicle) {
  if (def.wheels.empty()) return fail(vehicle + ": a vehicle needs at least one wheel");
  for (std::size_t i = 0; i < def.wheels.size(); ++i) {
    if (const Problem problem = findProblem(def.wheels[i])) {
      return fail(vehicle + ": wheel " + std::to_string(i + 1) + ": " + *problem);
    }
  }
  if (!(isFinite(def.suspensionStiffness) && def.suspensionStiffness > 0.0F)) {
    return fail(vehicle + ": suspension stiffness must be positive, not " +
                numberText(def.suspensionStiffness));
  }
  if (!(isFinite(def.frictionSlip) && def.frictionSlip >= 0.0F)) {
    return fail(vehicle + ": friction slip must be zero or more, not " + numberText(def.frictionSlip));
  }
  return {};
}

}  // namespace scatter
