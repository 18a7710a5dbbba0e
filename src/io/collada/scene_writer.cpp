#include "io/collada/scene_writer.h"

#include <string>

#include "io/collada/joint_writer.h"
#include "io/collada/xml.h"
#include "io/numbers.h"

namespace scatter::io {
namespace {

void writeNodes(pugi::xml_node& root, const PhysicsDocument& document) {
  pugi::xml_node library = append(root, "library_visual_scenes");
  pugi::xml_node scene = append(library, "visual_scene");
  setAttribute(scene, "id", "visual_scene");
  for (std::size_t index = 0; index < document.bodies.size(); ++index) {
    const DocumentBody& body = document.bodies[index];
    pugi::xml_node node = append(scene, "node");
    setAttribute(node, "id", makeId("node", index));
    setName(node, body.name);
    writePose(node, body.pose);
    if (!document.models[body.model].mesh.vertices.empty()) {
      pugi::xml_node instance = append(node, "instance_geometry");
      setAttribute(instance, "url", link(makeId("mesh", body.model)));
    }
  }
  // The schema wants no visual scene without a node.
  if (document.bodies.empty()) {
    append(scene, "node");
  }
}

void writeBody(pugi::xml_node& physics, const DocumentBody& body, std::size_t index) {
  pugi::xml_node instanceModel = append(physics, "instance_physics_model");
  setAttribute(instanceModel, "url", link(makeId("physics_model", body.model)));
  pugi::xml_node instance = append(instanceModel, "instance_rigid_body");
  setAttribute(instance, "body", "body");
  setAttribute(instance, "target", link(makeId("node", index)));
  pugi::xml_node common = append(instance, "technique_common");
  if (const Vec3& v = body.angularVelocity; v != Vec3(0.0F)) {
    appendText(common, "angular_velocity",
               formatDegrees(v.x) + " " + formatDegrees(v.y) + " " + formatDegrees(v.z));
  }
  if (body.linearVelocity != Vec3(0.0F)) {
    appendText(common, "velocity", formatVector(body.linearVelocity));
  }
  if (body.motion) {
    appendText(common, "dynamic", *body.motion == DocumentMotion::kDynamic ? "true" : "false");
  }
  if (body.mass) {
    appendText(common, "mass", formatNumber(*body.mass));
  }
  if (body.motion == DocumentMotion::kKinematic) {
    pugi::xml_node technique = scatterTechnique(instance);
    appendText(technique, "motion", "kinematic");
  }
}

void writeJoints(pugi::xml_node& physics, const PhysicsDocument& document) {
  if (document.joints.empty()) {
    return;
  }
  pugi::xml_node instanceModel = append(physics, "instance_physics_model");
  setAttribute(instanceModel, "url", link(kJointsId));
  for (std::size_t index = 0; index < document.joints.size(); ++index) {
    pugi::xml_node instance = append(instanceModel, "instance_rigid_constraint");
    setAttribute(instance, "constraint", makeId("joint", index));
  }
}

void writePhysicsScene(pugi::xml_node& root, const PhysicsDocument& document) {
  pugi::xml_node library = append(root, "library_physics_scenes");
  pugi::xml_node physics = append(library, "physics_scene");
  setAttribute(physics, "id", "physics_scene");
  setName(physics, document.name);
  for (std::size_t index = 0; index < document.fields.size(); ++index) {
    pugi::xml_node instance = append(physics, "instance_force_field");
    setAttribute(instance, "url", link(makeId("field", index)));
  }
  for (std::size_t index = 0; index < document.bodies.size(); ++index) {
    writeBody(physics, document.bodies[index], index);
  }
  writeJoints(physics, document);
  pugi::xml_node common = append(physics, "technique_common");
  if (document.gravity != Vec3(0.0F)) {
    appendText(common, "gravity", formatVector(document.gravity));
  }
  if (document.timeStep) {
    appendText(common, "time_step", formatNumber(*document.timeStep));
  }
}

}  // namespace

void writeFields(pugi::xml_node& root, const PhysicsDocument& document) {
  writeLibrary(root, "force_field", "field", document.fields,
               [](pugi::xml_node& node, const DocumentField& field) {
                 pugi::xml_node technique = append(node, "technique");
                 setAttribute(technique, "profile", "SCATTER");
                 pugi::xml_node point = append(technique, "point");
                 appendText(point, "center", formatVector(field.center));
                 appendText(point, "acceleration", formatNumber(field.acceleration));
                 appendText(point, "radius", formatNumber(field.radius));
               });
}

void writeScenes(pugi::xml_node& root, const PhysicsDocument& document) {
  writeNodes(root, document);
  writePhysicsScene(root, document);
  pugi::xml_node scene = append(root, "scene");
  pugi::xml_node instancePhysics = append(scene, "instance_physics_scene");
  setAttribute(instancePhysics, "url", "#physics_scene");
  pugi::xml_node instanceVisual = append(scene, "instance_visual_scene");
  setAttribute(instanceVisual, "url", "#visual_scene");
}

}  // namespace scatter::io
