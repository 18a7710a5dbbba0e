#include "viewer/irrlicht/irrlicht_painter.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>

namespace scatter::viewer {

namespace video = irr::video;
namespace scene = irr::scene;

namespace {

irr::core::matrix4 toIrrlicht(const glm::mat4& matrix) {
  // Irrlicht's rows in memory are OpenGL's columns.
  irr::core::matrix4 result(irr::core::matrix4::EM4CONST_NOTHING);
  result.setM(glm::value_ptr(matrix));
  return result;
}

irr::core::vector3df toIrrlicht(const Vec3& vector) {
  return {vector.x, vector.y, vector.z};
}

irr::u32 toByte(float share) {
  return static_cast<irr::u32>(std::lround(255.0F * std::clamp(share, 0.0F, 1.0F)));
}

video::SColor toIrrlicht(const Color& color) {
  return {toByte(color.a), toByte(color.r), toByte(color.g), toByte(color.b)};
}

video::S3DVertex vertexOf(const MeshData& mesh, std::size_t i) {
  const glm::vec3 color = mesh.colors.empty() ? glm::vec3(1.0F) : mesh.colors[i];
  const float open = mesh.occlusion.empty() ? 1.0F : 1.0F - mesh.occlusion[i];
  return {toIrrlicht(mesh.positions[i]), toIrrlicht(mesh.normals[i]), toIrrlicht(Color(color, open)), {}};
}

IrrlichtPointer<scene::CDynamicMeshBuffer> bufferOf(const MeshData& mesh) {
  const auto indexType = mesh.positions.size() <= 65536 ? video::EIT_16BIT : video::EIT_32BIT;
  IrrlichtPointer<scene::CDynamicMeshBuffer> buffer(
      new scene::CDynamicMeshBuffer(video::EVT_STANDARD, indexType));
  buffer->getVertexBuffer().reallocate(static_cast<irr::u32>(mesh.positions.size()));
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    buffer->getVertexBuffer().push_back(vertexOf(mesh, i));
  buffer->getIndexBuffer().reallocate(static_cast<irr::u32>(mesh.indices.size()));
  for (const std::uint32_t index : mesh.indices) buffer->getIndexBuffer().push_back(index);
  buffer->setHardwareMappingHint(scene::EHM_STATIC);
  return buffer;
}

video::SMaterial paintMaterial(bool blended, bool depthTested, bool depthWritten) {
  video::SMaterial material;
  material.MaterialType = blended ? video::EMT_TRANSPARENT_VERTEX_ALPHA : video::EMT_SOLID;
  material.Lighting = false;
  material.BackfaceCulling = false;
  // The lowest value turns the test off.
  material.ZBuffer = static_cast<irr::u8>(depthTested ? video::ECFN_LESSEQUAL : video::ECFN_NEVER);
  material.ZWriteEnable = depthWritten;
  return material;
}

}  // namespace

IrrlichtPainter::IrrlichtPainter(video::IVideoDriver& driver) : driver_(driver), shading_(driver) {
  driver_.setMinHardwareBufferVertexCount(0);
}

MeshId IrrlichtPainter::addMesh(const MeshData& mesh) {
  const std::vector<MeshDetail> details = makeDetails(mesh);
  const auto id = MeshId{nextMesh_++};
  Mesh& added = meshes_[id];
  added.outline = outlineOf(details);
  added.twoSided = mesh.twoSided;
  for (const MeshDetail& detail : details) added.details.push_back(bufferOf(detail.mesh));
  return id;
}

void IrrlichtPainter::removeMesh(MeshId mesh) {
  const auto found = meshes_.find(mesh);
  if (found == meshes_.end()) return;
  for (const auto& buffer : found->second.details) driver_.removeHardwareBuffer(buffer.get());
  meshes_.erase(found);
}

void IrrlichtPainter::draw(const View& view, const glm::ivec2& window, DrawStatistics& statistics) {
  const auto outlineOf = [this](MeshId mesh) -> const MeshOutline& { return meshes_.at(mesh).outline; };
  const PixelArea pixels = pixelsOf(view.area, window);
  const DrawList list = listDraws(view, pixels, outlineOf);
  count(view, list, outlineOf, statistics);
  setCamera(view, pixels);
  drawSurroundings(view, list);
  const bool shadowed = shadows_.draw(view, pixels, list, outlineOf) &&
                        shading_.setShadows(shadows_, shadowsOf(view, shadows_));
  for (const DrawCall& call : list.solid) drawItem(call, shadowed);
  drawLines(view, view.lines, false);
  for (const DrawCall& call : list.seeThrough) drawItem(call);
  drawLines(view, view.linesOnTop, true);
}

void IrrlichtPainter::finish(const glm::ivec2& window) {
  driver_.setViewPort({0, 0, window.x, window.y});
  // Drawing in two dimensions makes the driver leave the shader.
  driver_.draw2DRectangle(video::SColor(0, 0, 0, 0), irr::core::recti(0, 0, 1, 1));
}

void IrrlichtPainter::setCamera(const View& view, const PixelArea& pixels) {
  driver_.setViewPort({pixels.left, pixels.top, pixels.left + pixels.width, pixels.top + pixels.height});
  // A view may lie over another.
  driver_.clearZBuffer();
  const float aspect = static_cast<float>(pixels.width) / static_cast<float>(pixels.height);
  driver_.setTransform(video::ETS_PROJECTION, toIrrlicht(projectionMatrix(view.camera, aspect)));
  driver_.setTransform(video::ETS_VIEW, toIrrlicht(viewMatrix(view.camera)));
  shading_.setLight(lightOf(view));
}

void IrrlichtPainter::drawSurroundings(const View& view, const DrawList& list) {
  drawPainted(skyDome(view), scene::EPT_TRIANGLES, paintMaterial(false, false, false));
  video::SMaterial starMaterial = paintMaterial(true, false, false);
  starMaterial.Thickness = kStarPixels;
  drawPainted(stars(view), scene::EPT_POINTS, starMaterial);
  drawPainted(ground(view), scene::EPT_TRIANGLES, paintMaterial(false, true, true));
  for (const DrawCall& call : list.floors) drawItem(call);
  // Only ground and floor are there yet: what lies on it needs no depth test, and cannot flicker against it.
  for (const ShadowCall& call : list.shadows) drawShadow(call);
  drawPainted(groundGrid(view), scene::EPT_LINES, paintMaterial(true, false, false));
}

void IrrlichtPainter::drawItem(const DrawCall& call, bool shadowed) {
  const Item& item = *call.item;
  const Mesh& mesh = meshes_.at(item.mesh);
  shading_.setLook({item.color, item.glow, 0.0F, mesh.twoSided ? 1.0F : 0.0F});
  driver_.setTransform(video::ETS_WORLD, toIrrlicht(call.model));
  driver_.setMaterial(shadowed && !item.wireframe
                          ? shading_.shadowedMaterial(mesh.twoSided)
                          : shading_.material(item.color.a >= 1.0F, item.wireframe, mesh.twoSided));
  driver_.drawMeshBuffer(mesh.details[call.detail].get());
}

void IrrlichtPainter::drawShadow(const ShadowCall& call) {
  shading_.setLook({Color(call.color, 1.0F), 0.0F, 1.0F, 0.0F});
  driver_.setTransform(video::ETS_WORLD, toIrrlicht(call.model));
  video::SMaterial material = shading_.material(true, false, true);
  material.ZBuffer = video::ECFN_NEVER;
  material.ZWriteEnable = false;
  driver_.setMaterial(material);
  driver_.drawMeshBuffer(meshes_.at(call.item->mesh).details[call.detail].get());
}

void IrrlichtPainter::drawPainted(const PaintedMesh& mesh, scene::E_PRIMITIVE_TYPE type,
                                  const video::SMaterial& material) {
  if (mesh.indices.empty()) return;
  scratch_.clear();
  for (const PaintedVertex& vertex : mesh.vertices)
    scratch_.emplace_back(toIrrlicht(vertex.position), irr::core::vector3df(), toIrrlicht(vertex.color),
                          irr::core::vector2df());
  const std::size_t each = type == scene::EPT_TRIANGLES ? 3 : (type == scene::EPT_LINES ? 2 : 1);
  driver_.setTransform(video::ETS_WORLD, irr::core::IdentityMatrix);
  driver_.setMaterial(material);
  driver_.drawVertexPrimitiveList(scratch_.data(), static_cast<irr::u32>(scratch_.size()),
                                  mesh.indices.data(), static_cast<irr::u32>(mesh.indices.size() / each),
                                  video::EVT_STANDARD, type, video::EIT_32BIT);
}

void IrrlichtPainter::drawLines(const View& view, const std::vector<Line>& lines, bool onTop) {
  video::SMaterial material = paintMaterial(true, !onTop, false);
  material.Thickness = view.lineWidth;
  drawPainted(paint(lines), scene::EPT_LINES, material);
}

}  // namespace scatter::viewer
