#include "scenes/document_joints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <string>

namespace scatter {
namespace {

constexpr float kAngleSlack = 1e-3F;  // radians
constexpr float kPlaceSlack = 1e-3F;  // metres

bool isFree(const DocumentLimit& limit) {
  return limit.lower > limit.upper;
}

bool isHeld(const DocumentLimit& limit) {
  return limit.lower == 0.0F && limit.upper == 0.0F;
}

using Limits = std::array<DocumentLimit, 3>;

std::ptrdiff_t countHeld(const Limits& limits) {
  return std::count_if(limits.begin(), limits.end(), isHeld);
}

/// The one axis that is not held.
std::size_t looseAxis(const Limits& limits) {
  return static_cast<std::size_t>(std::find_if_not(limits.begin(), limits.end(), isHeld) - limits.begin());
}

/// A rotation that takes the x, y and z axes to the next ones, `steps` times.
Quat cycleAxes(std::size_t steps) {
  Quat turn = kNoRotation;
  for (std::size_t i = 0; i < steps; ++i) turn = turn * Quat(0.5F, 0.5F, 0.5F, 0.5F);
  return turn;
}

/// Limits within what an angle of that axis can have.
DocumentLimit withinTurn(const DocumentLimit& limit, float most, const std::string& joint,
                         DocumentWarnings& warnings) {
  if (isFree(limit)) return limit;
  if (limit.lower < -most - kAngleSlack || limit.upper > most + kAngleSlack) {
    warnings.add(joint + ": limits of more than " + (most > 3.0F ? "180" : "90") +
                 " degrees are cut to that much");
  }
  return {std::clamp(limit.lower, -most, most), std::clamp(limit.upper, -most, most)};
}

JointKind sixDof(const DocumentJoint& joint, const std::string& name, DocumentWarnings& warnings) {
  constexpr auto kHalfTurn = glm::pi<float>();
  SixDofJoint result;
  for (int axis = 0; axis < 3; ++axis) {
    const auto index = static_cast<std::size_t>(axis);
    // Only the middle one of three angles is limited to a quarter turn.
    const float most = axis == 1 ? 0.5F * kHalfTurn : kHalfTurn;
    const DocumentLimit angle = withinTurn(joint.angular[index], most, name, warnings);
    result.linearLower[axis] = joint.linear[index].lower;
    result.linearUpper[axis] = joint.linear[index].upper;
    result.angularLower[axis] = angle.lower;
    result.angularUpper[axis] = angle.upper;
  }
  return result;
}

/// The simplest kind that the limits allow. A hinge or slider may need the frame turned to its own axis.
JointKind kindOf(const DocumentJoint& joint, const std::string& name, Quat& turn,
                 DocumentWarnings& warnings) {
  const auto linear = countHeld(joint.linear);
  const auto angular = countHeld(joint.angular);
  if (linear == 3 && angular == 3) return FixedJoint{};
  if (linear == 3 && std::all_of(joint.angular.begin(), joint.angular.end(), isFree)) return PointJoint{};
  if (linear == 3 && angular == 2) {
    const std::size_t axis = looseAxis(joint.angular);
    turn = cycleAxes((axis + 1) % 3);  // its axis is z
    const DocumentLimit limit = withinTurn(joint.angular[axis], glm::pi<float>(), name, warnings);
    return HingeJoint{limit.lower, limit.upper};
  }
  if (linear == 2 && angular == 3) {
    const std::size_t axis = looseAxis(joint.linear);
    turn = cycleAxes(axis);  // its axis is x
    return SliderJoint{joint.linear[axis].lower, joint.linear[axis].upper};
  }
  return sixDof(joint, name, warnings);
}

bool isDynamic(const PhysicsDocument& document, const std::optional<std::size_t>& index) {
  if (!index) return false;
  const DocumentBody& body = document.bodies[*index];
  return body.motion.value_or(document.models[body.model].motion) == DocumentMotion::kDynamic;
}

Transform inWorld(const PhysicsDocument& document, const std::optional<std::size_t>& body,
                  const Transform& frame) {
  return body ? document.bodies[*body].pose * frame : frame;
}

bool coincide(const Transform& a, const Transform& b) {
  const float turn = 1.0F - std::abs(glm::dot(a.rotation, b.rotation));
  return glm::length(a.position - b.position) < kPlaceSlack && turn < kAngleSlack;
}

}  // namespace

std::vector<DocumentJointDef> makeDocumentJoints(const PhysicsDocument& document,
                                                 DocumentWarnings& warnings) {
  std::vector<DocumentJointDef> joints;
  for (const DocumentJoint& joint : document.joints) {
    const std::string name = "joint \"" + joint.name + "\"";
    if (!joint.enabled) {
      warnings.add(name + ": it is not enabled, and is left out");
      continue;
    }
    if (joint.bodyA == joint.bodyB ||
        (!isDynamic(document, joint.bodyA) && !isDynamic(document, joint.bodyB))) {
      warnings.add(name + ": it ties no dynamic body to another one, and is left out");
      continue;
    }
    DocumentJointDef def;
    Quat turn = kNoRotation;
    def.kind = kindOf(joint, name, turn, warnings);
    def.bodyA = joint.bodyA;
    def.bodyB = joint.bodyB;
    def.frame = inWorld(document, joint.bodyA, joint.frameA);
    if (!coincide(def.frame, inWorld(document, joint.bodyB, joint.frameB))) {
      warnings.add(name + ": the bodies do not stand as its frames say; it holds them as they stand");
    }
    def.frame.rotation = def.frame.rotation * turn;
    def.bodiesCollide = joint.bodiesCollide;
    joints.push_back(def);
  }
  return joints;
}

}  // namespace scatter
