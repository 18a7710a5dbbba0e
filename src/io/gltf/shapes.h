#pragma once

#include <scatter/io/physics_document.h>

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "io/gltf/file.h"
#include "io/gltf/mesh.h"

namespace scatter::io {

using DocumentGeometry = decltype(DocumentShape::geometry);

/// A shape of KHR_implicit_shapes as the file has it, before any scale. Capsule and cylinder may have two
/// radii.
struct GltfRound {
  double radiusBottom = 0.25;
  double radiusTop = 0.25;
  double height = 0.5;
  bool capsule = false;
};
struct GltfPlane {
  std::optional<double> sizeX;
  std::optional<double> sizeZ;
  bool doubleSided = false;
};
using GltfShape = std::variant<Box, Sphere, GltfRound, GltfPlane, ConvexHull>;

/// Reads a shape object: its "type" and the member of that name. Also "hull", which stands only in our
/// extras. Nothing, with a warning, if the type is not known. Throws GltfFailure.
[[nodiscard]] std::optional<GltfShape> readGltfShape(GltfFile& file, const JsonPlace& place);

/// A shape after a node's scale.
struct ScaledShape {
  DocumentGeometry geometry;
  std::string note;  ///< What was mended, for a warning; empty if the shape is exact.
};

/// Nothing if the scale leaves no volume.
[[nodiscard]] std::optional<ScaledShape> scaleShape(const GltfShape& shape, const glm::dmat3& stretch);

/// The points that are corners of their hull, in the order in which they come. Fails if they span no volume;
/// the message is a phrase.
[[nodiscard]] Result<std::vector<Vec3>> hullCorners(const std::vector<Vec3>& points);

/// Triangles over the points that show their hull, counter-clockwise seen from outside; none if the
/// points span no volume.
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> hullTriangles(const std::vector<Vec3>& points);

}  // namespace scatter::io
