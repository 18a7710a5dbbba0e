#pragma once

#include <scatter/io/model.h>
#include <scatter/levels/convex_part.h>
#include <scatter/levels/surface_mesh.h>
#include <scatter/result.h>

#include <string>
#include <vector>

namespace scatter::io {

/// The parts of a level, from 1, the coarsest. Fails if the model has no such level.
[[nodiscard]] Result<std::vector<ConvexPart>> partsOf(const Model& model, int level);

/// The surface of a part in the model's frame; of a round part that of a polytope around it.
[[nodiscard]] Result<SurfaceMesh> surfaceOf(const ConvexPart& part);

/// A mesh as an object of an OBJ file, whose indices begin behind `vertices` others.
[[nodiscard]] std::string objObject(const std::string& name, const SurfaceMesh& mesh, std::size_t vertices);

/// The same with z up: x stays, y becomes z.
/// @{
[[nodiscard]] Vec3 zUp(const Vec3& point);
[[nodiscard]] Mat3 zUp(const Mat3& tensor);
[[nodiscard]] SurfaceMesh zUp(SurfaceMesh mesh);

/// Of a frame whose own axes turn as well: a cylinder along its y axis then lies along its z axis.
[[nodiscard]] Transform zUp(const Transform& pose);
/// @}

/// The model's name as a word that no format takes amiss: letters, digits, '_', '-' and '.'.
[[nodiscard]] std::string wordOf(const std::string& name);

/// Numbers with spaces between them.
[[nodiscard]] std::string words(std::initializer_list<float> numbers);

}  // namespace scatter::io
