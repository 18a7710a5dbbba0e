#pragma once

#include <scatter/io/physics_document.h>

#include <optional>
#include <vector>

#include "io/gltf/notes.h"

namespace scatter::io {

inline constexpr const char* kRigidBodies = "KHR_physics_rigid_bodies";
inline constexpr const char* kImplicitShapes = "KHR_implicit_shapes";

/// A collider as the file has it.
struct GltfCollider {
  std::size_t node = 0;
  bool implicit = true;    ///< Else of the meshes at and below a node.
  std::size_t source = 0;  ///< The shape or node.
  bool hull = false;
  GltfPlacement placement;  ///< In the rigid frame of the body.
  std::optional<std::size_t> material;
};

/// A mesh that is drawn with a body.
struct GltfVisual {
  std::size_t node = 0;
  std::size_t mesh = 0;
  GltfPlacement placement;
};

/// A rigid body as the file has it.
struct GltfBody {
  std::size_t node = 0;
  DocumentMotion motion = DocumentMotion::kStatic;
  std::optional<float> mass;
  std::optional<DocumentMassFrame> massFrame;
  bool hasCenter = false;  ///< Else the mass frame lies where the shapes' centre is.
  Vec3 linearVelocity{0.0F};
  Vec3 angularVelocity{0.0F};
  float gravityFactor = 1.0F;
  std::optional<std::size_t> filter;  ///< Of its colliders.
  std::vector<GltfCollider> colliders;
  std::vector<GltfVisual> visuals;
  std::optional<BodyNotes> notes;
};

/// What a node belongs to, and where it is there.
struct GltfOwner {
  std::optional<std::size_t> root;  ///< The body's node; the world if absent.
  GltfPlacement placement;          ///< In the body's rigid frame, or in the world.
};

/// The rigid bodies of a file, in the order of their nodes.
class GltfBodies {
 public:
  /// Throws GltfFailure.
  GltfBodies(GltfFile& file, const GltfNodes& nodes, const std::optional<SceneNotes>& notes);

  [[nodiscard]] const std::vector<GltfBody>& all() const { return bodies_; }
  [[nodiscard]] const GltfOwner& owner(std::size_t node) const { return owners_[node]; }

  /// The rigid body extension of a node, if it has it.
  [[nodiscard]] std::optional<JsonPlace> extension(std::size_t node) const;

 private:
  void findOwners();
  void readNode(std::size_t node);
  void readCollider(std::size_t node, const JsonPlace& collider);
  void addBody(std::size_t node, std::size_t modelCount);
  void readMotion(const JsonPlace& motion, GltfBody& body);
  void readMassFrame(const JsonPlace& motion, GltfBody& body);
  [[nodiscard]] GltfBody* bodyOf(std::size_t node);

  GltfFile* file_;
  const GltfNodes* nodes_;
  std::vector<GltfOwner> owners_;
  std::vector<GltfBody> bodies_;
  std::vector<std::optional<std::size_t>> bodyOfRoot_;
};

}  // namespace scatter::io
