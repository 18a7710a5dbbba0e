#pragma once

#include <scatter/io/physics_document.h>

#include <optional>
#include <string>
#include <vector>

#include "io/gltf/nodes.h"

namespace scatter::io {

/// What our `extras` say beyond glTF. docs/files.md has their layout.

/// Of a shape, in "scatter_scene".models[i].shapes.
struct ShapeNotes {
  std::optional<std::size_t> material;
  std::optional<float> density;
  std::optional<float> mass;
};

/// Of a model, in "scatter_scene".models.
struct ModelNotes {
  std::string name;
  DocumentMotion motion = DocumentMotion::kDynamic;
  std::optional<float> mass;
  std::optional<std::size_t> material;
  std::optional<DocumentMassFrame> massFrame;
  std::vector<ShapeNotes> shapes;   ///< One for each, or none at all.
  std::optional<std::size_t> node;  ///< Where the model is, if no body in the scene is of it.
};

/// Of a scene, in its "scatter_scene".
struct SceneNotes {
  Vec3 gravity{0.0F};
  std::optional<float> timeStep;
  std::vector<DocumentField> fields;
  std::vector<ModelNotes> models;
};

/// Of a body's node, in its "scatter_body".
struct BodyNotes {
  std::size_t model = 0;
  std::optional<DocumentMotion> motion;
  std::optional<float> mass;
  std::optional<Vec3> linearVelocity;
  std::optional<Vec3> angularVelocity;
};

/// A plane with the values that its node was made from, in "scatter_plane".
struct PlaneNotes {
  DocumentPlane plane;
  Transform pose;
};

/// @{ Each is nothing if the extras do not have it. Throws GltfFailure.
[[nodiscard]] std::optional<SceneNotes> readSceneNotes(const GltfFile& file, const GltfNodes& nodes);
[[nodiscard]] std::optional<BodyNotes> readBodyNotes(const JsonPlace& node, std::size_t modelCount);
[[nodiscard]] std::optional<PlaneNotes> readPlaneNotes(const JsonPlace& node);
/// @}

/// "scatter_levels" of a node: all levels but the finest, whose parts are given. `stretch` is the scale
/// of the node.
[[nodiscard]] std::shared_ptr<const LevelSet> readLevels(GltfFile& file, const JsonPlace& levels,
                                                         const std::string& modelName,
                                                         const std::vector<ConvexPart>& finest,
                                                         const glm::dmat3& stretch);

/// A mass that can be written and read; kilograms.
inline constexpr double kMinGltfMass = 1e-9;
inline constexpr double kMaxGltfMass = 1e12;

/// The same of a moment of inertia; kg m².
inline constexpr double kMinGltfInertia = 1e-20;
inline constexpr double kMaxGltfInertia = 1e20;

/// What stands for an infinite one: so many times the largest of the others, which single precision still
/// tells beside it where the axes lean; kg m² if all are infinite.
inline constexpr float kEndlessInertiaRatio = 1e4F;
inline constexpr float kEndlessInertia = 1e12F;

inline constexpr double kMaxGltfGravityFactor = 1e6;

[[nodiscard]] const char* nameOf(DocumentMotion motion);

}  // namespace scatter::io
