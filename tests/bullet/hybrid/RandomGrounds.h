#pragma once

#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "RandomShapes.h"

namespace scatter::test {

enum class GroundType { kPlane, kMesh, kSmallMesh, kSoup, kScaledMesh, kHeightField, kBox, kHull };
constexpr GroundType kGrounds[] = {GroundType::kPlane, GroundType::kMesh,       GroundType::kSmallMesh,
                                   GroundType::kSoup,  GroundType::kScaledMesh, GroundType::kHeightField,
                                   GroundType::kBox,   GroundType::kHull};

inline std::string nameOf(GroundType type) {
  constexpr const char* kNames[] = {"Plane",      "Mesh",        "SmallMesh", "Soup",
                                    "ScaledMesh", "HeightField", "Box",       "Hull"};
  return kNames[static_cast<int>(type)];
}

/// Adds two triangles for each cell of a square net whose corners have numbers from `first` to `last`; `at`
/// tells where a corner is.
template <class At>
void addNet(btTriangleMesh& mesh, int first, int last, const At& at) {
  for (int z = first; z < last; ++z) {
    for (int x = first; x < last; ++x) {
      mesh.addTriangle(at(x, z), at(x, z + 1), at(x + 1, z));
      mesh.addTriangle(at(x + 1, z), at(x, z + 1), at(x + 1, z + 1));
    }
  }
}

/// A level net with cells of a metre.
inline void addFlatNet(btTriangleMesh& mesh, int first, int last) {
  addNet(mesh, first, last,
         [](int x, int z) { return btVector3(static_cast<float>(x), 0, static_cast<float>(z)); });
}

/// Makes what bodies lie on, with the surface near the origin of the shape, up to 40 `size` wide. Owns its
/// meshes.
class RandomGrounds {
 public:
  explicit RandomGrounds(RandomShapes& shapes) : shapes_(shapes) {}

  btCollisionShape* make(GroundType type, float size) {
    switch (type) {
      case GroundType::kPlane:
        return shapes_.make<btStaticPlaneShape>(shapes_.random.direction(), 0.1F * size);
      case GroundType::kMesh:
        return withMargin(shapes_.make<btBvhTriangleMeshShape>(hills(size), true), size);
      case GroundType::kSmallMesh:
        return withMargin(shapes_.make<btBvhTriangleMeshShape>(hills(0.1F * size), true), size);
      case GroundType::kSoup:
        return withMargin(shapes_.make<btBvhTriangleMeshShape>(soup(size), true), size);
      case GroundType::kScaledMesh:
        return shapes_.make<btScaledBvhTriangleMeshShape>(
            shapes_.make<btBvhTriangleMeshShape>(hills(size), true), btVector3(1.3F, 0.7F, 0.9F));
      case GroundType::kHeightField:
        return heightField(size);
      case GroundType::kBox:
        return withMargin(shapes_.make<btBoxShape>(btVector3(20, 0.5F, 15) * size), size);
      case GroundType::kHull:
        break;
    }
    return bigHull(size);
  }

 private:
  static constexpr int kCells = 24;

  template <class Shape>
  Shape* withMargin(Shape* shape, float size) {
    shape->setMargin(size * shapes_.random.between(0.0F, 0.04F));
    return shape;
  }

  btTriangleMesh* newMesh() {
    meshes_.push_back(std::make_unique<btTriangleMesh>());
    return meshes_.back().get();
  }

  [[nodiscard]] std::vector<float> heights(float size) {
    std::vector<float> result;
    const float steep = shapes_.random.between(0.1F, 0.8F);
    for (int i = 0; i < (kCells + 1) * (kCells + 1); ++i) {
      result.push_back(size * steep * shapes_.random.between(-0.5F, 0.5F));
    }
    return result;
  }

  btTriangleMesh* hills(float size) {
    const std::vector<float> height = heights(size);
    const auto at = [&](int x, int z) {
      const auto i = static_cast<std::size_t>(z * (kCells + 1) + x);
      return btVector3(static_cast<float>(x - kCells / 2) * size, height[i],
                       static_cast<float>(z - kCells / 2) * size);
    };
    btTriangleMesh* mesh = newMesh();
    addNet(*mesh, 0, kCells, at);
    return mesh;
  }

  /// Needles, large ones, and some without an area.
  btTriangleMesh* soup(float size) {
    btTriangleMesh* mesh = newMesh();
    for (int i = 0; i < 80; ++i) {
      const btVector3 middle = shapes_.random.inCube(1.5F * size);
      const float reach = size * (i % 8 == 0 ? 6.0F : shapes_.random.between(0.05F, 1.0F));
      btVector3 corner[3];
      for (btVector3& c : corner) c = middle + shapes_.random.inCube(reach);
      if (i % 20 == 0) corner[2] = corner[1];
      mesh->addTriangle(corner[0], corner[1], corner[2]);
    }
    return mesh;
  }

  btCollisionShape* heightField(float size) {
    fields_.push_back(std::make_unique<std::vector<float>>(heights(size)));
    auto* shape =
        shapes_.make<btHeightfieldTerrainShape>(kCells + 1, kCells + 1, fields_.back()->data(), 1, -size,
                                                size, 1, PHY_FLOAT, shapes_.random.chance(0.5F));
    shape->setLocalScaling(btVector3(size, 1, size));
    return shape;
  }

  btCollisionShape* bigHull(float size) {
    auto* hull = shapes_.make<btConvexHullShape>();
    for (int i = 0; i < 14; ++i) {
      const float angle = 6.2831853F * static_cast<float>(i) / 14;
      for (const float y : {-0.5F, 0.0F}) {
        const btVector3 corner(15 * std::cos(angle), y, 15 * std::sin(angle));
        hull->addPoint(size * (corner + shapes_.random.inCube(0.3F)), false);
      }
    }
    hull->setMargin(size * shapes_.random.between(0.0F, 0.04F));
    hull->recalcLocalAabb();
    return hull;
  }

  RandomShapes& shapes_;
  std::vector<std::unique_ptr<btTriangleMesh>> meshes_;
  std::vector<std::unique_ptr<std::vector<float>>> fields_;
};

}  // namespace scatter::test
