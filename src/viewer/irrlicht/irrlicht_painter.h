#pragma once

#include <CDynamicMeshBuffer.h>
#include <IVideoDriver.h>

#include <map>
#include <vector>

#include "viewer/drawing/draw_list.h"
#include "viewer/drawing/mesh_lod.h"
#include "viewer/drawing/scenery_geometry.h"
#include "viewer/irrlicht/irrlicht_pointer.h"
#include "viewer/irrlicht/irrlicht_shading.h"

namespace scatter::viewer {

/// Draws views with an Irrlicht driver. The one place that knows that Irrlicht is left-handed: it is given
/// matrices of OpenGL's kind, which its driver hands through, and what it calls front faces are culled.
class IrrlichtPainter {
 public:
  /// `driver` must live longer. `isReady()` tells whether it could do what is asked of it.
  explicit IrrlichtPainter(irr::video::IVideoDriver& driver);

  [[nodiscard]] bool isReady() const { return shading_.isReady(); }

  [[nodiscard]] MeshId addMesh(const MeshData& mesh);
  void removeMesh(MeshId mesh);

  /// Between the driver's beginScene and endScene.
  void draw(const View& view, const glm::ivec2& window, DrawStatistics& statistics);

  /// Leaves the driver in the state that other code expects: whole window, no shader.
  void finish(const glm::ivec2& window);

 private:
  using Buffer = IrrlichtPointer<irr::scene::CDynamicMeshBuffer>;
  struct Mesh {
    MeshOutline outline{};
    bool twoSided = false;
    std::vector<Buffer> details{};  ///< As in the outline.
  };

  void setCamera(const View& view, const PixelArea& pixels);
  void drawSurroundings(const View& view, const DrawList& list);
  void drawItem(const DrawCall& call, bool shadowed = false);
  void drawShadow(const ShadowCall& call);
  void drawPainted(const PaintedMesh& mesh, irr::scene::E_PRIMITIVE_TYPE type,
                   const irr::video::SMaterial& material);
  void drawLines(const View& view, const std::vector<Line>& lines, bool onTop);

  irr::video::IVideoDriver& driver_;
  IrrlichtShading shading_;
  std::map<MeshId, Mesh> meshes_;
  std::uint32_t nextMesh_ = 0;
  ShadowMap shadows_;
  std::vector<irr::video::S3DVertex> scratch_;  ///< Kept to save allocations.
};

}  // namespace scatter::viewer
