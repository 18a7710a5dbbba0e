#include "io/collada/primitives.h"

#include <algorithm>
#include <array>
#include <pugixml.hpp>
#include <span>
#include <string>
#include <string_view>

namespace scatter::io {
namespace {

using Corners = std::vector<std::uint32_t>;

/// Which of the indices of a corner is that of its position.
struct CornerLayout {
  std::uint32_t stride = 1;
  std::uint32_t first = 0;
};

Result<CornerLayout> readCornerLayout(const ColladaFrame& frame, const pugi::xml_node& primitive) {
  CornerLayout layout;
  for (const pugi::xml_node& input : primitive.children("input")) {
    const auto offset = frame.indexAttribute(input, "offset", 0);
    if (!offset || *offset > 64) {
      return offset ? frame.xml().failAt(input, "offset is larger than 64") : tl::unexpected(offset.error());
    }
    layout.stride = std::max(layout.stride, *offset + 1);
  }
  const pugi::xml_node vertexInput = primitive.find_child_by_attribute("input", "semantic", "VERTEX");
  if (!vertexInput) {
    return frame.xml().failAt(primitive, "has no <input> with semantic VERTEX; export the mesh as triangles");
  }
  layout.first = frame.indexAttribute(vertexInput, "offset", 0).value_or(0);
  return layout;
}

/// The position indices of a `<p>`, without those of normals and other inputs.
Result<Corners> readCorners(const ColladaFrame& frame, const pugi::xml_node& primitive,
                            const pugi::xml_node& p, const CornerLayout& layout, std::size_t vertexCount) {
  const auto all = frame.indices(p);
  if (!all) {
    return tl::unexpected(all.error());
  }
  if (all->size() % layout.stride != 0) {
    return frame.xml().failAt(primitive, "<p> should hold a multiple of " + std::to_string(layout.stride) +
                                             " indices, but holds " + std::to_string(all->size()));
  }
  Corners corners;
  for (std::size_t i = layout.first; i < all->size(); i += layout.stride) {
    if ((*all)[i] >= vertexCount) {
      return frame.xml().failAt(primitive, "index " + std::to_string((*all)[i]) + " is beyond the " +
                                               std::to_string(vertexCount) + " vertices");
    }
    corners.push_back((*all)[i]);
  }
  return corners;
}

void addFan(std::span<const std::uint32_t> corners, VisualMesh& mesh) {
  for (std::size_t i = 2; i < corners.size(); ++i) {
    mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
  }
}

/// Every second triangle of a strip is turned round, so that all face the same way.
void addStrip(std::span<const std::uint32_t> corners, VisualMesh& mesh) {
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const std::size_t odd = i % 2;
    mesh.triangles.push_back({corners[i - 2 + odd], corners[i - 1 - odd], corners[i]});
  }
}

Result<void> addTriangles(const ColladaFrame& frame, const pugi::xml_node& primitive,
                          const CornerLayout& layout, VisualMesh& mesh) {
  const auto corners = readCorners(frame, primitive, primitive.child("p"), layout, mesh.vertices.size());
  if (!corners) {
    return tl::unexpected(corners.error());
  }
  if (corners->size() % 3 != 0) {
    return frame.xml().failAt(primitive, "should hold three corners a triangle, but holds " +
                                             std::to_string(corners->size()) + " corners");
  }
  for (std::size_t i = 0; i < corners->size(); i += 3) {
    addFan(std::span(*corners).subspan(i, 3), mesh);
  }
  return {};
}

Result<void> addPolygonList(const ColladaFrame& frame, const pugi::xml_node& primitive,
                            const CornerLayout& layout, VisualMesh& mesh) {
  const auto corners = readCorners(frame, primitive, primitive.child("p"), layout, mesh.vertices.size());
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
    addFan(std::span(*corners).subspan(begin, size), mesh);
    begin += size;
  }
  return {};
}

/// Primitives that have a `<p>` for each of their pieces.
Result<void> addPieces(const ColladaFrame& frame, const pugi::xml_node& primitive, const CornerLayout& layout,
                       VisualMesh& mesh) {
  const bool strips = std::string_view(primitive.name()) == "tristrips";
  for (const pugi::xml_node& child : primitive.children()) {
    const std::string_view name = child.name();
    if (name == "ph") {
      frame.note(child, "holes are not supported; the polygon is taken without them");
    } else if (name != "p") {
      continue;
    }
    const pugi::xml_node p = name == "ph" ? child.child("p") : child;
    const auto corners = readCorners(frame, primitive, p, layout, mesh.vertices.size());
    if (!corners) {
      return tl::unexpected(corners.error());
    }
    strips ? addStrip(*corners, mesh) : addFan(*corners, mesh);
  }
  return {};
}

struct PrimitiveReader {
  const char* element;
  Result<void> (*add)(const ColladaFrame& frame, const pugi::xml_node& primitive, const CornerLayout& layout,
                      VisualMesh& mesh);
};

constexpr std::array<PrimitiveReader, 5> kPrimitiveReaders{{{"triangles", addTriangles},
                                                            {"polylist", addPolygonList},
                                                            {"polygons", addPieces},
                                                            {"tristrips", addPieces},
                                                            {"trifans", addPieces}}};

}  // namespace

Result<void> addPrimitive(const ColladaFrame& frame, const pugi::xml_node& primitive, VisualMesh& mesh) {
  const std::string_view kind = primitive.name();
  for (const PrimitiveReader& reader : kPrimitiveReaders) {
    if (kind == reader.element) {
      return readCornerLayout(frame, primitive).and_then([&](const CornerLayout& layout) {
        return reader.add(frame, primitive, layout, mesh);
      });
    }
  }
  if (kind == "lines" || kind == "linestrips") {
    frame.note(primitive, "has no triangles and is not shown");
  }
  return {};
}

}  // namespace scatter::io
