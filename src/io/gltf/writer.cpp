#include <scatter/io/file.h>
#include <scatter/io/gltf.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "io/extension.h"
#include "io/gltf/build.h"
#include "io/gltf/check.h"
#include "io/gltf/models.h"
#include "io/gltf/write_notes.h"

namespace scatter::io {
namespace {

using nlohmann::json;

/// How the shapes of a model stand in the file; each shape is there once, for all bodies.
struct WrittenModel {
  std::vector<json> colliders;  ///< The collider objects.
  std::vector<json> extras;     ///< Of their nodes; null for none.
  std::vector<Transform> poses;
  std::optional<std::size_t> mesh;
  double mass = 1.0;
  bool hasBody = false;
};

class Writer {
 public:
  explicit Writer(const PhysicsDocument& document) : document_(document) {}

  const GltfBuild& write();

 private:
  void writeModel(const DocumentModel& model);
  [[nodiscard]] json writeGeometry(const DocumentModel& model, const DocumentShape& shape, Transform& pose,
                                   json& extras);
  [[nodiscard]] json writeHull(const std::string& name, const ConvexHull& hull);
  [[nodiscard]] std::size_t writeHolder(const std::string& name, const VisualMesh& mesh, bool keepVertices);
  std::size_t writeBody(const DocumentBody& body);
  void writeColliders(std::size_t node, const WrittenModel& model, const std::optional<std::size_t>& filter);
  void writePrototypes();
  void writeJoint(const DocumentJoint& joint);
  [[nodiscard]] std::size_t writeFrame(const std::string& name, const std::optional<std::size_t>& body,
                                       const Transform& frame);

  const PhysicsDocument& document_;
  GltfBuild build_;
  std::vector<WrittenModel> models_;
  std::vector<std::size_t> bodyNodes_;
  std::vector<std::size_t> sceneNodes_;
  json notes_;
};

/// The rotation that turns y to `normal`.
Quat turnFromY(const Vec3& normal) {
  const glm::dvec3 y(0.0, 1.0, 0.0);
  const glm::dvec3 n = glm::normalize(glm::dvec3(normal));
  const double cosine = glm::dot(y, n);
  if (cosine < -0.999999) {
    return {0.0F, 1.0F, 0.0F, 0.0F};
  }
  const glm::dvec3 axis = glm::cross(y, n);
  const glm::dquat q = glm::normalize(glm::dquat(1.0 + cosine, axis.x, axis.y, axis.z));
  return toTransform(glm::dvec3(0.0), q).rotation;
}

const GltfBuild& Writer::write() {
  for (const DocumentMaterial& material : document_.materials) {
    build_.addMaterial(material);
  }
  for (const DocumentFilter& filter : document_.filters) {
    build_.addFilter(filter);
  }
  notes_ = sceneNotes(document_);
  for (const DocumentModel& model : document_.models) {
    writeModel(model);
  }
  for (const DocumentBody& body : document_.bodies) {
    bodyNodes_.push_back(writeBody(body));
  }
  sceneNodes_ = bodyNodes_;
  writePrototypes();
  for (const DocumentJoint& joint : document_.joints) {
    writeJoint(joint);
  }
  build_.setScene(document_.name, sceneNodes_, {{"scatter_scene", std::move(notes_)}});
  return build_;
}

void Writer::writeModel(const DocumentModel& model) {
  WrittenModel written;
  for (const DocumentShape& shape : model.shapes) {
    Transform pose = shape.pose;
    json extras;
    json collider = {{"geometry", writeGeometry(model, shape, pose, extras)}};
    if (const auto material = shape.material ? shape.material : model.material) {
      collider["physicsMaterial"] = *material;
    }
    written.colliders.push_back(std::move(collider));
    written.extras.push_back(std::move(extras));
    written.poses.push_back(pose);
  }
  if (!model.mesh.vertices.empty()) {
    written.mesh = build_.addMesh(model.mesh, model.name);
  }
  written.mass = plainNumber(static_cast<float>(documentMass(model)));
  models_.push_back(std::move(written));
}

json Writer::writeGeometry(const DocumentModel& model, const DocumentShape& shape, Transform& pose,
                           json& extras) {
  const std::string name = model.name + " collider";
  if (const auto* mesh = std::get_if<VisualMesh>(&shape.geometry)) {
    return {{"node", writeHolder(name, *mesh, false)}};
  }
  if (const auto* plane = std::get_if<DocumentPlane>(&shape.geometry)) {
    const DocumentPlane plain;
    if (plane->normal != plain.normal || plane->offset != plain.offset) {
      // A plane in the file goes through its node's origin and faces along y.
      json exact = {{"normal", toJson(plane->normal)}, {"offset", plainNumber(plane->offset)}};
      setPose(exact, pose);
      extras = {{"scatter_plane", std::move(exact)}};
      pose = pose * Transform{plane->normal * plane->offset, turnFromY(plane->normal)};
    }
    return {{"shape", build_.addShape({{"type", "plane"}, {"plane", json::object()}})}};
  }
  const auto& convex = std::get<ConvexShape>(shape.geometry);
  if (const auto* hull = std::get_if<ConvexHull>(&convex)) {
    return writeHull(name, *hull);
  }
  return {{"shape", build_.addShape(toJson(convex))}};
}

json Writer::writeHull(const std::string& name, const ConvexHull& hull) {
  const auto corners = hullCorners(hull.vertices);
  const bool isReduced = corners && *corners != hull.vertices;
  return {{"node", writeHolder(name, {hull.vertices, hullTriangles(hull.vertices)}, isReduced)},
          {"convexHull", true}};
}

/// A node outside the scene that only holds a collider's mesh.
std::size_t Writer::writeHolder(const std::string& name, const VisualMesh& mesh, bool keepVertices) {
  json node = {{"name", name}, {"mesh", build_.addMesh(mesh, name)}};
  if (keepVertices) {
    node["extras"] = {{"scatter_keep_vertices", true}};
  }
  return build_.addNode(std::move(node));
}

std::size_t Writer::writeBody(const DocumentBody& body) {
  const DocumentModel& model = document_.models[body.model];
  WrittenModel& written = models_[body.model];
  json node = {{"name", body.name}, {"extras", bodyNotes(document_, body)}};
  if (!written.hasBody && model.levels) {
    node["extras"]["scatter_levels"] = levelNotes(model);
  }
  written.hasBody = true;
  setPose(node, body.pose);
  if (written.mesh) {
    node["mesh"] = *written.mesh;
  }
  if (body.motion.value_or(model.motion) != DocumentMotion::kStatic) {
    node["extensions"] = GltfBuild::inRigidBodies("motion", motionOf(document_, body, written.mass));
  }
  const std::size_t index = build_.addNode(std::move(node));
  writeColliders(index, written, body.filter);
  return index;
}

void Writer::writeColliders(std::size_t node, const WrittenModel& model,
                            const std::optional<std::size_t>& filter) {
  const auto colliderOf = [&](std::size_t i) {
    json collider = model.colliders[i];
    if (filter) {
      collider["collisionFilter"] = *filter;
    }
    return collider;
  };
  const bool isPlain = model.colliders.size() == 1 && model.extras[0].is_null() &&
                       model.poses[0].position == Vec3(0.0F) && model.poses[0].rotation == kNoRotation;
  if (isPlain) {
    build_.node(node)["extensions"][kRigidBodies]["collider"] = colliderOf(0);
    return;
  }
  for (std::size_t i = 0; i < model.colliders.size(); ++i) {
    json child = {{"extensions", GltfBuild::inRigidBodies("collider", colliderOf(i))}};
    setPose(child, model.poses[i]);
    if (!model.extras[i].is_null()) {
      child["extras"] = model.extras[i];
    }
    build_.addChild(node, build_.addNode(std::move(child)));
  }
}

/// Models that no body is of stand outside the scene.
void Writer::writePrototypes() {
  for (std::size_t i = 0; i < models_.size(); ++i) {
    if (models_[i].hasBody) {
      continue;
    }
    DocumentBody body;
    body.name = document_.models[i].name;
    body.model = i;
    notes_["models"][i]["node"] = writeBody(body);
  }
}

std::size_t Writer::writeFrame(const std::string& name, const std::optional<std::size_t>& body,
                               const Transform& frame) {
  json node = {{"name", name}};
  setPose(node, frame);
  const std::size_t index = build_.addNode(std::move(node));
  if (body) {
    build_.addChild(bodyNodes_[*body], index);
  } else {
    sceneNodes_.push_back(index);
  }
  return index;
}

void Writer::writeJoint(const DocumentJoint& joint) {
  const std::size_t node = writeFrame(joint.name, joint.bodyA, joint.frameA);
  const std::size_t other = writeFrame(joint.name + " (other end)", joint.bodyB, joint.frameB);
  json value = {{"connectedNode", other}, {"joint", build_.addJoint(limitsOf(joint))}};
  if (joint.bodiesCollide) {
    value["enableCollision"] = true;
  }
  if (joint.enabled) {
    build_.node(node)["extensions"] = GltfBuild::inRigidBodies("joint", std::move(value));
  } else {
    build_.node(node)["extras"] = {{"scatter_disabled_joint", std::move(value)}};
  }
}

}  // namespace
}  // namespace scatter::io

namespace scatter {

Result<void> writeGltfDocument(const PhysicsDocument& document, const std::filesystem::path& path) {
  const std::string extension = io::lowerExtension(path);
  if (extension != ".gltf" && extension != ".glb") {
    return fail("cannot write " + path.string() + ": the name should end in .gltf or .glb");
  }
  if (auto sound = io::checkGltfDocument(document); !sound) {
    return fail("cannot write " + path.string() + ": " + sound.error().message);
  }
  io::Writer writer(document);
  const io::GltfBuild& build = writer.write();
  const std::string bytes = extension == ".glb" ? build.binary() : build.text();
  constexpr std::size_t kMaxGltfSize = std::size_t{1} << 30U;
  if (bytes.size() > kMaxGltfSize) {
    return fail("cannot write " + path.string() + ": it would be larger than 1 GiB");
  }
  return writeFile(path, bytes);
}

}  // namespace scatter
