#pragma once

#include <scatter/levels/surface_mesh.h>

#include <cstddef>
#include <string>

namespace scatter::test {

/// The numbers that a mesh is stored in.
struct Packing {
  int component = 5126;               ///< Of positions; 5120 to 5123 are whole numbers, 5126 is a float.
  bool isNormalized = false;          ///< Whole numbers stand for fractions of the largest one.
  std::size_t stride = 12;            ///< Bytes from vertex to vertex.
  bool isCompressed = false;          ///< By meshoptimizer.
  const char* indices = "TRIANGLES";  ///< How they are compressed, or INDICES.
  bool isExponential = false;         ///< Compressed floats are rounded to 15 bits with a common exponent.
};

/// The same mesh as glTF, with the node that gives it its size back.
struct PackedGltf {
  std::string json;  ///< With @ instead of the buffer's uri.
  std::string data;
  double step = 0.0;  ///< No coordinate is further than half of it from where it was.

  [[nodiscard]] std::string glb() const;

  /// With the data inside, or in the file named.
  [[nodiscard]] std::string gltf(const std::string& uri = "") const;
};

/// No coordinate of the mesh may be outside of -1 to 1.
[[nodiscard]] PackedGltf packGltf(const SurfaceMesh& mesh, const Packing& packing);

/// `text` with its first `from`, which must be there, replaced.
[[nodiscard]] std::string replaced(std::string text, const std::string& from, const std::string& to);

}  // namespace scatter::test
