#include "scenes/ground_shapes.h"

#include <scatter/io/mesh_file.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "scenes/placement.h"

namespace scatter {
namespace {

constexpr float kWaves = 3.0F;  // along the longer side, of the longest kind
constexpr int kMostOctaves = 8;
constexpr float kLeastCells = 4.0F;  // of a wave: shorter ones would be corners

/// Random heights at the corners of squares, and between them what is smooth.
class NoiseLattice {
 public:
  /// Squares of side `length` over a rectangle, metres.
  NoiseLattice(Random& random, float sizeX, float sizeZ, float length)
      : length_(length), columns_(corners(sizeX / length)), heights_(columns_ * corners(sizeZ / length)) {
    for (float& height : heights_) height = random.uniform(-1.0F, 1.0F);
  }

  /// At a point of the rectangle, whose least corner is 0, 0.
  [[nodiscard]] float height(float x, float z) const {
    const float column = std::floor(x / length_);
    const float row = std::floor(z / length_);
    const float acrossX = fade(x / length_ - column);
    const float acrossZ = fade(z / length_ - row);
    const auto corner = static_cast<std::size_t>(row) * columns_ + static_cast<std::size_t>(column);
    const float near = between(heights_[corner], heights_[corner + 1], acrossX);
    const float far = between(heights_[corner + columns_], heights_[corner + columns_ + 1], acrossX);
    return between(near, far, acrossZ);
  }

 private:
  /// Rounding may lead one square too far.
  static std::size_t corners(float squares) { return static_cast<std::size_t>(std::ceil(squares)) + 2; }
  static float between(float from, float to, float share) { return from + (to - from) * share; }

  /// From 0 to 1 without slope or curvature at the ends.
  static float fade(float t) { return t * t * t * (t * (t * 6.0F - 15.0F) + 10.0F); }

  float length_;
  std::size_t columns_;
  std::vector<float> heights_;
};

/// From 0 to the relief.
void stretch(std::vector<float>& heights, float relief) {
  const auto [least, most] = std::minmax_element(heights.begin(), heights.end());
  const float low = *least;
  const float range = *most - low;
  for (float& height : heights) height = range > 0.0F ? relief * ((height - low) / range) : 0.0F;
}

}  // namespace

HeightField terrainHeights(const SceneFileTerrain& terrain) {
  HeightField field;
  field.columns = terrain.cells[0] + 1;
  field.rows = terrain.cells[1] + 1;
  field.spacingX = terrain.size[0] / static_cast<float>(terrain.cells[0]);
  field.spacingZ = terrain.size[1] / static_cast<float>(terrain.cells[1]);
  field.heights.resize(std::size_t{field.columns} * field.rows);
  Random random(terrain.seed);
  float length = std::max(terrain.size[0], terrain.size[1]) / kWaves;
  const float shortest = kLeastCells * std::max(field.spacingX, field.spacingZ);
  float weight = 1.0F;
  for (int octave = 0; octave < kMostOctaves && (octave == 0 || length >= shortest); ++octave) {
    const NoiseLattice lattice(random, terrain.size[0], terrain.size[1], length);
    for (std::uint32_t row = 0; row < field.rows; ++row) {
      for (std::uint32_t column = 0; column < field.columns; ++column) {
        field.heights[std::size_t{row} * field.columns + column] +=
            weight * lattice.height(static_cast<float>(column) * field.spacingX,
                                    static_cast<float>(row) * field.spacingZ);
      }
    }
    weight *= terrain.roughness;
    length *= 0.5F;
  }
  stretch(field.heights, terrain.relief);
  return field;
}

Shape terrainShape(const SceneFileTerrain& terrain) {
  HeightField field = terrainHeights(terrain);
  if (terrain.isHeightField) return std::make_shared<const HeightField>(std::move(field));
  return std::make_shared<const TriangleMesh>(trianglesOf(field));
}

Result<Shape> readMeshShape(const std::filesystem::path& file) {
  return readMesh(file).map([](MeshFile read) -> Shape {
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->vertices = std::move(read.mesh.vertices);
    mesh->triangles = std::move(read.mesh.triangles);
    return std::shared_ptr<const TriangleMesh>(std::move(mesh));
  });
}

}  // namespace scatter
