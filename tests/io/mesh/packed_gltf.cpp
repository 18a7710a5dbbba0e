#include "io/mesh/packed_gltf.h"

#include <meshoptimizer.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "io/gltf/base64.h"
#include "io/gltf/container.h"
#include "io/numbers.h"

namespace scatter::test {
namespace {

constexpr int kFloat = 5126;

/// Which whole numbers stand for -1 to 1.
struct Span {
  double low = 0.0;
  double high = 0.0;
  double largest = 1.0;  ///< What a normalised 1 is stored as.
};

template <class Number>
Span spanOf() {
  const double largest = std::numeric_limits<Number>::max();
  return {std::is_signed_v<Number> ? -largest : 0.0, largest, largest};
}

Span spanOf(int component) {
  switch (component) {
    case 5120:
      return spanOf<std::int8_t>();
    case 5121:
      return spanOf<std::uint8_t>();
    case 5122:
      return spanOf<std::int16_t>();
    case 5123:
      return spanOf<std::uint16_t>();
    default:
      return {-1.0, 1.0, 1.0};
  }
}

template <class Number>
void store(double value, char* target) {
  const auto number = static_cast<Number>(value);
  std::memcpy(target, &number, sizeof number);
}

void storeAs(int component, double value, char* target) {
  switch (component) {
    case 5120:
      return store<std::int8_t>(value, target);
    case 5121:
      return store<std::uint8_t>(value, target);
    case 5122:
      return store<std::int16_t>(value, target);
    case 5123:
      return store<std::uint16_t>(value, target);
    default:
      return store<float>(value, target);
  }
}

std::string vertexBytes(const SurfaceMesh& mesh, const Packing& packing) {
  const Span span = spanOf(packing.component);
  const std::size_t size = packing.component == kFloat ? 4 : packing.component < 5122 ? 1 : 2;
  std::string bytes(mesh.vertices.size() * packing.stride, '\0');
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto value = static_cast<double>(mesh.vertices[i][static_cast<int>(axis)]);
      const double place = span.low + (span.high - span.low) * (value + 1.0) / 2.0;
      storeAs(packing.component, packing.component == kFloat ? value : std::round(place),
              bytes.data() + i * packing.stride + axis * size);
    }
  }
  if (packing.isExponential) {
    const std::vector<Vec3> values = mesh.vertices;
    meshopt_encodeFilterExp(bytes.data(), values.size(), packing.stride, 15, &values[0][0]);
  }
  return bytes;
}

std::string compressVertices(const std::string& bytes, std::size_t count, std::size_t stride) {
  std::string result(meshopt_encodeVertexBufferBound(count, stride), '\0');
  result.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(result.data()), result.size(),
                                           bytes.data(), count, stride));
  return result;
}

std::string compressIndices(const std::vector<unsigned>& indices, std::size_t vertices, bool asTriangles) {
  std::string result(asTriangles ? meshopt_encodeIndexBufferBound(indices.size(), vertices)
                                 : meshopt_encodeIndexSequenceBound(indices.size(), vertices),
                     '\0');
  auto* const target = reinterpret_cast<unsigned char*>(result.data());
  result.resize(asTriangles
                    ? meshopt_encodeIndexBuffer(target, result.size(), indices.data(), indices.size())
                    : meshopt_encodeIndexSequence(target, result.size(), indices.data(), indices.size()));
  return result;
}

/// Of `bytes`, which begin at `offset`; compressed to as many as given if it has a mode.
std::string viewJson(std::size_t offset, std::size_t stored, std::size_t count, std::size_t stride,
                     const std::string& compression, bool isVertices) {
  const std::string length = std::to_string(count * stride);
  const std::string place = R"("byteOffset":)" + std::to_string(offset) + ",";
  const std::string step = R"("byteStride":)" + std::to_string(stride);
  if (compression.empty()) {
    return R"({"buffer":0,)" + place + R"("byteLength":)" + length + (isVertices ? "," + step : "") + "}";
  }
  return R"({"buffer":1,"byteLength":)" + length + (isVertices ? "," + step : "") +
         R"(,"extensions":{"EXT_meshopt_compression":{"buffer":0,)" + place + R"("byteLength":)" +
         std::to_string(stored) + "," + step + R"(,"count":)" + std::to_string(count) + "," + compression +
         "}}}";
}

std::string nodeJson(const Packing& packing) {
  const Span span = spanOf(packing.component);
  const double unit = packing.isNormalized ? span.largest : 1.0;
  const std::string scale = io::formatNumber(2.0 * unit / (span.high - span.low), 9);
  const std::string shift = span.low < 0.0 ? "0" : "-1";
  return R"({"mesh":0,"scale":[)" + scale + "," + scale + "," + scale + R"(],"translation":[)" + shift + "," +
         shift + "," + shift + "]}";
}

}  // namespace

PackedGltf packGltf(const SurfaceMesh& mesh, const Packing& packing) {
  std::vector<unsigned> indices;
  for (const auto& triangle : mesh.triangles) indices.insert(indices.end(), triangle.begin(), triangle.end());
  const std::size_t vertexCount = mesh.vertices.size();
  std::string vertices = vertexBytes(mesh, packing);
  std::string corners(reinterpret_cast<const char*>(indices.data()), indices.size() * 4);
  std::string vertexMode;
  std::string indexMode;
  if (packing.isCompressed) {
    vertices = compressVertices(vertices, vertexCount, packing.stride);
    corners = compressIndices(indices, vertexCount, std::string(packing.indices) == "TRIANGLES");
    vertexMode =
        std::string(R"("mode":"ATTRIBUTES")") + (packing.isExponential ? R"(,"filter":"EXPONENTIAL")" : "");
    indexMode = std::string(R"("mode":")") + packing.indices + "\"";
  }
  const std::size_t storedVertices = vertices.size();
  vertices.resize((vertices.size() + 3) / 4 * 4, '\0');
  PackedGltf result;
  result.data = vertices + corners;
  const Span span = spanOf(packing.component);
  result.step = packing.component == kFloat ? (packing.isExponential ? 1.0 / 8192.0 : 0.0)
                                            : 2.0 / (span.high - span.low);
  const std::string length = std::to_string(result.data.size());
  const char* extensions = R"(["KHR_mesh_quantization","EXT_meshopt_compression"])";
  result.json =
      std::string(R"({"asset":{"version":"2.0"},"extensionsUsed":)") + extensions +
      R"(,"extensionsRequired":)" + extensions + R"(,"scene":0,"scenes":[{"nodes":[0]}],"nodes":[)" +
      nodeJson(packing) +
      R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"accessors":[{"bufferView":0,"componentType":)" +
      std::to_string(packing.component) + R"(,"normalized":)" + (packing.isNormalized ? "true" : "false") +
      R"(,"count":)" + std::to_string(vertexCount) +
      R"(,"type":"VEC3"},{"bufferView":1,"componentType":5125,"count":)" + std::to_string(indices.size()) +
      R"(,"type":"SCALAR"}],"bufferViews":[)" +
      viewJson(0, storedVertices, vertexCount, packing.stride, vertexMode, true) + "," +
      viewJson(vertices.size(), corners.size(), indices.size(), 4, indexMode, false) +
      R"(],"buffers":[{"byteLength":)" + length + R"(@},{"byteLength":)" +
      std::to_string(vertexCount * packing.stride + indices.size() * 4) +
      R"(,"extensions":{"EXT_meshopt_compression":{"fallback":true}}}]})";
  return result;
}

std::string PackedGltf::glb() const {
  return io::packGlb(replaced(json, "@", ""), data);
}

std::string PackedGltf::gltf(const std::string& uri) const {
  const std::string inside = "data:application/octet-stream;base64," + io::encodeBase64(data);
  return replaced(json, "@", R"(,"uri":")" + (uri.empty() ? inside : uri) + "\"");
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  return text.replace(at, from.size(), to);
}

}  // namespace scatter::test
