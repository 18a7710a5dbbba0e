#pragma once

#include <OgreHardwareIndexBuffer.h>
#include <OgreHardwareVertexBuffer.h>
#include <OgreVertexIndexData.h>

#include <map>
#include <memory>
#include <vector>

#include "viewer/drawing/draw_list.h"
#include "viewer/drawing/mesh_lod.h"
#include "viewer/drawing/scenery_geometry.h"
#include "viewer/ogre/ogre_shading.h"

namespace scatter::viewer {

/// Vertices and indices as Ogre draws them.
struct OgreGeometry {
  std::unique_ptr<Ogre::VertexData> vertices{};
  std::unique_ptr<Ogre::IndexData> indices{};

  [[nodiscard]] Ogre::RenderOperation operation(Ogre::RenderOperation::OperationType type) const;
};

/// Draws views with Ogre, at once and without nodes or entities.
class OgrePainter {
 public:
  /// Throws Ogre::Exception if there are no shaders.
  explicit OgrePainter(Ogre::SceneManager& scene);

  [[nodiscard]] MeshId addMesh(const MeshData& mesh);
  void removeMesh(MeshId mesh) { meshes_.erase(mesh); }

  /// In a frame of the render system. `viewport` may be moved about in its window.
  void draw(const View& view, Ogre::Viewport& viewport, const glm::ivec2& window, DrawStatistics& statistics);

 private:
  struct Mesh {
    MeshOutline outline{};
    bool twoSided = false;
    std::vector<OgreGeometry> details{};  ///< As in the outline.
  };

  void drawSurroundings(const View& view, const DrawList& list);
  void drawItem(const DrawCall& call, bool shadowed = false);
  void drawShadow(const ShadowCall& call);
  void drawPainted(const PaintedMesh& mesh, Ogre::RenderOperation::OperationType type,
                   const OgreState& state);

  OgreShading shading_;
  std::map<MeshId, Mesh> meshes_;
  std::uint32_t nextMesh_ = 0;
  ShadowMap shadows_;
  OgreGeometry stream_;  ///< For painted meshes, one after the other.
};

}  // namespace scatter::viewer
