#pragma once

#include <scatter/io/physics_document.h>

#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace scatter::io {

/// The double with the fewest digits that rounds to the float.
[[nodiscard]] double plainNumber(float value);

[[nodiscard]] nlohmann::json toJson(const Vec3& v);

/// Sets "translation" and "rotation", unless they are those of no motion.
void setPose(nlohmann::json& object, const Transform& pose);

/// A shape object: "type" and the member of that name.
[[nodiscard]] nlohmann::json toJson(const ConvexShape& shape);

/// A glTF file that grows.
class GltfBuild {
 public:
  /// Without `physics` it is of what every program shows: no shapes, joints and filters.
  explicit GltfBuild(bool physics = true);
  GltfBuild(const GltfBuild&) = delete;
  GltfBuild& operator=(const GltfBuild&) = delete;
  ~GltfBuild();

  /// @{ Each returns the index of what it adds.
  std::size_t addMesh(const VisualMesh& mesh, const std::string& name);
  std::size_t addNode(nlohmann::json node);
  std::size_t addShape(nlohmann::json shape);
  std::size_t addJoint(nlohmann::json joint);
  std::size_t addMaterial(const DocumentMaterial& material);
  std::size_t addFilter(const DocumentFilter& filter);
  std::size_t addAppearance(const std::string& name, const Vec3& color);

  /// Numbers that an animation names, so many of them making a SCALAR, VEC3 or VEC4. At least one.
  std::size_t addNumbers(const std::vector<float>& numbers, std::size_t each);
  std::size_t addAnimation(nlohmann::json animation);
  /// @}

  [[nodiscard]] nlohmann::json& node(std::size_t index);
  void setMeshMaterial(std::size_t mesh, std::size_t appearance);
  void addChild(std::size_t parent, std::size_t child);

  /// The scene, once; its nodes are those given.
  void setScene(const std::string& name, const std::vector<std::size_t>& nodes, nlohmann::json extras);

  /// The bytes of a .glb file, or the text of a .gltf file.
  [[nodiscard]] std::string binary() const;
  [[nodiscard]] std::string text() const;

  /// The extension objects that bodies and joints stand in.
  [[nodiscard]] static nlohmann::json inRigidBodies(const char* key, nlohmann::json value);

 private:
  [[nodiscard]] nlohmann::json finished() const;
  std::size_t addView(const void* data, std::size_t size, int target = 0);
  std::size_t addPositions(const std::vector<Vec3>& positions);
  std::size_t addIndices(const std::vector<std::array<std::uint32_t, 3>>& triangles);

  std::unique_ptr<nlohmann::json> root_;
  std::string data_;
};

}  // namespace scatter::io
