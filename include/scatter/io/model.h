#pragma once

#include <scatter/levels/level_set.h>
#include <scatter/math.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace scatter {

/// What is drawn: triangles in the model's frame, counter-clockwise seen from outside.
struct VisualMesh {
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// What a model file holds: a rigid body with nested collision shapes and the mesh that shows it.
struct Model {
  std::string name;
  VisualMesh mesh;  ///< May be empty.
  std::shared_ptr<const LevelSet> levels;
  float mass = 1.0F;  ///< Kilograms.
  float friction = 0.5F;
  float restitution = 0.0F;  ///< 0 no bounce, 1 full bounce.
};

}  // namespace scatter
