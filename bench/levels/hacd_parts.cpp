// hacd_parts MESH HULLS PARTS [VERTICES]: decomposes an .obj file by HACD (hierarchical approximate convex
// decomposition) of Bullet's extras, other settings as in Bullet's own example, into an .obj file with an
// object for each hull, of at most VERTICES vertices, or as many as it has if that is 0 or not given.
#include <HACD/hacdHACD.h>
#include <scatter/io/file.h>
#include <scatter/io/mesh_file.h>
#include <spdlog/fmt/fmt.h>

#include <cstdio>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

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

/// An object with a vertex for each point, and triangles with the corners that they have.
void append(std::string& text, HACD::HACD& hacd, std::size_t part, const Frame& frame, std::size_t first) {
  Points hull(hacd.GetNPointsCH(part));
  Triangles sides(hacd.GetNTrianglesCH(part));
  hacd.GetCH(part, hull.data(), sides.data());
  text += fmt::format("o hull{}\n", part + 1);
  for (const auto& point : hull) {
    const Vec3 place = frame(point);
    text += fmt::format("v {:.9g} {:.9g} {:.9g}\n", place.x, place.y, place.z);
  }
  const auto corner = [first](long index) { return first + static_cast<std::size_t>(index); };
  for (const auto& side : sides)
    text += fmt::format("f {} {} {}\n", corner(side.X()), corner(side.Y()), corner(side.Z()));
}

std::string decompose(const SurfaceMesh& mesh, int parts, int maxVertices) {
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
  hacd.NormalizeData();
  const Frame frame(mesh, points);
  hacd.Compute(maxVertices == 0, false);
  std::string text;
  std::size_t first = 1;
  for (std::size_t part = 0; part < hacd.GetNClusters(); ++part) {
    append(text, hacd, part, frame, first);
    first += hacd.GetNPointsCH(part);
  }
  return text;
}

int run(const std::vector<std::string>& words) {
  const int parts = words.size() < 3 ? 0 : std::atoi(words[2].c_str());
  if (words.size() < 3 || words.size() > 4 || parts < 1) {
    fmt::print(stderr, "usage: hacd_parts MESH HULLS PARTS [VERTICES]\n");
    return 2;
  }
  const auto file = readMesh(words[0]);
  if (!file) {
    fmt::print(stderr, "hacd_parts: {}\n", file.error().message);
    return 2;
  }
  const std::string text = decompose(file->mesh, parts, words.size() == 4 ? std::atoi(words[3].c_str()) : 0);
  if (const auto written = writeFile(words[1], text); !written) {
    fmt::print(stderr, "hacd_parts: {}\n", written.error().message);
    return 1;
  }
  return 0;
}

}  // namespace
}  // namespace scatter::bench

int main(int argc, char** argv) {
  return scatter::bench::run({argv + 1, argv + argc});
}
