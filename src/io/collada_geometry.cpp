#include "io/collada_geometry.h"

#include <algorithm>
#include <array>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <utility>

namespace scatter::io {
namespace {

/// Where an accessor finds its triples in the array.
struct Layout {
  std::size_t count = 0;
  std::size_t stride = 3;
  std::size_t offset = 0;
};

Result<Layout> readLayout(const ColladaFrame& frame, const pugi::xml_node& source, std::size_t values) {
  const pugi::xml_node accessor = source.child("technique_common").child("accessor");
  if (!accessor) {
    return Layout{values / 3, 3, 0};
  }
  std::array<std::uint32_t, 3> numbers{0, 1, 0};
  constexpr std::array kNames{"count", "stride", "offset"};
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    const auto value = frame.indexAttribute(accessor, kNames[i], numbers[i]);
    if (!value) {
      return tl::unexpected(value.error());
    }
    numbers[i] = *value;
  }
  const Layout layout{numbers[0], numbers[1], numbers[2]};
  if (layout.stride < 3) {
    return frame.xml().failAt(accessor, "stride should be at least 3, for x, y and z");
  }
  const std::size_t used = layout.offset + layout.count * layout.stride;
  if (layout.count > 0 && used > values) {
    return frame.xml().failAt(accessor, "reads " + std::to_string(used) + " numbers, but the array holds " +
                                            std::to_string(values));
  }
  return layout;
}

Result<std::vector<float>> readArray(const ColladaFrame& frame, const pugi::xml_node& source) {
  const auto array = frame.xml().child(source, "float_array", "positions are read from one");
  if (!array) {
    return tl::unexpected(array.error());
  }
  const auto count = frame.indexAttribute(*array, "count", 0);
  if (!count) {
    return tl::unexpected(count.error());
  }
  return frame.lengths(*array, *count);
}

/// Of a `<mesh>` or `<convex_mesh>`, through `<vertices>`, its POSITION input and the accessor.
Result<std::vector<Vec3>> readPositions(const ColladaFrame& frame, const pugi::xml_node& mesh) {
  const auto vertices = frame.xml().child(mesh, "vertices", "positions are read from it");
  if (!vertices) {
    return tl::unexpected(vertices.error());
  }
  const pugi::xml_node input = vertices->find_child_by_attribute("input", "semantic", "POSITION");
  if (!input) {
    return frame.xml().failAt(*vertices, "has no <input> with semantic POSITION");
  }
  const auto source = frame.xml().follow(input, "source", "source");
  if (!source) {
    return tl::unexpected(source.error());
  }
  const auto values = readArray(frame, *source);
  if (!values) {
    return tl::unexpected(values.error());
  }
  const auto layout = readLayout(frame, *source, values->size());
  if (!layout) {
    return tl::unexpected(layout.error());
  }
  std::vector<Vec3> positions(layout->count);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const std::size_t at = layout->offset + i * layout->stride;
    positions[i] = Vec3((*values)[at], (*values)[at + 1], (*values)[at + 2]);
  }
  return positions;
}

/// The position indices of a primitive's `<p>`, without those of normals and other inputs.
Result<std::vector<std::uint32_t>> readCorners(const ColladaFrame& frame, const pugi::xml_node& primitive,
                                               std::size_t vertexCount) {
  std::uint32_t stride = 1;
  for (const pugi::xml_node& input : primitive.children("input")) {
    const auto offset = frame.indexAttribute(input, "offset", 0);
    if (!offset || *offset > 64) {
      return offset ? frame.xml().failAt(input, "offset is larger than 64") : tl::unexpected(offset.error());
    }
    stride = std::max(stride, *offset + 1);
  }
  const pugi::xml_node vertexInput = primitive.find_child_by_attribute("input", "semantic", "VERTEX");
  if (!vertexInput) {
    return frame.xml().failAt(primitive, "has no <input> with semantic VERTEX");
  }
  const std::uint32_t first = frame.indexAttribute(vertexInput, "offset", 0).value_or(0);
  const auto all = frame.indices(primitive.child("p"));
  if (!all) {
    return tl::unexpected(all.error());
  }
  if (all->size() % stride != 0) {
    return frame.xml().failAt(primitive, "<p> should hold a multiple of " + std::to_string(stride) +
                                             " indices, but holds " + std::to_string(all->size()));
  }
  std::vector<std::uint32_t> corners;
  for (std::size_t i = first; i < all->size(); i += stride) {
    if ((*all)[i] >= vertexCount) {
      return frame.xml().failAt(primitive, "index " + std::to_string((*all)[i]) + " is beyond the " +
                                               std::to_string(vertexCount) + " vertices");
    }
    corners.push_back((*all)[i]);
  }
  return corners;
}

Result<void> addTriangles(const ColladaFrame& frame, const pugi::xml_node& primitive, VisualMesh& mesh) {
  const auto corners = readCorners(frame, primitive, mesh.vertices.size());
  if (!corners) {
    return tl::unexpected(corners.error());
  }
  if (corners->size() % 3 != 0) {
    return frame.xml().failAt(primitive, "should hold three corners a triangle, but holds " +
                                             std::to_string(corners->size()) + " corners");
  }
  for (std::size_t i = 0; i < corners->size(); i += 3) {
    mesh.triangles.push_back({(*corners)[i], (*corners)[i + 1], (*corners)[i + 2]});
  }
  return {};
}

Result<void> addPolygons(const ColladaFrame& frame, const pugi::xml_node& primitive, VisualMesh& mesh) {
  const auto corners = readCorners(frame, primitive, mesh.vertices.size());
  if (!corners) {
    return tl::unexpected(corners.error());
  }
  const auto sizes = frame.indices(primitive.child("vcount"));
  if (!sizes) {
    return tl::unexpected(sizes.error());
  }
  std::size_t begin = 0;
  for (const std::uint32_t size : *sizes) {
    if (size > corners->size() - begin) {
      return frame.xml().failAt(primitive, "<vcount> asks for more corners than <p> holds");
    }
    for (std::size_t i = 2; i < size; ++i) {
      mesh.triangles.push_back({(*corners)[begin], (*corners)[begin + i - 1], (*corners)[begin + i]});
    }
    begin += size;
  }
  return {};
}

Result<void> addPrimitive(const ColladaFrame& frame, const pugi::xml_node& primitive, VisualMesh& mesh) {
  const std::string_view kind = primitive.name();
  if (kind == "triangles") {
    return addTriangles(frame, primitive, mesh);
  }
  if (kind == "polylist") {
    return addPolygons(frame, primitive, mesh);
  }
  if (kind == "polygons" || kind == "tristrips" || kind == "trifans") {
    return frame.xml().failAt(primitive, "is not supported; export the mesh as triangles");
  }
  return {};
}

}  // namespace

Result<std::vector<Vec3>> readConvexMesh(const ColladaFrame& frame, const pugi::xml_node& geometry) {
  const auto convex = frame.xml().child(geometry, "convex_mesh", "only convex geometry can be a shape");
  if (!convex) {
    return tl::unexpected(convex.error());
  }
  if (!convex->attribute("convex_hull_of")) {
    return readPositions(frame, *convex);
  }
  const auto original = frame.xml().follow(*convex, "convex_hull_of", "geometry");
  if (!original) {
    return tl::unexpected(original.error());
  }
  const auto mesh = frame.xml().child(*original, "mesh", "convex_hull_of needs one");
  if (!mesh) {
    return tl::unexpected(mesh.error());
  }
  return readPositions(frame, *mesh);
}

Result<VisualMesh> readMesh(const ColladaFrame& frame, const pugi::xml_node& mesh) {
  auto positions = readPositions(frame, mesh);
  if (!positions) {
    return tl::unexpected(positions.error());
  }
  VisualMesh result;
  result.vertices = std::move(*positions);
  for (Vec3& vertex : result.vertices) {
    vertex = frame.toYUp() * vertex;
  }
  for (const pugi::xml_node& child : mesh.children()) {
    if (const auto added = addPrimitive(frame, child, result); !added) {
      return tl::unexpected(added.error());
    }
  }
  return result;
}

}  // namespace scatter::io
