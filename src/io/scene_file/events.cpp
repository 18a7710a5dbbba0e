#include "io/scene_file/events.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "io/collada/xml_source.h"

namespace scatter::io {
namespace {

constexpr std::size_t kMostEvents = 10000;
constexpr std::size_t kMostTargets = 1000000;  // of all events together
constexpr double kFramesPerSecond = 60.0;

/// The shortest turn that takes `from` to `to`, both unit vectors.
Quat turnTo(const Vec3& from, const Vec3& to) {
  const float cosine = glm::dot(from, to);
  if (cosine < -0.9999F) {
    const Vec3 other = std::abs(from.x) < 0.5F ? Vec3(1.0F, 0.0F, 0.0F) : Vec3(0.0F, 1.0F, 0.0F);
    return glm::angleAxis(glm::pi<float>(), glm::normalize(glm::cross(from, other)));
  }
  const Vec3 normal = glm::cross(from, to);
  return glm::normalize(Quat(1.0F + cosine, normal.x, normal.y, normal.z));
}

void readLimits(const SceneTable& table, SceneFileJoint& joint) {
  const bool lower = table.has("lower");
  if (lower != table.has("upper")) {
    table.report(lower ? "lower" : "upper", R"("lower" and "upper" in [[joint]] go together)");
  }
  if (!lower) return;
  table.read("lower", joint.lower);
  table.read("upper", joint.upper);
  if (joint.lower > joint.upper) table.report("lower", R"("lower" in [[joint]] must not be above "upper")");
  if (joint.kind != SceneFileJoint::Kind::kHinge) return;
  if (joint.lower < -180.0F || joint.upper > 180.0F) {
    table.report("lower", "the limits of a hinge must be from -180 to 180 degrees");
  }
  const auto half = glm::pi<float>();
  joint.lower = std::clamp(glm::radians(joint.lower), -half, half);
  joint.upper = std::clamp(glm::radians(joint.upper), -half, half);
}

void readSixDof(const SceneTable& table, SceneFileJoint& joint) {
  table.read("linear_lower", joint.linearLower);
  table.read("linear_upper", joint.linearUpper);
  table.read("angular_lower", joint.angularLower);
  table.read("angular_upper", joint.angularUpper);
  joint.angularLower = glm::radians(joint.angularLower);
  joint.angularUpper = glm::radians(joint.angularUpper);
}

/// The object that a body belongs to.
const SceneFileObject& objectOf(const SceneFile& scene, std::size_t body) {
  const auto after = std::upper_bound(
      scene.objects.begin(), scene.objects.end(), body,
      [](std::size_t index, const SceneFileObject& object) { return index < object.firstBody; });
  return *std::prev(after);
}

void readJointBodies(const SceneTable& table, const SceneFile& scene, const SceneNames& names,
                     SceneFileJoint& joint) {
  if (table.require("a")) joint.bodyA = names.body(table, "a").value_or(0);
  if (table.has("b")) joint.bodyB = names.body(table, "b");
  if (table.problem().any()) return;
  if (joint.bodyB == joint.bodyA) table.report("b", "a joint needs two different bodies");
  const auto isDynamic = [&scene](std::size_t body) {
    return objectOf(scene, body).motion == SceneFileMotion::kDynamic;
  };
  if (!isDynamic(joint.bodyA) && !(joint.bodyB && isDynamic(*joint.bodyB))) {
    table.report("a", "one of the bodies of a joint must be dynamic");
  }
}

void readJoint(const SceneTable& table, SceneFile& scene, const SceneNames& names) {
  using Kind = SceneFileJoint::Kind;
  static const std::vector<std::string_view> kKinds{"point", "hinge", "slider", "fixed", "six_dof"};
  SceneFileJoint joint;
  joint.line = table.line();
  const auto kind = table.needKind("kind", kKinds);
  if (!kind) return;
  joint.kind = static_cast<Kind>(*kind);
  readJointBodies(table, scene, names, joint);
  table.read("at", joint.frame.position);
  if (joint.kind == Kind::kHinge || joint.kind == Kind::kSlider) {
    Vec3 axis(0.0F, 1.0F, 0.0F);
    table.needDirection("axis", axis);
    const Vec3 own = joint.kind == Kind::kHinge ? Vec3(0.0F, 0.0F, 1.0F) : Vec3(1.0F, 0.0F, 0.0F);
    joint.frame.rotation = turnTo(own, axis);
    readLimits(table, joint);
  }
  if (joint.kind == Kind::kSixDof) readSixDof(table, joint);
  table.read("collide", joint.bodiesCollide);
  scene.joints.push_back(joint);
}

SceneFileThrow readThrow(const SceneTable& table, const SceneNames& names) {
  SceneFileThrow result;
  table.read("spin", result.spin);
  Vec3 vector(0.0F);
  if (table.oneOf({"velocity", "toward"}, true) == "velocity") {
    table.read("velocity", vector);
    if (table.has("speed")) table.report("speed", R"("speed" of a throw goes with "toward")");
    result.target = vector;
    return result;
  }
  result.speed = 0.0F;
  table.need("speed", *result.speed);
  if (table.is<std::string>("toward")) {
    result.target = names.body(table, "toward").value_or(0);
  } else {
    table.read("toward", vector);
    result.target = vector;
  }
  return result;
}

SceneFileKnock readKnock(const SceneTable& table) {
  SceneFileKnock knock;
  table.needDirection("direction", knock.direction);
  table.checkOneOf({"impulse", "speed"}, true);
  table.read("impulse", knock.impulse);
  table.read("speed", knock.speed);
  table.read("body_frame", knock.inBodyFrame);
  return knock;
}

SceneFileBreak readBreak(const SceneTable& table) {
  SceneFileBreak result;
  table.read("burst", result.burst);
  table.read("shrink", result.shrink);
  return result;
}

SceneFileSwitch readSwitch(const SceneTable& table, const SceneNames& names) {
  SceneFileSwitch result;
  if (table.require("field")) result.field = names.find(table, "field", "field").value_or(0);
  table.need("on", result.on);
  return result;
}

std::uint64_t readFrame(const SceneTable& table) {
  std::uint64_t frame = 0;
  if (table.oneOf({"frame", "seconds"}, true) == "frame") {
    table.readWhole("frame", frame);
    return frame;
  }
  float seconds = 0.0F;
  table.read("seconds", seconds);
  return static_cast<std::uint64_t>(std::llround(static_cast<double>(seconds) * kFramesPerSecond));
}

void checkBreaks(const SceneTable& table, const SceneFile& scene, const SceneFileEvent& event) {
  for (const std::size_t body : event.bodies) {
    const SceneFileObject& object = objectOf(scene, body);
    const bool canBreak = std::holds_alternative<SceneFileModel>(object.shape) || !object.gibs.empty();
    if (canBreak && object.motion == SceneFileMotion::kDynamic) continue;
    table.report("target", inQuotes(object.name) +
                               " cannot break: only dynamic models, and dynamic bodies with " +
                               R"("gibs", can)");
    return;
  }
}

void readEvent(const SceneTable& table, SceneFile& scene, const SceneNames& names) {
  static const std::vector<std::string_view> kDeeds{"throw", "knock", "break", "remove", "field"};
  SceneFileEvent event;
  event.line = table.line();
  const auto deed = table.needKind("do", kDeeds);
  if (!deed) return;
  event.frame = readFrame(table);
  if (kDeeds[*deed] != "field" && table.require("target")) event.bodies = names.bodies(table, "target");
  switch (*deed) {
    case 0:
      event.deed = readThrow(table, names);
      break;
    case 1:
      event.deed = readKnock(table);
      break;
    case 2:
      event.deed = readBreak(table);
      checkBreaks(table, scene, event);
      break;
    case 3:
      event.deed = SceneFileRemove{};
      break;
    default:
      event.deed = readSwitch(table, names);
  }
  scene.events.push_back(std::move(event));
}

}  // namespace

void readJoints(const SceneTable& file, SceneFile& scene, const SceneNames& names) {
  for (const SceneTable& table : file.tables("joint", "joint")) {
    readJoint(table, scene, names);
    if (table.problem().any()) return;
  }
}

void readEvents(const SceneTable& file, SceneFile& scene, const SceneNames& names) {
  std::size_t targets = 0;
  for (const SceneTable& table : file.tables("event", "event")) {
    if (scene.events.size() == kMostEvents) {
      table.problem().report(table.line(), "more than " + std::to_string(kMostEvents) + " events");
    }
    readEvent(table, scene, names);
    if (table.problem().any()) return;
    targets += scene.events.back().bodies.size();
    if (targets > kMostTargets) {
      table.problem().report(
          table.line(), "the events have more than " + std::to_string(kMostTargets) + " targets together");
      return;
    }
  }
  std::stable_sort(scene.events.begin(), scene.events.end(),
                   [](const SceneFileEvent& a, const SceneFileEvent& b) { return a.frame < b.frame; });
}

}  // namespace scatter::io
