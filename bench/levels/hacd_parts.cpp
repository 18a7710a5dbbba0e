#include <HACD/hacdHACD.h>

#include <cstdint>
#include <cstring>
#include <ctime>
#include <glm/geometric.hpp>
#include <string>
#include <utility>
#include <vector>

#include "io/mesh/isolated_call.h"
#include "parts.h"

namespace scatter::bench {
namespace {

using Points = std::vector<HACD::Vec3<HACD::Real>>;
using Triangles = std::vector<HACD::Vec3<long>>;

void configure(HACD::HACD& hacd, int parts, int maxVertices) {
  constexpr std::size_t kUnlimited = 100'000;
  hacd.SetCompacityWeight(0.1);
  hacd.SetVolumeWeight(0.0);
  hacd.SetNClusters(static_cast<std::size_t>(parts));
  hacd.SetNVerticesPerCH(maxVertices > 0 ? static_cast<std::size_t>(maxVertices) : kUnlimited);
  // The number of parts decides alone.
  hacd.SetConcavity(1e9);
  hacd.SetConnectDist(30.0);
  hacd.SetAddExtraDistPoints(true);
  hacd.SetAddNeighboursDistPoints(true);
  hacd.SetAddFacesPoints(true);
}

template <class Value>
void append(std::string& bytes, const Value& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

glm::dvec3 toVector(const HACD::Vec3<HACD::Real>& point) {
  return {point.X(), point.Y(), point.Z()};
}

/// From HACD's shifted and scaled coordinates, in which it gives its parts, back to the mesh's.
class Frame {
 public:
  Frame(const SurfaceMesh& mesh, const Points& scaled) : from_(toVector(scaled[0])), to_(mesh.vertices[0]) {
    std::size_t far = 0;
    for (std::size_t i = 0; i < scaled.size(); ++i) {
      if (glm::length(toVector(scaled[i]) - from_) > glm::length(toVector(scaled[far]) - from_)) far = i;
    }
    scale_ = glm::length(glm::dvec3(mesh.vertices[far]) - to_) / glm::length(toVector(scaled[far]) - from_);
  }

  [[nodiscard]] Vec3 operator()(const HACD::Vec3<HACD::Real>& point) const {
    return Vec3(to_ + scale_ * (toVector(point) - from_));
  }

 private:
  glm::dvec3 from_;
  glm::dvec3 to_;
  double scale_;
};

/// Seconds, then the points of each part, preceded by their number.
std::string run(const SurfaceMesh& mesh, int parts, int maxVertices) {
  Points points;
  for (const Vec3& v : mesh.vertices) {
    points.emplace_back(static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z));
  }
  Triangles triangles;
  for (const auto& t : mesh.triangles) {
    triangles.emplace_back(static_cast<long>(t[0]), static_cast<long>(t[1]), static_cast<long>(t[2]));
  }
  HACD::HACD hacd;
  hacd.SetPoints(points.data());
  hacd.SetNPoints(points.size());
  hacd.SetTriangles(triangles.data());
  hacd.SetNTriangles(triangles.size());
  configure(hacd, parts, maxVertices);
  const std::clock_t start = std::clock();
  hacd.NormalizeData();
  const Frame frame(mesh, points);
  hacd.Compute(maxVertices == 0, false);
  std::string bytes;
  append(bytes, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  for (std::size_t part = 0; part < hacd.GetNClusters(); ++part) {
    Points hull(hacd.GetNPointsCH(part));
    Triangles sides(hacd.GetNTrianglesCH(part));
    hacd.GetCH(part, hull.data(), sides.data());
    append(bytes, static_cast<std::uint32_t>(hull.size()));
    for (const auto& point : hull) append(bytes, frame(point));
  }
  return bytes;
}

template <class Value>
Value take(const std::string& bytes, std::size_t& at) {
  Value value{};
  if (at + sizeof value <= bytes.size()) std::memcpy(&value, bytes.data() + at, sizeof value);
  at += sizeof value;
  return value;
}

}  // namespace

Result<Decomposition> decomposeByHacd(const SurfaceMesh& mesh, const DecompositionDef& definition) {
  const io::IsolationLimits limits{.memoryBytes = std::uint64_t{8} << 30U,
                                   .processorSeconds = definition.limitSeconds,
                                   .answerBytes = std::uint64_t{1} << 30U};
  const Result<std::string> bytes =
      io::callIsolated([&] { return run(mesh, definition.parts, definition.maxVertices); }, limits);
  if (!bytes) return fail(bytes.error().message);
  std::size_t at = 0;
  const auto seconds = take<double>(*bytes, at);
  std::vector<ConvexHull> hulls;
  while (at < bytes->size()) {
    ConvexHull hull;
    for (auto count = take<std::uint32_t>(*bytes, at); count > 0; --count)
      hull.vertices.push_back(take<Vec3>(*bytes, at));
    hulls.push_back(std::move(hull));
  }
  return decompositionOf(std::move(hulls), seconds);
}

}  // namespace scatter::bench
