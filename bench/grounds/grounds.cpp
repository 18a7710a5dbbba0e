#include "grounds.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>
#include <algorithm>

namespace scatter::bench {

namespace {

constexpr int kCells = 100;
constexpr int kPoints = kCells + 1;
constexpr float kCell = Ground::kWidth / kCells;

constexpr std::size_t indexOf(int x, int z) {
  return static_cast<std::size_t>(z) * kPoints + static_cast<std::size_t>(x);
}

btVector3 pointAt(const std::vector<float>& heights, int x, int z) {
  const float half = Ground::kWidth / 2;
  return {static_cast<float>(x) * kCell - half, heights[indexOf(x, z)], static_cast<float>(z) * kCell - half};
}

std::unique_ptr<btConvexHullShape> flatHull() {
  auto hull = std::make_unique<btConvexHullShape>();
  for (int i = 0; i < 24; ++i) {
    const float angle = SIMD_PI / 12 * static_cast<float>(i);
    for (const float y : {-1.0F, 1.0F}) {
      hull->addPoint(btVector3(60 * std::cos(angle), y, 60 * std::sin(angle)), false);
    }
  }
  hull->recalcLocalAabb();
  return hull;
}

}  // namespace

Ground::Ground(GroundKind kind, float relief, Random& random) {
  switch (kind) {
    case GroundKind::kMesh:
      addHeights(relief, random);
      addTriangles();
      shape_ = std::make_unique<btBvhTriangleMeshShape>(&mesh_, true);
      break;
    case GroundKind::kHeightField:
      addHeights(relief, random);
      // Bullet puts the middle of the least and the largest height at the shape's origin.
      shape_ = std::make_unique<btHeightfieldTerrainShape>(kPoints, kPoints, heights_.data(), 1, -relief,
                                                           relief, 1, PHY_FLOAT, false);
      shape_->setLocalScaling(btVector3(kCell, 1, kCell));
      break;
    case GroundKind::kPlane:
      shape_ = std::make_unique<btStaticPlaneShape>(btVector3(0, 1, 0), 0);
      break;
    case GroundKind::kBox:
      shape_ = std::make_unique<btBoxShape>(btVector3(kWidth / 2, 1, kWidth / 2));
      position_ = {0, -1, 0};
      break;
    case GroundKind::kHull:
      shape_ = flatHull();
      position_ = {0, -1 - shape_->getMargin(), 0};
      break;
  }
}

// Waves of random directions, lengths of 60 m to 8 m and heights that fall with them.
void Ground::addHeights(float relief, Random& random) {
  heights_.assign(indexOf(0, kPoints), 0.0F);
  constexpr int kWaves = 24;
  for (int wave = 0; wave < kWaves; ++wave) {
    const float length = 60.0F / (1.0F + 0.27F * static_cast<float>(wave));
    const float angle = random.in(0.0F, 2 * SIMD_PI);
    const float phase = random.in(0.0F, 2 * SIMD_PI);
    for (int z = 0; z < kPoints; ++z) {
      for (int x = 0; x < kPoints; ++x) {
        const float along =
            kCell * (static_cast<float>(x) * std::cos(angle) + static_cast<float>(z) * std::sin(angle));
        heights_[indexOf(x, z)] += length * std::sin(2 * SIMD_PI * along / length + phase);
      }
    }
  }
  float most = 0;
  for (const float height : heights_) most = std::max(most, std::abs(height));
  for (float& height : heights_) height *= relief / most;
  highest_ = relief;
}

// The two triangles of a cell are those that Bullet's height field has.
void Ground::addTriangles() {
  for (int z = 0; z < kCells; ++z) {
    for (int x = 0; x < kCells; ++x) {
      const btVector3 a = pointAt(heights_, x, z);
      const btVector3 b = pointAt(heights_, x + 1, z);
      const btVector3 c = pointAt(heights_, x, z + 1);
      const btVector3 d = pointAt(heights_, x + 1, z + 1);
      mesh_.addTriangle(a, c, b);
      mesh_.addTriangle(b, c, d);
    }
  }
}

}  // namespace scatter::bench
