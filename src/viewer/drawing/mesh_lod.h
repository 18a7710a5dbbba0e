#pragma once

#include <vector>

#include "viewer/renderer.h"

namespace scatter::viewer {

/// A mesh at one detail.
struct MeshDetail {
  MeshData mesh{};
  float error = 0.0F;  ///< Metres by which its surface differs from the mesh's.
};

/// A mesh with all vertices of a cell of a cubic grid drawn together into their mean, and the triangles that
/// this flattens left out (vertex clustering). No point moves further than a cell's diagonal. Normals that
/// point to different sides stay apart, so that edges stay sharp.
[[nodiscard]] MeshDetail clusterVertices(const MeshData& mesh, float cell);

/// The mesh and coarser versions of it, finest first. A version that would save little is left out.
[[nodiscard]] std::vector<MeshDetail> makeDetails(const MeshData& mesh);

/// What of a mesh makes its shadow.
struct ShadowMesh {
  std::vector<Vec3> positions{};
  std::vector<std::uint32_t> indices{};
  bool twoSided = false;
};

/// What a renderer must know of a mesh to choose what to draw, and to draw its shadow.
struct MeshOutline {
  Vec3 center{0.0F};                     ///< Of a sphere around it,
  float radius = 0.0F;                   ///< and its radius.
  std::vector<float> errors{};           ///< Of each detail, finest first.
  std::vector<std::size_t> triangles{};  ///< Of each detail.
  std::vector<ShadowMesh> shadows{};     ///< Of each detail.
};

[[nodiscard]] MeshOutline outlineOf(const std::vector<MeshDetail>& details);

}  // namespace scatter::viewer
