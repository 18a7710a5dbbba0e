#pragma once

#include <scatter/io/model.h>
#include <scatter/result.h>

#include <filesystem>

namespace scatter {

/// One level of a model for programs that know no levels: each part is a shape of its own, without its
/// margin. `level` counts from 1, the coarsest. Files are whole or not there at all. They fail on a level
/// that the model does not have, a part without volume, and a file that cannot be written.
/// @{

/// Wavefront OBJ: an object for each part, named after the model, its level and its number, as triangles.
/// Spheres, capsules and cylinders become polytopes around them, at most 1 % of the radius larger. Metres, y
/// up.
[[nodiscard]] Result<void> writeObj(const Model& model, int level, const std::filesystem::path& path);

/// URDF: one link with a collision element for each part, the model's mesh as its visual, mass, centre of
/// mass and inertia. Boxes, spheres and cylinders stay what they are, a capsule becomes a cylinder and two
/// spheres; hulls and the mesh are OBJ files in the folder "<name of the file>_meshes" beside it. Metres, z
/// up, as in ROS.
[[nodiscard]] Result<void> writeUrdf(const Model& model, int level, const std::filesystem::path& path);

/// MuJoCo's MJCF: one free body with a geom for each part, hulls by their vertices, so that the file stands
/// alone. Friction is that of the model, mass, centre and inertia too. Metres, z up.
[[nodiscard]] Result<void> writeMjcf(const Model& model, int level, const std::filesystem::path& path);

/// @}

}  // namespace scatter
