#pragma once

#include <array>
#include <glm/geometric.hpp>

#include "viewer/renderer.h"

namespace scatter::test {

/// Two triangles of a quadrilateral, counter-clockwise.
inline void addQuad(viewer::MeshData& mesh, const std::array<Vec3, 4>& corners) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const Vec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
  for (const Vec3& corner : corners) {
    mesh.positions.push_back(corner);
    mesh.normals.push_back(normal);
  }
  for (const std::uint32_t index : {0U, 1U, 2U, 0U, 2U, 3U}) mesh.indices.push_back(first + index);
}

/// A box with sharp edges around the origin.
inline viewer::MeshData boxMesh(const Vec3& half = Vec3(0.5F)) {
  viewer::MeshData mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0F, 1.0F}) {
      Vec3 out(0.0F);
      Vec3 u(0.0F);
      Vec3 v(0.0F);
      out[axis] = side;
      u[(axis + 1) % 3] = side;
      v[(axis + 2) % 3] = 1.0F;
      addQuad(mesh, {half * (out - u - v), half * (out + u - v), half * (out + u + v), half * (out - u + v)});
    }
  }
  return mesh;
}

/// A square of side 1 in the plane z = 0, seen from +z.
inline viewer::MeshData squareMesh() {
  viewer::MeshData mesh;
  addQuad(mesh, {Vec3(-0.5F, -0.5F, 0.0F), Vec3(0.5F, -0.5F, 0.0F), Vec3(0.5F, 0.5F, 0.0F),
                 Vec3(-0.5F, 0.5F, 0.0F)});
  return mesh;
}

}  // namespace scatter::test
