#pragma once

#include <scatter/levels/level_set.h>
#include <scatter/levels/surface_mesh.h>
#include <scatter/math.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace scatter {

/// What is drawn, in the model's frame.
using VisualMesh = SurfaceMesh;

/// What a model file holds: a rigid body with nested collision shapes and the mesh that shows it.
struct Model {
  std::string name;
  VisualMesh mesh;  ///< May be empty.
  std::shared_ptr<const LevelSet> levels;
  float mass = 1.0F;  ///< Kilograms.
  float friction = 0.5F;
  float restitution = 0.0F;  ///< 0 no bounce, 1 full bounce.
};

/// The model's mesh, which keeps the model; null if it has none.
[[nodiscard]] inline std::shared_ptr<const VisualMesh> drawnMesh(const std::shared_ptr<const Model>& model) {
  return model->mesh.triangles.empty() ? nullptr : std::shared_ptr<const VisualMesh>(model, &model->mesh);
}

}  // namespace scatter
