#include "io/mesh/meshopt.h"

#include <meshoptimizer.h>

#include <cstddef>
#include <cstdint>
#include <optional>

namespace scatter::io {
namespace {

/// How a buffer view was compressed.
struct Compression {
  std::string mode;
  std::string filter;
  std::size_t count = 0;
  std::size_t stride = 0;
};

/// The decoder takes each of these for granted.
bool isSound(const Compression& compression) {
  const std::size_t stride = compression.stride;
  const std::string& filter = compression.filter;
  if (compression.mode == "ATTRIBUTES") {
    return stride > 0 && stride <= 256 && stride % 4 == 0 &&
           (filter == "NONE" || filter == "EXPONENTIAL" || (filter == "QUATERNION" && stride == 8) ||
            (filter == "OCTAHEDRAL" && (stride == 4 || stride == 8)));
  }
  const bool areTriangles = compression.mode == "TRIANGLES" && compression.count % 3 == 0;
  return (areTriangles || compression.mode == "INDICES") && (stride == 2 || stride == 4) && filter == "NONE";
}

Compression readCompression(const JsonPlace& place, std::size_t compressedBytes) {
  // Bytes that are all alike take a quarter of a bit each; indices take more.
  constexpr std::uint64_t kMostTimes = 64;
  const std::uint64_t most = kMostTimes * compressedBytes;
  const std::uint64_t count = place.at("count").count();
  const std::uint64_t stride = place.at("byteStride").count();
  const auto filter = place.find("filter");
  if (stride > 0 && count > most / stride) {
    place.fail(std::to_string(count) + " elements cannot be in " + std::to_string(compressedBytes) +
               " bytes");
  }
  Compression compression{.mode = place.at("mode").text(),
                          .filter = filter ? filter->text() : "NONE",
                          .count = static_cast<std::size_t>(count),
                          .stride = static_cast<std::size_t>(stride)};
  if (!isSound(compression)) place.fail("its mode, filter, count and byteStride do not go together");
  return compression;
}

/// Whether the bytes were sound.
bool decode(const Compression& compression, std::string_view bytes, char* target) {
  const auto* source = reinterpret_cast<const unsigned char*>(bytes.data());
  const auto [mode, filter, count, stride] = compression;
  if (mode == "TRIANGLES") return meshopt_decodeIndexBuffer(target, count, stride, source, bytes.size()) == 0;
  if (mode == "INDICES") return meshopt_decodeIndexSequence(target, count, stride, source, bytes.size()) == 0;
  return meshopt_decodeVertexBuffer(target, count, stride, source, bytes.size()) == 0;
}

void undoFilter(const Compression& compression, char* target) {
  if (compression.filter == "OCTAHEDRAL")
    meshopt_decodeFilterOct(target, compression.count, compression.stride);
  if (compression.filter == "QUATERNION")
    meshopt_decodeFilterQuat(target, compression.count, compression.stride);
  if (compression.filter == "EXPONENTIAL")
    meshopt_decodeFilterExp(target, compression.count, compression.stride);
}

}  // namespace

std::string decompressMeshopt(const JsonPlace& compression, std::string_view bytes) {
  const Compression how = readCompression(compression, bytes.size());
  std::string result(how.count * how.stride, '\0');
  if (!decode(how, bytes, result.data())) {
    compression.fail("its data is damaged, or of a later version of the format than " +
                     std::to_string(MESHOPTIMIZER_VERSION / 1000) + "." +
                     std::to_string(MESHOPTIMIZER_VERSION / 10 % 100) + " of meshoptimizer reads");
  }
  undoFilter(how, result.data());
  return result;
}

}  // namespace scatter::io
