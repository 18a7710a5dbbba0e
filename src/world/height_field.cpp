#include <scatter/world/shape.h>

namespace scatter {

Vec3 HeightField::point(std::uint32_t column, std::uint32_t row) const {
  // Half the number of cells is exact, so that engines which compute the same find the same point.
  const float x = static_cast<float>(column) - 0.5F * static_cast<float>(columns - 1);
  const float z = static_cast<float>(row) - 0.5F * static_cast<float>(rows - 1);
  return {x * spacingX, heights[std::size_t{row} * columns + column], z * spacingZ};
}

TriangleMesh trianglesOf(const HeightField& field) {
  TriangleMesh mesh;
  for (std::uint32_t row = 0; row < field.rows; ++row) {
    for (std::uint32_t column = 0; column < field.columns; ++column) {
      mesh.vertices.push_back(field.point(column, row));
    }
  }
  for (std::uint32_t row = 0; row + 1 < field.rows; ++row) {
    for (std::uint32_t column = 0; column + 1 < field.columns; ++column) {
      const std::uint32_t corner = row * field.columns + column;
      const std::uint32_t across = corner + field.columns;
      mesh.triangles.push_back({corner, across, corner + 1});
      mesh.triangles.push_back({corner + 1, across, across + 1});
    }
  }
  return mesh;
}

}  // namespace scatter
