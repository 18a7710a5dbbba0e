#include "io/gltf/build.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "io/gltf/base64.h"
#include "io/gltf/bodies.h"
#include "io/gltf/component.h"
#include "io/gltf/container.h"
#include "io/numbers.h"

namespace scatter::io {
namespace {

using nlohmann::json;

constexpr int kVertices = 34962;
constexpr int kIndices = 34963;

std::size_t append(json& list, json value) {
  list.push_back(std::move(value));
  return list.size() - 1;
}

/// Turns a convex shape into a shape object.
struct ShapeJson {
  json operator()(const Box& box) const {
    return {{"type", "box"}, {"box", {{"size", toJson(2.0F * box.halfExtents)}}}};
  }
  json operator()(const Sphere& sphere) const {
    return {{"type", "sphere"}, {"sphere", {{"radius", plainNumber(sphere.radius)}}}};
  }
  json operator()(const Capsule& capsule) const {
    return round("capsule", capsule.radius, capsule.halfHeight);
  }
  json operator()(const Cylinder& c) const { return round("cylinder", c.radius, c.halfHeight); }
  json operator()(const ConvexHull& hull) const {
    json vertices = json::array();
    for (const Vec3& v : hull.vertices) {
      vertices.insert(vertices.end(), {plainNumber(v.x), plainNumber(v.y), plainNumber(v.z)});
    }
    return {{"type", "hull"}, {"hull", {{"vertices", std::move(vertices)}}}};
  }

  static json round(const char* type, float radius, float halfHeight) {
    const double r = plainNumber(radius);
    return {{"type", type},
            {type, {{"radiusBottom", r}, {"radiusTop", r}, {"height", plainNumber(2.0F * halfHeight)}}}};
  }
};

}  // namespace

double plainNumber(float value) {
  const double plain = parseNumber(formatNumber(value)).value_or(0.0);
  return static_cast<float>(plain) == value ? plain : static_cast<double>(value);
}

json toJson(const Vec3& v) {
  return {plainNumber(v.x), plainNumber(v.y), plainNumber(v.z)};
}

void setPose(json& object, const Transform& pose) {
  if (pose.position != Vec3(0.0F)) {
    object["translation"] = toJson(pose.position);
  }
  const Quat& q = pose.rotation;
  if (q != kNoRotation) {
    object["rotation"] = {plainNumber(q.x), plainNumber(q.y), plainNumber(q.z), plainNumber(q.w)};
  }
}

json toJson(const ConvexShape& shape) {
  return std::visit(ShapeJson{}, shape);
}

GltfBuild::GltfBuild(bool physics) : root_(std::make_unique<json>(json::object())) {
  (*root_)["asset"] = {{"version", "2.0"}, {"generator", "Scatter"}};
  if (physics) {
    (*root_)["extensionsUsed"] = {kImplicitShapes, kRigidBodies};
  }
}

GltfBuild::~GltfBuild() = default;

std::size_t GltfBuild::addView(const void* data, std::size_t size, int target) {
  data_.resize((data_.size() + 3) / 4 * 4, '\0');
  const std::size_t offset = data_.size();
  data_.append(static_cast<const char*>(data), size);
  json view = {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", size}};
  if (target != 0) {
    view["target"] = target;
  }
  return append((*root_)["bufferViews"], std::move(view));
}

std::size_t GltfBuild::addPositions(const std::vector<Vec3>& positions) {
  static_assert(sizeof(Vec3) == 3 * sizeof(float));
  Vec3 low = positions.front();
  Vec3 high = low;
  for (const Vec3& p : positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const std::size_t view = addView(positions.data(), positions.size() * sizeof(Vec3), kVertices);
  return append((*root_)["accessors"], {{"bufferView", view},
                                        {"componentType", Component::kFloat},
                                        {"type", "VEC3"},
                                        {"count", positions.size()},
                                        {"min", toJson(low)},
                                        {"max", toJson(high)}});
}

std::size_t GltfBuild::addIndices(const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  std::uint32_t largest = 0;
  for (const auto& triangle : triangles) {
    largest = std::max({largest, triangle[0], triangle[1], triangle[2]});
  }
  // 65535 ends a strip in some programs.
  const bool isSmall = largest < 65535;
  std::string bytes;
  for (const auto& triangle : triangles) {
    for (const std::uint32_t corner : triangle) {
      const auto small = static_cast<std::uint16_t>(corner);
      bytes.append(isSmall ? reinterpret_cast<const char*>(&small) : reinterpret_cast<const char*>(&corner),
                   isSmall ? sizeof small : sizeof corner);
    }
  }
  return append((*root_)["accessors"],
                {{"bufferView", addView(bytes.data(), bytes.size(), kIndices)},
                 {"componentType", isSmall ? Component::kUnsignedShort : Component::kUnsignedInt},
                 {"type", "SCALAR"},
                 {"count", 3 * triangles.size()}});
}

std::size_t GltfBuild::addMesh(const VisualMesh& mesh, const std::string& name) {
  constexpr int kPoints = 0;
  json primitive = {{"attributes", {{"POSITION", addPositions(mesh.vertices)}}}};
  if (mesh.triangles.empty()) {
    primitive["mode"] = kPoints;
  } else {
    primitive["indices"] = addIndices(mesh.triangles);
  }
  return append((*root_)["meshes"], {{"name", name}, {"primitives", json::array({std::move(primitive)})}});
}

void GltfBuild::setMeshMaterial(std::size_t mesh, std::size_t appearance) {
  (*root_)["meshes"][mesh]["primitives"][0]["material"] = appearance;
}

std::size_t GltfBuild::addAppearance(const std::string& name, const Vec3& color) {
  return append((*root_)["materials"], {{"name", name},
                                        {"doubleSided", true},
                                        {"pbrMetallicRoughness",
                                         {{"baseColorFactor", {color.x, color.y, color.z, 1.0F}},
                                          {"metallicFactor", 0.1},
                                          {"roughnessFactor", 0.8}}}});
}

std::size_t GltfBuild::addNumbers(const std::vector<float>& numbers, std::size_t each) {
  std::vector<float> low(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(each));
  std::vector<float> high = low;
  for (std::size_t i = each; i < numbers.size(); ++i) {
    low[i % each] = std::min(low[i % each], numbers[i]);
    high[i % each] = std::max(high[i % each], numbers[i]);
  }
  return append((*root_)["accessors"],
                {{"bufferView", addView(numbers.data(), numbers.size() * sizeof(float))},
                 {"componentType", Component::kFloat},
                 {"type", each == 1   ? "SCALAR"
                          : each == 3 ? "VEC3"
                                      : "VEC4"},
                 {"count", numbers.size() / each},
                 {"min", low},
                 {"max", high}});
}

std::size_t GltfBuild::addAnimation(json animation) {
  return append((*root_)["animations"], std::move(animation));
}

std::size_t GltfBuild::addNode(json node) {
  return append((*root_)["nodes"], std::move(node));
}

json& GltfBuild::node(std::size_t index) {
  return (*root_)["nodes"][index];
}

void GltfBuild::addChild(std::size_t parent, std::size_t child) {
  node(parent)["children"].push_back(child);
}

std::size_t GltfBuild::addShape(json shape) {
  return append((*root_)["extensions"][kImplicitShapes]["shapes"], std::move(shape));
}

std::size_t GltfBuild::addJoint(json joint) {
  return append((*root_)["extensions"][kRigidBodies]["physicsJoints"], std::move(joint));
}

std::size_t GltfBuild::addFilter(const DocumentFilter& filter) {
  json object = json::object();
  if (!filter.systems.empty()) {
    object["collisionSystems"] = filter.systems;
  }
  if (!filter.collideWith.empty()) {
    object["collideWithSystems"] = filter.collideWith;
  }
  if (!filter.notCollideWith.empty()) {
    object["notCollideWithSystems"] = filter.notCollideWith;
  }
  return append((*root_)["extensions"][kRigidBodies]["collisionFilters"], std::move(object));
}

std::size_t GltfBuild::addMaterial(const DocumentMaterial& material) {
  return append((*root_)["extensions"][kRigidBodies]["physicsMaterials"],
                {{"name", material.name},
                 {"staticFriction", plainNumber(material.staticFriction)},
                 {"dynamicFriction", plainNumber(material.dynamicFriction)},
                 {"restitution", plainNumber(material.restitution)},
                 {"frictionCombine", "multiply"},
                 {"restitutionCombine", "multiply"}});
}

void GltfBuild::setScene(const std::string& name, const std::vector<std::size_t>& nodes, json extras) {
  json scene = {{"name", name}, {"extras", std::move(extras)}};
  // glTF has no empty arrays.
  if (!nodes.empty()) {
    scene["nodes"] = nodes;
  }
  (*root_)["scene"] = 0;
  (*root_)["scenes"] = json::array({std::move(scene)});
}

json GltfBuild::inRigidBodies(const char* key, json value) {
  return {{kRigidBodies, {{key, std::move(value)}}}};
}

json GltfBuild::finished() const {
  json root = *root_;
  if (!data_.empty()) {
    root["buffers"] = json::array({{{"byteLength", data_.size()}}});
  }
  return root;
}

std::string GltfBuild::text() const {
  json root = finished();
  if (!data_.empty()) {
    root["buffers"][0]["uri"] = "data:application/octet-stream;base64," + encodeBase64(data_);
  }
  return root.dump(1) + "\n";
}

std::string GltfBuild::binary() const {
  return packGlb(finished().dump(), data_);
}

}  // namespace scatter::io
