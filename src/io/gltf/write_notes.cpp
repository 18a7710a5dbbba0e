#include "io/gltf/write_notes.h"

#include <scatter/levels/mass_properties.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "io/gltf/build.h"
#include "io/gltf/notes.h"

namespace scatter::io {
namespace {

using nlohmann::json;

json shapeNotes(const DocumentModel& model) {
  json list = json::array();
  bool isNeeded = false;
  for (const DocumentShape& shape : model.shapes) {
    json notes = json::object();
    if (shape.material) {
      notes["material"] = *shape.material;
    }
    if (shape.density) {
      notes["density"] = plainNumber(*shape.density);
    }
    if (shape.mass) {
      notes["mass"] = plainNumber(*shape.mass);
    }
    isNeeded = isNeeded || !notes.empty();
    list.push_back(std::move(notes));
  }
  return isNeeded ? list : json();
}

json modelNotes(const DocumentModel& model) {
  json notes = {{"name", model.name}, {"motion", nameOf(model.motion)}};
  if (model.mass) {
    notes["mass"] = plainNumber(*model.mass);
  }
  if (model.material) {
    notes["material"] = *model.material;
  }
  if (model.massFrame) {
    json frame = json::object();
    setPose(frame, model.massFrame->pose);
    if (model.massFrame->inertia) {
      frame["inertia"] = toJson(*model.massFrame->inertia);
    }
    notes["massFrame"] = std::move(frame);
  }
  if (json shapes = shapeNotes(model); !shapes.is_null()) {
    notes["shapes"] = std::move(shapes);
  }
  return notes;
}

json partsOf(const Level& level) {
  json parts = json::array();
  for (const ConvexPart& part : level.parts) {
    json object = toJson(part.shape);
    setPose(object, part.pose);
    parts.push_back(std::move(object));
  }
  return parts;
}

bool isSame(const Level& level, const std::vector<DocumentShape>& shapes) {
  // Text compares all kinds of shapes at once; equal numbers have equal texts.
  json parts = json::array();
  for (const DocumentShape& shape : shapes) {
    const auto* convex = std::get_if<ConvexShape>(&shape.geometry);
    if (convex == nullptr) {
      return false;
    }
    json object = toJson(*convex);
    setPose(object, shape.pose);
    parts.push_back(std::move(object));
  }
  return parts == partsOf(level);
}

json massNotes(const MassProperties& mass) {
  json inertia = json::array();
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      inertia.push_back(plainNumber(mass.inertia[column][row]));
    }
  }
  return {{"volume", plainNumber(mass.volume)},
          {"centerOfMass", toJson(mass.centerOfMass)},
          {"inertia", std::move(inertia)}};
}

bool isSame(const MassProperties& a, const MassProperties& b) {
  return a.volume == b.volume && a.centerOfMass == b.centerOfMass && a.inertia == b.inertia;
}

/// A velocity of the body in its node's frame.
json velocityIn(const DocumentBody& body, const Vec3& velocity) {
  return toJson(Vec3(glm::inverse(glm::dquat(body.pose.rotation)) * glm::dvec3(velocity)));
}

json limitJson(const char* kind, int axis, const DocumentLimit& limit) {
  json object = {{kind, json::array({axis})}};
  // JSON has no infinity; a limit that is not there is one.
  if (std::isfinite(limit.lower)) {
    object["min"] = plainNumber(limit.lower);
  }
  if (std::isfinite(limit.upper)) {
    object["max"] = plainNumber(limit.upper);
  }
  return object;
}

void addLimits(json& limits, const char* kind, const std::array<DocumentLimit, 3>& axes) {
  json locked = json::array();
  for (int i = 0; i < 3; ++i) {
    const DocumentLimit& limit = axes[static_cast<std::size_t>(i)];
    if (limit.lower == 0.0F && limit.upper == 0.0F) {
      locked.push_back(i);
    } else if (limit.lower <= limit.upper && (std::isfinite(limit.lower) || std::isfinite(limit.upper))) {
      limits.push_back(limitJson(kind, i, limit));
    }
  }
  if (!locked.empty()) {
    limits.push_back({{kind, std::move(locked)}, {"min", 0.0}, {"max", 0.0}});
  }
}

}  // namespace

json sceneNotes(const PhysicsDocument& document) {
  json notes = {{"gravity", toJson(document.gravity)}};
  if (document.timeStep) {
    notes["timeStep"] = plainNumber(*document.timeStep);
  }
  for (const DocumentField& field : document.fields) {
    notes["fields"].push_back({{"name", field.name},
                               {"center", toJson(field.center)},
                               {"acceleration", plainNumber(field.acceleration)},
                               {"radius", plainNumber(field.radius)}});
  }
  for (const DocumentModel& model : document.models) {
    notes["models"].push_back(modelNotes(model));
  }
  return notes;
}

json bodyNotes(const PhysicsDocument& document, const DocumentBody& body) {
  json notes = {{"model", body.model}};
  if (body.motion) {
    notes["motion"] = nameOf(*body.motion);
  }
  if (body.mass) {
    notes["mass"] = plainNumber(*body.mass);
  }
  const bool isStatic = body.motion.value_or(document.models[body.model].motion) == DocumentMotion::kStatic;
  // In the node's frame they are rounded.
  const bool isExact = !isStatic && body.pose.rotation == kNoRotation;
  if (body.linearVelocity != Vec3(0.0F) && !isExact) {
    notes["linearVelocity"] = toJson(body.linearVelocity);
  }
  if (body.angularVelocity != Vec3(0.0F) && !isExact) {
    notes["angularVelocity"] = toJson(body.angularVelocity);
  }
  return {{"scatter_body", std::move(notes)}};
}

json levelNotes(const DocumentModel& model) {
  const LevelSet& set = *model.levels;
  json notes = {{"hullMargin", plainNumber(set.hullMargin())}, {"levels", json::array()}};
  if (set.name() != model.name) {
    notes["name"] = set.name();
  }
  for (int i = 1; i < set.count(); ++i) {
    notes["levels"].push_back(partsOf(set.level(i)));
  }
  if (!isSame(set.finest(), model.shapes)) {
    notes["finest"] = partsOf(set.finest());
  }
  const auto worked = massProperties(set.finest().parts);
  if (!worked || !isSame(*worked, set.mass())) {
    notes["mass"] = massNotes(set.mass());
  }
  return notes;
}

json motionOf(const PhysicsDocument& document, const DocumentBody& body, double modelMass) {
  const DocumentModel& model = document.models[body.model];
  json motion = {{"mass", body.mass ? plainNumber(*body.mass) : modelMass}};
  if (body.motion.value_or(model.motion) == DocumentMotion::kKinematic) {
    motion["isKinematic"] = true;
  }
  if (model.massFrame) {
    const Transform& pose = model.massFrame->pose;
    motion["centerOfMass"] = toJson(pose.position);
    if (pose.rotation != kNoRotation) {
      const Quat& q = pose.rotation;
      motion["inertiaOrientation"] = {plainNumber(q.x), plainNumber(q.y), plainNumber(q.z), plainNumber(q.w)};
    }
    if (model.massFrame->inertia) {
      motion["inertiaDiagonal"] = toJson(*model.massFrame->inertia);
    }
  }
  if (body.linearVelocity != Vec3(0.0F)) {
    motion["linearVelocity"] = velocityIn(body, body.linearVelocity);
  }
  if (body.gravityFactor != 1.0F) {
    motion["gravityFactor"] = plainNumber(body.gravityFactor);
  }
  if (body.angularVelocity != Vec3(0.0F)) {
    motion["angularVelocity"] = velocityIn(body, body.angularVelocity);
  }
  return motion;
}

json limitsOf(const DocumentJoint& joint) {
  json limits = json::array();
  addLimits(limits, "linearAxes", joint.linear);
  addLimits(limits, "angularAxes", joint.angular);
  return limits.empty() ? json::object() : json{{"limits", std::move(limits)}};
}

}  // namespace scatter::io
