#include "io/gltf/bodies.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>

namespace scatter::io {
namespace {

constexpr double kMaxSpeed = 1e6;

bool hasBodyNotes(const JsonPlace& node) {
  const auto extras = node.find("extras");
  return extras && extras->isObject() && extras->find("scatter_body");
}

/// A velocity in the world. Our own notes have the exact one, unless someone changed the node since.
Vec3 readVelocity(const JsonPlace& motion, const char* key, const glm::dquat& toWorld,
                  const std::optional<Vec3>& noted) {
  const auto place = motion.find(key);
  // Turned, a velocity along the axes may have twice the components.
  const glm::dvec3 plain = place ? toWorld * place->vector(2.0 * kMaxSpeed) : glm::dvec3(0.0);
  const bool isNear = noted && glm::distance(glm::dvec3(*noted), plain) <= 1e-5 * (1.0 + glm::length(plain));
  const Vec3 velocity = isNear ? *noted : Vec3(plain);
  const Vec3 sizes = glm::abs(velocity);
  if (place && static_cast<double>(std::max({sizes.x, sizes.y, sizes.z})) > kMaxSpeed) {
    place->fail("is faster than 1000 km/s");
  }
  return velocity;
}

}  // namespace

GltfBodies::GltfBodies(GltfFile& file, const GltfNodes& nodes, const std::optional<SceneNotes>& notes)
    : file_(&file), nodes_(&nodes), owners_(nodes.count()), bodyOfRoot_(nodes.count()) {
  findOwners();
  std::vector<bool> isPrototype(nodes.count(), false);
  for (std::size_t i = 0; notes && i < notes->models.size(); ++i) {
    if (notes->models[i].node) {
      isPrototype[*notes->models[i].node] = true;
    }
  }
  for (std::size_t i = 0; i < nodes.count(); ++i) {
    if (owners_[i].root == i && (nodes[i].inScene || isPrototype[i])) {
      addBody(i, notes ? notes->models.size() : 0);
    }
  }
  for (std::size_t i = 0; i < nodes.count(); ++i) {
    readNode(i);
  }
}

std::optional<JsonPlace> GltfBodies::extension(std::size_t node) const {
  return nodes_->json(node).find({"extensions", kRigidBodies});
}

void GltfBodies::findOwners() {
  for (const std::size_t i : nodes_->order()) {
    const GltfNode& node = (*nodes_)[i];
    const auto physics = extension(i);
    const bool moves = physics && physics->find("motion");
    const GltfOwner* parent = node.parent ? &owners_[*node.parent] : nullptr;
    const bool inBody = parent != nullptr && parent->root.has_value();
    const bool startsStatic =
        !inBody && ((physics && physics->find("collider")) || hasBodyNotes(nodes_->json(i)));
    if (moves || startsStatic) {
      // The scale of the body's node stays with what is below it.
      owners_[i] = {i, {}};
      owners_[i].placement.stretch = node.world.stretch;
    } else if (inBody) {
      owners_[i] = {parent->root, parent->placement * node.local};
    } else {
      owners_[i] = {std::nullopt, node.world};
    }
    if (!isInReach(owners_[i].placement.position) ||
        (owners_[i].root == i && !isInReach(node.world.position))) {
      nodes_->json(i).fail("lies too far from the origin, or from that of its body");
    }
  }
}

GltfBody* GltfBodies::bodyOf(std::size_t node) {
  const auto root = owners_[node].root;
  const auto index = root ? bodyOfRoot_[*root] : std::nullopt;
  return index ? &bodies_[*index] : nullptr;
}

void GltfBodies::addBody(std::size_t node, std::size_t modelCount) {
  GltfBody body;
  body.node = node;
  body.notes = readBodyNotes(nodes_->json(node), modelCount);
  if (const auto physics = extension(node)) {
    if (const auto motion = physics->find("motion")) {
      readMotion(*motion, body);
    }
  }
  if (body.motion == DocumentMotion::kStatic && body.notes) {
    body.linearVelocity = body.notes->linearVelocity.value_or(Vec3(0.0F));
    body.angularVelocity = body.notes->angularVelocity.value_or(Vec3(0.0F));
  }
  bodyOfRoot_[node] = bodies_.size();
  bodies_.push_back(std::move(body));
}

void GltfBodies::readMotion(const JsonPlace& motion, GltfBody& body) {
  file_->warnUnknown(motion, {"isKinematic", "mass", "centerOfMass", "inertiaDiagonal", "inertiaOrientation",
                              "linearVelocity", "angularVelocity", "gravityFactor"});
  const auto kinematic = motion.find("isKinematic");
  body.motion = kinematic && kinematic->boolean() ? DocumentMotion::kKinematic : DocumentMotion::kDynamic;
  if (const auto mass = motion.find("mass")) {
    if (mass->number(0.0, kMaxGltfMass) == 0.0) {
      file_->warn(*mass, "zero stands for an infinite mass; the body is read as kinematic");
      body.motion = DocumentMotion::kKinematic;
    } else {
      body.mass = static_cast<float>(mass->number(kMinGltfMass, kMaxGltfMass));
    }
  }
  readMassFrame(motion, body);
  const glm::dquat& toWorld = (*nodes_)[body.node].world.rotation;
  const auto noted = [&](auto member) { return body.notes ? (*body.notes).*member : std::nullopt; };
  body.linearVelocity = readVelocity(motion, "linearVelocity", toWorld, noted(&BodyNotes::linearVelocity));
  body.angularVelocity = readVelocity(motion, "angularVelocity", toWorld, noted(&BodyNotes::angularVelocity));
  if (const auto gravity = motion.find("gravityFactor")) {
    body.gravityFactor = static_cast<float>(gravity->number(-kMaxGltfGravityFactor, kMaxGltfGravityFactor));
  }
}

void GltfBodies::readMassFrame(const JsonPlace& motion, GltfBody& body) {
  const auto center = motion.find("centerOfMass");
  const auto diagonal = motion.find("inertiaDiagonal");
  const auto orientation = motion.find("inertiaOrientation");
  if (!center && !diagonal && !orientation) {
    return;
  }
  DocumentMassFrame frame;
  body.hasCenter = center.has_value();
  // The scale of the node moves its points.
  const glm::dmat3& stretch = owners_[body.node].placement.stretch;
  const glm::dvec3 position = center ? stretch * center->vector() : glm::dvec3(0.0);
  if (!isInReach(position)) {
    center->fail("lies too far from the origin, or from that of its body");
  }
  frame.pose = toTransform(position, orientation ? orientation->rotation() : glm::dquat(1.0, 0.0, 0.0, 0.0));
  if (diagonal) {
    const glm::dvec3 inertia = diagonal->vector(kMaxGltfInertia);
    if (std::min({inertia.x, inertia.y, inertia.z}) < 0.0) {
      diagonal->fail("should be three positive numbers");
    }
    // Zero stands for an infinite one: nothing turns the body about that axis.
    glm::vec3 moments(inertia);
    const float largest = std::max({moments.x, moments.y, moments.z});
    for (int axis = 0; axis < 3; ++axis) {
      if (inertia[axis] >= kMinGltfInertia) continue;
      moments[axis] = largest > 0.0F ? kEndlessInertiaRatio * largest : kEndlessInertia;
    }
    frame.inertia = moments;
  }
  body.massFrame = frame;
}

void GltfBodies::readNode(std::size_t node) {
  const JsonPlace place = nodes_->json(node);
  GltfBody* body = bodyOf(node);
  if (const auto mesh = place.find("mesh")) {
    const std::size_t index = mesh->index(file_->count("meshes"), "mesh");
    if (body != nullptr) {
      body->visuals.push_back({node, index, owners_[node].placement});
    } else if ((*nodes_)[node].inScene) {
      file_->warn("meshes that belong to no rigid body are left out");
    }
  }
  for (const char* key : {"skin", "weights"}) {
    if (body != nullptr && place.find(key)) {
      file_->warn(place.at(key), "is not supported; the mesh is read as it is without it");
    }
  }
  const auto physics = extension(node);
  if (!physics) {
    return;
  }
  if (body == nullptr && !(*nodes_)[node].inScene) {
    file_->warn(place, "has physics, but stands outside the scene; it is left out");
    return;
  }
  file_->warnUnknown(*physics, {"motion", "collider", "trigger", "joint"});
  if (const auto trigger = physics->find("trigger")) {
    file_->warn(*trigger, "triggers are not supported; it is left out");
  }
  if (const auto collider = physics->find("collider"); collider && body != nullptr) {
    readCollider(node, *collider);
  }
}

void GltfBodies::readCollider(std::size_t node, const JsonPlace& collider) {
  GltfCollider result;
  result.node = node;
  result.placement = owners_[node].placement;
  // Earlier drafts had the shape in the collider itself.
  const JsonPlace geometry = collider.find("geometry").value_or(collider);
  file_->warnUnknown(geometry, {"shape", "node", "convexHull", "physicsMaterial", "collisionFilter"});
  if (collider.find("geometry")) {
    file_->warnUnknown(collider, {"geometry", "physicsMaterial", "collisionFilter"});
  }
  const auto shape = geometry.find("shape");
  const auto source = geometry.find("node");
  if (shape.has_value() == source.has_value()) {
    geometry.fail(R"(should have either "shape" or "node")");
  }
  if (shape) {
    const auto shapes = file_->root().find({"extensions", kImplicitShapes, "shapes"});
    result.source = shape->index(shapes ? shapes->size() : 0, "shape");
  } else {
    result.implicit = false;
    result.source = source->index(nodes_->count(), "node");
  }
  const auto hull = geometry.find("convexHull");
  result.hull = hull && hull->boolean();
  if (const auto material = collider.find("physicsMaterial")) {
    const auto materials = file_->root().find({"extensions", kRigidBodies, "physicsMaterials"});
    result.material = material->index(materials ? materials->size() : 0, "physics material");
  }
  std::optional<std::size_t> filter;
  if (const auto given = collider.find("collisionFilter")) {
    const auto filters = file_->root().find({"extensions", kRigidBodies, "collisionFilters"});
    filter = given->index(filters ? filters->size() : 0, "collision filter");
  }
  GltfBody& body = *bodyOf(node);
  if (body.colliders.empty()) {
    body.filter = filter;
  } else if (body.filter != filter) {
    file_->warn(collider, "a body has one collision filter; that of its first collider is taken for all");
  }
  body.colliders.push_back(result);
}

}  // namespace scatter::io
