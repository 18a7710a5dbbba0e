#include "io/collada/joints.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <pugixml.hpp>
#include <string_view>

#include "io/collada/transforms.h"

namespace scatter::io {
namespace {

/// Turns the numbers of a limit into those of a document.
struct LimitUnit {
  double factor = 1.0;  ///< To metres or radians.
  double most = 0.0;    ///< Metres or radians; what lies beyond is no limit.
  double end = 0.0;     ///< Taken for no limit, where the other side has one.
};

LimitUnit linearUnit(const ColladaFrame& frame) {
  return {frame.metersPerUnit(), ColladaFrame::kMaxLength, ColladaFrame::kMaxLength};
}

LimitUnit angularUnit() {
  return {kDegreesToRadians, 6.2832, glm::pi<double>()};
}

DocumentLimit makeLimit(double lower, double upper, const LimitUnit& unit) {
  const bool open = std::abs(lower) > unit.most;
  const bool openAbove = std::abs(upper) > unit.most;
  if ((open && openAbove) || lower > upper) {
    return {};
  }
  return {static_cast<float>(open ? -unit.end : lower), static_cast<float>(openAbove ? unit.end : upper)};
}

/// Zero where nothing is said.
Result<std::array<double, 3>> readBound(const ColladaFrame& frame, const pugi::xml_node& node,
                                        const LimitUnit& unit) {
  std::array<double, 3> bound{};
  if (!node) {
    return bound;
  }
  return frame.openNumbers(node, 3).map([&](const std::vector<double>& values) {
    for (std::size_t i = 0; i < 3; ++i) {
      bound[i] = values[i] * unit.factor;
    }
    return bound;
  });
}

Result<std::array<DocumentLimit, 3>> readLimits(const ColladaFrame& frame, const pugi::xml_node& node,
                                                const LimitUnit& unit) {
  const auto lower = readBound(frame, node.child("min"), unit);
  const auto upper = readBound(frame, node.child("max"), unit);
  if (!lower || !upper) {
    return tl::unexpected(lower ? upper.error() : lower.error());
  }
  std::array<DocumentLimit, 3> limits;
  for (std::size_t i = 0; i < 3; ++i) {
    limits[i] = makeLimit((*lower)[i], (*upper)[i], unit);
  }
  return limits;
}

Result<void> noteSprings(const ColladaFrame& frame, const pugi::xml_node& spring) {
  for (const pugi::xml_node& kind : {spring.child("linear"), spring.child("angular")}) {
    const auto stiffness = frame.scalar(kind.child("stiffness"), -1e30, 1e30);
    if (!stiffness) {
      return tl::unexpected(stiffness.error());
    }
    if (kind && stiffness->value_or(1.0F) != 0.0F) {
      frame.note(kind, "springs are not supported; the limits alone are taken");
    }
  }
  return {};
}

Result<void> readCommon(const ColladaFrame& frame, const pugi::xml_node& common, DocumentJoint& joint) {
  frame.noteUnknown(common, {"enabled", "interpenetrate", "limits", "spring"});
  const pugi::xml_node limits = common.child("limits");
  frame.noteUnknown(limits, {"linear", "swing_cone_and_twist"});
  const auto enabled = frame.flag(common.child("enabled"), true);
  const auto interpenetrate = frame.flag(common.child("interpenetrate"), false);
  if (!enabled || !interpenetrate) {
    return tl::unexpected(enabled ? interpenetrate.error() : enabled.error());
  }
  const auto linear = readLimits(frame, limits.child("linear"), linearUnit(frame));
  const auto angular = readLimits(frame, limits.child("swing_cone_and_twist"), angularUnit());
  if (!linear || !angular) {
    return tl::unexpected(linear ? angular.error() : linear.error());
  }
  joint.enabled = *enabled;
  joint.bodiesCollide = !*interpenetrate;
  joint.linear = *linear;
  joint.angular = *angular;
  return noteSprings(frame, common.child("spring"));
}

/// One end of a joint.
struct End {
  std::optional<std::size_t> body{};
  Transform frame{};
};

Result<std::optional<End>> readEnd(const ColladaFrame& frame, const pugi::xml_node& attachment,
                                   const FindAnchor& findAnchor) {
  frame.noteUnknown(attachment, {"translate", "rotate"});
  const auto anchor = findAnchor(attachment);
  const auto pose = readPose(frame, attachment);
  if (!anchor || !pose) {
    return tl::unexpected(anchor ? pose.error() : anchor.error());
  }
  if (!*anchor) {
    return std::nullopt;
  }
  End end{(*anchor)->body, frame.inYUp(*pose)};
  if (!end.body) {
    end.frame = composed((*anchor)->pose, end.frame);
    if (!(glm::length(end.frame.position) <= static_cast<float>(ColladaFrame::kMaxLength))) {
      return frame.xml().failAt(attachment, "is too far from the origin");
    }
  }
  return end;
}

}  // namespace

Result<std::optional<DocumentJoint>> readJoint(const ColladaFrame& frame, const pugi::xml_node& constraint,
                                               const FindAnchor& findAnchor) {
  DocumentJoint joint;
  const std::string_view name = constraint.attribute("name").value();
  joint.name = name.empty() ? constraint.attribute("sid").value() : name;
  frame.noteUnknown(constraint, {"ref_attachment", "attachment", "technique_common"});
  const auto a = readEnd(frame, constraint.child("ref_attachment"), findAnchor);
  const auto b = readEnd(frame, constraint.child("attachment"), findAnchor);
  if (!a || !b) {
    return tl::unexpected(a ? b.error() : a.error());
  }
  if (const auto common = readCommon(frame, constraint.child("technique_common"), joint); !common) {
    return tl::unexpected(common.error());
  }
  if (!*a || !*b) {
    return std::nullopt;
  }
  joint.bodyA = (*a)->body;
  joint.bodyB = (*b)->body;
  joint.frameA = (*a)->frame;
  joint.frameB = (*b)->frame;
  if (joint.bodyA == joint.bodyB) {
    frame.note(constraint, "joins a body or the world with itself and is left out");
    return std::nullopt;
  }
  return joint;
}

}  // namespace scatter::io
