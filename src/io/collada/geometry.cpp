#include "io/collada/geometry.h"

#include <array>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "io/collada/primitives.h"

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
  auto values = frame.lengths(*array, 0);
  const auto count = frame.indexAttribute(*array, "count", 0);
  if (!values || !count) {
    return tl::unexpected(values ? count.error() : values.error());
  }
  if (*count != 0 && *count != values->size()) {
    const std::string what =
        "should hold " + std::to_string(*count) + " numbers, but holds " + std::to_string(values->size());
    if (const auto mended = frame.mend(*array, what, "those are taken"); !mended) {
      return tl::unexpected(mended.error());
    }
  }
  return values;
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
  const auto source = frame.follow(input, "source", "source");
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

}  // namespace

Result<pugi::xml_node> findMeshElement(const ColladaFrame& frame, pugi::xml_node geometry) {
  constexpr int kMaxSteps = 16;
  for (int step = 0; step < kMaxSteps; ++step) {
    const pugi::xml_node convex = geometry.child("convex_mesh");
    if (!convex) {
      return frame.xml().child(geometry, "mesh", "convex_hull_of needs one");
    }
    if (!convex.attribute("convex_hull_of")) {
      return convex;
    }
    const auto original = frame.follow(convex, "convex_hull_of", "geometry");
    if (!original) {
      return original;
    }
    geometry = *original;
  }
  return frame.xml().failAt(geometry, "convex_hull_of leads back to it and never to a <mesh>");
}

Result<std::vector<Vec3>> readConvexMesh(const ColladaFrame& frame, const pugi::xml_node& geometry) {
  return findMeshElement(frame, geometry).and_then([&](const pugi::xml_node& mesh) {
    return readPositions(frame, mesh);
  });
}

Result<VisualMesh> readMesh(const ColladaFrame& frame, const pugi::xml_node& mesh) {
  auto positions = readPositions(frame, mesh);
  if (!positions) {
    return tl::unexpected(positions.error());
  }
  VisualMesh result;
  result.vertices = std::move(*positions);
  for (Vec3& vertex : result.vertices) {
    vertex = frame.turnYUp(vertex);
  }
  for (const pugi::xml_node& child : mesh.children()) {
    if (const auto added = addPrimitive(frame, child, result); !added) {
      return tl::unexpected(added.error());
    }
  }
  return result;
}

}  // namespace scatter::io
