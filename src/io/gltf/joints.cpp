#include "io/gltf/joints.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <string>

namespace scatter::io {
namespace {

/// What lies beyond is no limit: metres and radians.
constexpr double kFarthest = kMaxGltfLength;
constexpr double kWidest = 2.0 * glm::pi<double>() + 1e-5;

/// A bound, or nothing if there is none on that side.
std::optional<double> readBound(const JsonPlace& limit, const char* key, double most) {
  const auto place = limit.find(key);
  const double value = place ? place->number() : most + 1.0;
  return std::abs(value) <= most ? std::optional(value) : std::nullopt;
}

/// Narrows the axes that a limit names.
void applyLimit(GltfFile& file, const JsonPlace& limit, DocumentJoint& joint) {
  const auto linear = limit.find("linearAxes");
  const auto angular = limit.find("angularAxes");
  file.warnUnknown(limit, {"linearAxes", "angularAxes", "min", "max", "stiffness", "damping"});
  if (linear.has_value() == angular.has_value()) {
    limit.fail(R"(should have either "linearAxes" or "angularAxes")");
  }
  const JsonPlace& axes = linear ? *linear : *angular;
  const auto below = readBound(limit, "min", linear ? kFarthest : kWidest);
  const auto above = readBound(limit, "max", linear ? kFarthest : kWidest);
  // An angle is within half a turn.
  const double open = linear ? kFarthest : glm::pi<double>();
  double lower = below.value_or(std::min(-open, above.value_or(0.0)));
  const double upper = above.value_or(std::max(open, lower));
  if (lower > upper) {
    limit.fail(R"("min" is larger than "max")");
  }
  if (axes.size() > 1 && (lower != 0.0 || upper != 0.0)) {
    // The draft limits the distance over several axes together.
    file.warn(limit, "a limit over several axes at once is read as one of each axis");
    lower = std::min(lower, -upper);
  }
  for (const char* soft : {"stiffness", "damping"}) {
    if (limit.find(soft)) {
      file.warn(limit.at(soft), "soft limits are not supported; it is read as a hard one");
    }
  }
  for (std::size_t i = 0; i < axes.size(); ++i) {
    DocumentLimit& target = (linear ? joint.linear : joint.angular)[axes[i].index(3, "axis")];
    if (below || above) {
      target = {static_cast<float>(lower), static_cast<float>(upper)};
    }
  }
}

void readLimits(GltfFile& file, const JsonPlace& description, DocumentJoint& joint) {
  file.warnUnknown(description, {"limits", "drives"});
  if (const auto limits = description.find("limits")) {
    for (std::size_t i = 0; i < limits->size(); ++i) {
      applyLimit(file, (*limits)[i], joint);
    }
  }
  if (const auto drives = description.find("drives"); drives && drives->size() > 0) {
    file.warn(*drives, "drives are not supported; the joint is read without them");
  }
}

struct JointPlace {
  JsonPlace place;
  bool enabled = true;
};

std::optional<JointPlace> findJoint(const GltfNodes& nodes, const GltfBodies& bodies, std::size_t node) {
  if (const auto physics = bodies.extension(node)) {
    if (const auto joint = physics->find("joint")) {
      return JointPlace{*joint, true};
    }
  }
  const auto extras = nodes.json(node).find("extras");
  const auto disabled = extras && extras->isObject() ? extras->find("scatter_disabled_joint") : std::nullopt;
  return disabled ? std::optional(JointPlace{*disabled, false}) : std::nullopt;
}

/// The body a node belongs to; the world if it has none. False if it has one that is not in the document.
bool findBody(const GltfOwner& owner, const std::vector<std::optional<std::size_t>>& bodyOfNode,
              std::optional<std::size_t>& body) {
  body = owner.root ? bodyOfNode[*owner.root] : std::nullopt;
  return !owner.root || body;
}

}  // namespace

std::vector<DocumentJoint> readJoints(GltfFile& file, const GltfNodes& nodes, const GltfBodies& bodies,
                                      const std::vector<std::optional<std::size_t>>& bodyOfNode) {
  std::vector<DocumentJoint> joints;
  const auto descriptions = file.root().find({"extensions", kRigidBodies, "physicsJoints"});
  std::vector<bool> isUsed(descriptions ? descriptions->size() : 0, false);
  for (std::size_t i = 0; i < nodes.count(); ++i) {
    const auto found = nodes[i].inScene ? findJoint(nodes, bodies, i) : std::nullopt;
    if (!found) {
      continue;
    }
    const JsonPlace& place = found->place;
    const std::size_t other = place.at("connectedNode").index(nodes.count(), "node");
    const std::size_t description = place.at("joint").index(isUsed.size(), "joint");
    isUsed[description] = true;
    DocumentJoint joint;
    const bool complete = findBody(bodies.owner(i), bodyOfNode, joint.bodyA) &&
                          findBody(bodies.owner(other), bodyOfNode, joint.bodyB);
    if (!complete || joint.bodyA == joint.bodyB) {
      file.warn(place, complete ? "joins a body or the world to itself; it is left out"
                                : "joins a body that was left out; it is left out too");
      continue;
    }
    const auto name = nodes.json(i).find("name");
    joint.name = name ? name->text() : "joint " + std::to_string(i);
    joint.frameA = bodies.owner(i).placement.rigid();
    joint.frameB = bodies.owner(other).placement.rigid();
    joint.enabled = found->enabled;
    const auto collide = place.find("enableCollision");
    joint.bodiesCollide = collide && collide->boolean();
    file.warnUnknown(place, {"connectedNode", "joint", "enableCollision"});
    readLimits(file, (*descriptions)[description], joint);
    joints.push_back(joint);
  }
  for (std::size_t i = 0; i < isUsed.size(); ++i) {
    if (!isUsed[i]) {
      file.warn((*descriptions)[i], "no node uses it; it is left out");
    }
  }
  return joints;
}

}  // namespace scatter::io
