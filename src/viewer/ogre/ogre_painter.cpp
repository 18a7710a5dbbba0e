#include "viewer/ogre/ogre_painter.h"

#include <Ogre.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace scatter::viewer {

namespace {

using Bytes = std::array<std::uint8_t, 4>;

/// As the shader sees an item's vertex.
struct LitVertex {
  Vec3 position;
  Vec3 normal;
  Bytes color;  ///< Alpha is 1 - occlusion.
};

/// As the shader sees a painted vertex.
struct FlatVertex {
  Vec3 position;
  Bytes color;
};

Bytes toBytes(const Color& color) {
  const auto byte = [](float share) {
    return static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(share, 0.0F, 1.0F)));
  };
  return {byte(color.r), byte(color.g), byte(color.b), byte(color.a)};
}

OgreGeometry makeGeometry(bool lit) {
  OgreGeometry geometry{std::make_unique<Ogre::VertexData>(), std::make_unique<Ogre::IndexData>()};
  Ogre::VertexDeclaration& declaration = *geometry.vertices->vertexDeclaration;
  std::size_t offset = 0;
  offset += declaration.addElement(0, offset, Ogre::VET_FLOAT3, Ogre::VES_POSITION).getSize();
  if (lit) offset += declaration.addElement(0, offset, Ogre::VET_FLOAT3, Ogre::VES_NORMAL).getSize();
  declaration.addElement(0, offset, Ogre::VET_UBYTE4_NORM, Ogre::VES_DIFFUSE);
  return geometry;
}

/// Copies into the geometry's buffers, which are made or grown if need be.
template <class Vertex>
void fill(OgreGeometry& geometry, const std::vector<Vertex>& vertices,
          const std::vector<std::uint32_t>& indices, Ogre::HardwareBufferUsage usage) {
  auto& manager = Ogre::HardwareBufferManager::getSingleton();
  Ogre::VertexBufferBinding& binding = *geometry.vertices->vertexBufferBinding;
  if (!binding.isBufferBound(0) || binding.getBuffer(0)->getNumVertices() < vertices.size())
    binding.setBinding(0, manager.createVertexBuffer(sizeof(Vertex), vertices.size(), usage));
  auto& indexBuffer = geometry.indices->indexBuffer;
  if (!indexBuffer || indexBuffer->getNumIndexes() < indices.size())
    indexBuffer = manager.createIndexBuffer(Ogre::HardwareIndexBuffer::IT_32BIT, indices.size(), usage);
  binding.getBuffer(0)->writeData(0, sizeof(Vertex) * vertices.size(), vertices.data(), true);
  indexBuffer->writeData(0, sizeof(std::uint32_t) * indices.size(), indices.data(), true);
  geometry.vertices->vertexCount = vertices.size();
  geometry.indices->indexCount = indices.size();
}

OgreGeometry geometryOf(const MeshData& mesh) {
  std::vector<LitVertex> vertices;
  vertices.reserve(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::vec3 color = mesh.colors.empty() ? glm::vec3(1.0F) : mesh.colors[i];
    const float open = mesh.occlusion.empty() ? 1.0F : 1.0F - mesh.occlusion[i];
    vertices.push_back({mesh.positions[i], mesh.normals[i], toBytes(Color(color, open))});
  }
  OgreGeometry geometry = makeGeometry(true);
  if (!mesh.indices.empty()) fill(geometry, vertices, mesh.indices, Ogre::HBU_GPU_ONLY);
  return geometry;
}

}  // namespace

Ogre::RenderOperation OgreGeometry::operation(Ogre::RenderOperation::OperationType type) const {
  Ogre::RenderOperation operation;
  operation.operationType = type;
  operation.vertexData = vertices.get();
  operation.indexData = indices.get();
  operation.useIndexes = true;
  return operation;
}

OgrePainter::OgrePainter(Ogre::SceneManager& scene) : shading_(scene), stream_(makeGeometry(false)) {}

MeshId OgrePainter::addMesh(const MeshData& mesh) {
  const std::vector<MeshDetail> details = makeDetails(mesh);
  const auto id = MeshId{nextMesh_++};
  Mesh& added = meshes_[id];
  added.outline = outlineOf(details);
  added.twoSided = mesh.twoSided;
  for (const MeshDetail& detail : details) added.details.push_back(geometryOf(detail.mesh));
  return id;
}

void OgrePainter::draw(const View& view, Ogre::Viewport& viewport, const glm::ivec2& window,
                       DrawStatistics& statistics) {
  const auto outlineOf = [this](MeshId mesh) -> const MeshOutline& { return meshes_.at(mesh).outline; };
  const PixelArea pixels = pixelsOf(view.area, window);
  const DrawList list = listDraws(view, pixels, outlineOf);
  count(view, list, outlineOf, statistics);

  // Ogre rounds down.
  const auto share = [](int pixel, int length) {
    return (static_cast<float>(pixel) + 0.5F) / static_cast<float>(length);
  };
  viewport.setDimensions(share(pixels.left, window.x), share(pixels.top, window.y),
                         share(pixels.width, window.x), share(pixels.height, window.y));
  Ogre::RenderSystem& system = *Ogre::Root::getSingleton().getRenderSystem();
  system._setViewport(&viewport);
  system.clearFrameBuffer(Ogre::FBT_COLOUR | Ogre::FBT_DEPTH, Ogre::ColourValue::Black);
  const float aspect = static_cast<float>(pixels.width) / static_cast<float>(pixels.height);
  shading_.setCamera(viewMatrix(view.camera), projectionMatrix(view.camera, aspect), lightOf(view));

  drawSurroundings(view, list);
  const bool shadowed = shadows_.draw(view, pixels, list, outlineOf) &&
                        shading_.setShadows(shadows_, shadowsOf(view, shadows_));
  for (const DrawCall& call : list.solid) drawItem(call, shadowed);
  OgreState lines;
  lines.blended = true;
  lines.depthWritten = false;
  lines.lineWidth = view.lineWidth;
  drawPainted(paint(view.lines), Ogre::RenderOperation::OT_LINE_LIST, lines);
  for (const DrawCall& call : list.seeThrough) drawItem(call);
  lines.depthTested = false;
  drawPainted(paint(view.linesOnTop), Ogre::RenderOperation::OT_LINE_LIST, lines);
}

void OgrePainter::drawSurroundings(const View& view, const DrawList& list) {
  OgreState behind;
  behind.depthTested = behind.depthWritten = false;
  drawPainted(skyDome(view), Ogre::RenderOperation::OT_TRIANGLE_LIST, behind);
  OgreState over = behind;
  over.blended = true;
  over.lineWidth = kStarPixels;
  drawPainted(stars(view), Ogre::RenderOperation::OT_POINT_LIST, over);
  drawPainted(ground(view), Ogre::RenderOperation::OT_TRIANGLE_LIST, {});
  for (const DrawCall& call : list.floors) drawItem(call);
  // Only ground and floor are there yet: what lies on it needs no depth test, and cannot flicker against it.
  for (const ShadowCall& call : list.shadows) drawShadow(call);
  over.lineWidth = 1.0F;
  drawPainted(groundGrid(view), Ogre::RenderOperation::OT_LINE_LIST, over);
}

void OgrePainter::drawItem(const DrawCall& call, bool shadowed) {
  const Item& item = *call.item;
  const Mesh& mesh = meshes_.at(item.mesh);
  OgreState state;
  state.blended = item.color.a < 1.0F;
  state.depthWritten = !state.blended;
  state.culled = !item.wireframe && !mesh.twoSided;
  state.wireframe = item.wireframe;
  state.shadowed = shadowed && !item.wireframe;
  if (mesh.outline.triangles[call.detail] == 0) return;
  auto operation = mesh.details[call.detail].operation(Ogre::RenderOperation::OT_TRIANGLE_LIST);
  shading_.drawItem(operation, call.model, {item.color, item.glow, 0.0F, mesh.twoSided ? 1.0F : 0.0F}, state);
}

void OgrePainter::drawShadow(const ShadowCall& call) {
  const Mesh& mesh = meshes_.at(call.item->mesh);
  if (mesh.outline.triangles[call.detail] == 0) return;
  OgreState state;
  state.depthTested = state.depthWritten = false;
  auto operation = mesh.details[call.detail].operation(Ogre::RenderOperation::OT_TRIANGLE_LIST);
  shading_.drawItem(operation, call.model, {Color(call.color, 1.0F), 0.0F, 1.0F, 0.0F}, state);
}

void OgrePainter::drawPainted(const PaintedMesh& mesh, Ogre::RenderOperation::OperationType type,
                              const OgreState& state) {
  if (mesh.indices.empty()) return;
  std::vector<FlatVertex> vertices;
  vertices.reserve(mesh.vertices.size());
  for (const PaintedVertex& vertex : mesh.vertices)
    vertices.push_back({vertex.position, toBytes(vertex.color)});
  fill(stream_, vertices, mesh.indices, Ogre::HBU_CPU_TO_GPU);
  auto operation = stream_.operation(type);
  shading_.drawPainted(operation, state);
}

}  // namespace scatter::viewer
