#pragma once

#include <scatter/io/scene_file.h>
#include <scatter/result.h>
#include <scatter/world/shape.h>

#include <filesystem>

namespace scatter {

/// The heights of a terrain, from 0 to its relief. The same on every platform.
[[nodiscard]] HeightField terrainHeights(const SceneFileTerrain& terrain);

/// The same as the shape that the terrain asks for.
[[nodiscard]] Shape terrainShape(const SceneFileTerrain& terrain);

/// The triangle mesh of a mesh file. Fails as readMesh does.
[[nodiscard]] Result<Shape> readMeshShape(const std::filesystem::path& file);

}  // namespace scatter
