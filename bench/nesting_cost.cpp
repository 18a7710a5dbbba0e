// What btHybridLevelSet::addLevel takes to prove that levels nest: for the models that come with Scatter, and
// for 64 random hulls of 32 points, each in one of eight boxes or astride of several of 27.

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletHybrid/btHybridLevelSet.h>
#include <scatter/io/model_library.h>
#include <scatter/lab/cpu_time.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "bullet/physics/shapes.h"

namespace {

constexpr int kRepeats = 5;

/// Milliseconds of the fastest of some runs; below 0 if a level is refused, which is told.
double proofMilliseconds(const btHybridLevelSet& levels, int level) {
  double best = 1e9;
  for (int repeat = 0; repeat < kRepeats; ++repeat) {
    btHybridLevelSet again;
    again.addLevel(levels.getLevelShape(level - 1));
    const double before = scatter::threadCpuSeconds();
    const char* mistake = again.addLevel(levels.getLevelShape(level));
    best = std::min(best, 1000.0 * (scatter::threadCpuSeconds() - before));
    if (mistake == nullptr) continue;
    std::printf("%s\n", mistake);
    return -1.0;
  }
  return best;
}

int childrenOf(const btCollisionShape* shape) {
  return shape->isCompound() ? static_cast<const btCompoundShape*>(shape)->getNumChildShapes() : 1;
}

/// False if a level is refused.
bool measure(const std::string& name, const btHybridLevelSet& levels) {
  bool isNested = true;
  for (int level = 2; level <= levels.getNumLevels(); ++level) {
    const double milliseconds = proofMilliseconds(levels, level);
    isNested = isNested && milliseconds >= 0.0;
    std::printf("%-16s level %d: %5d in %3d parts %8.2f ms\n", name.c_str(), level,
                childrenOf(levels.getLevelShape(level)), childrenOf(levels.getLevelShape(level - 1)),
                milliseconds);
  }
  return isNested;
}

bool measureModel(const std::string& name) {
  const auto model = scatter::loadModel(name);
  if (!model) {
    std::printf("%s\n", model.error().message.c_str());
    return false;
  }
  const auto shape = scatter::BulletShapeBuilder().build((*model)->levels);
  if (!shape) {
    std::printf("%s\n", shape.error().message.c_str());
    return false;
  }
  return measure(name, (*shape)->levels());
}

/// Of a cube of cells, so many along each axis.
btVector3 cellOf(int index, int along) {
  const int row = index / along;
  const int layer = row / along;
  return {static_cast<float>(index % along), static_cast<float>(row % along), static_cast<float>(layer)};
}

/// 64 hulls of 32 points, each at home in one of 64 cells of 1 m; boxes of 2 m, so many along each axis from
/// `shift` on.
bool measureRandomHulls(int boxesAlong, float shift) {
  std::mt19937_64 engine(1);
  const auto random = [&engine] { return static_cast<float>(engine() >> 40U) / 8388608.0F - 1.0F; };
  std::vector<std::unique_ptr<btCollisionShape>> owned;
  btCompoundShape coarse;
  btCompoundShape fine;
  btBoxShape box(btVector3(1, 1, 1));
  for (int i = 0; i < 64; ++i) {
    auto hull = std::make_unique<btConvexHullShape>();
    for (int k = 0; k < 32; ++k) hull->addPoint(btVector3(random(), random(), random()).normalized() * 0.45F);
    const btVector3 cell = cellOf(i, 4);
    fine.addChildShape(btTransform(btQuaternion::getIdentity(), cell + btVector3(0.5F, 0.5F, 0.5F)),
                       hull.get());
    owned.push_back(std::move(hull));
  }
  for (int i = 0; i < boxesAlong * boxesAlong * boxesAlong; ++i) {
    const btVector3 cell = cellOf(i, boxesAlong);
    const btVector3 center = 2.0F * cell + btVector3(shift + 1, shift + 1, shift + 1);
    coarse.addChildShape(btTransform(btQuaternion::getIdentity(), center), &box);
  }
  btHybridLevelSet levels;
  levels.addLevel(&coarse, BT_HYBRID_NESTING_IS_PROVEN);
  levels.addLevel(&fine, BT_HYBRID_NESTING_IS_PROVEN);
  return measure("random hulls", levels);
}

}  // namespace

int main() {
  bool isNested = true;
  for (const std::string& name : scatter::modelNames()) isNested = measureModel(name) && isNested;
  isNested = measureRandomHulls(2, 0) && isNested;
  isNested = measureRandomHulls(3, -1.5F) && isNested;
  return isNested ? 0 : 1;
}
