#include "io/collada/joint_writer.h"

#include <optional>
#include <string>

#include "io/collada/xml.h"
#include "io/numbers.h"

namespace scatter::io {
namespace {

/// A body is named by its node: several bodies can have the same `<rigid_body>`.
void writeAttachment(pugi::xml_node& constraint, const char* name, const std::optional<std::size_t>& body,
                     const Transform& frame) {
  pugi::xml_node node = append(constraint, name);
  if (body) {
    setAttribute(node, "rigid_body", link(makeId("node", *body)));
  }
  writePose(node, frame);
}

void writeLimits(pugi::xml_node& parent, const char* name, const std::array<DocumentLimit, 3>& limits,
                 std::string (*format)(float)) {
  std::string lower;
  std::string upper;
  for (const DocumentLimit& limit : limits) {
    const bool free = limit.lower > limit.upper;
    lower.append(lower.empty() ? "" : " ").append(free ? "-INF" : format(limit.lower));
    upper.append(upper.empty() ? "" : " ").append(free ? "INF" : format(limit.upper));
  }
  pugi::xml_node node = append(parent, name);
  appendText(node, "min", lower);
  appendText(node, "max", upper);
}

void writeConstraint(pugi::xml_node& model, const DocumentJoint& joint, std::size_t index) {
  pugi::xml_node constraint = append(model, "rigid_constraint");
  setAttribute(constraint, "sid", makeId("joint", index));
  setName(constraint, joint.name);
  writeAttachment(constraint, "ref_attachment", joint.bodyA, joint.frameA);
  writeAttachment(constraint, "attachment", joint.bodyB, joint.frameB);
  pugi::xml_node common = append(constraint, "technique_common");
  appendText(common, "enabled", joint.enabled ? "true" : "false");
  appendText(common, "interpenetrate", joint.bodiesCollide ? "false" : "true");
  pugi::xml_node limits = append(common, "limits");
  writeLimits(limits, "swing_cone_and_twist", joint.angular, formatDegrees);
  writeLimits(limits, "linear", joint.linear, [](float value) { return formatNumber(value); });
}

}  // namespace

void writeConstraints(pugi::xml_node& library, const PhysicsDocument& document) {
  if (document.joints.empty()) {
    return;
  }
  pugi::xml_node model = append(library, "physics_model");
  setAttribute(model, "id", kJointsId);
  for (std::size_t index = 0; index < document.joints.size(); ++index) {
    writeConstraint(model, document.joints[index], index);
  }
}

}  // namespace scatter::io
