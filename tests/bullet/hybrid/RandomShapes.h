#pragma once

#include <BulletHybrid/btHybridLevelSet.h>
#include <btBulletCollisionCommon.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <random>
#include <utility>
#include <vector>

namespace scatter::test {

/// Random numbers that are the same everywhere: std's distributions are not.
class Random {
 public:
  explicit Random(std::uint64_t first) : engine_(first) {}

  float unit() { return static_cast<float>(engine_() >> 40U) / 16777216.0F; }
  float between(float low, float high) { return low + (high - low) * unit(); }
  int index(int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }
  bool chance(float probability) { return unit() < probability; }

  btVector3 inCube(float half) {
    const float x = between(-half, half);
    const float y = between(-half, half);
    return {x, y, between(-half, half)};
  }

  btVector3 direction() {
    for (;;) {
      const btVector3 v = inCube(1);
      if (v.length2() > 0.01F && v.length2() <= 1) return v.normalized();
    }
  }

  btQuaternion rotation(float largestAngle = 3.14159265F) {
    const btVector3 axis = direction();
    return {axis, between(-largestAngle, largestAngle)};
  }

  btTransform pose(float half) {
    const btQuaternion turn = rotation();
    return btTransform(turn, inCube(half));
  }

 private:
  std::mt19937_64 engine_;
};

/// Makes shapes of all convex kinds, degenerate ones among them, and owns them.
class RandomShapes {
 public:
  explicit RandomShapes(std::uint64_t first) : random(first) {}

  template <class Shape, class... Args>
  Shape* make(Args&&... args) {
    auto owned = std::make_unique<Shape>(std::forward<Args>(args)...);
    Shape* raw = owned.get();
    shapes_.push_back(std::move(owned));
    return raw;
  }

  /// A sound convex shape of about `size` across, margin included.
  btConvexShape* convex(float size) {
    const float a = size * random.between(0.15F, 0.5F);
    const float b = size * random.between(0.15F, 0.5F);
    const float c = size * random.between(0.15F, 0.5F);
    switch (random.index(8)) {
      case 0:
        return withMargin(make<btBoxShape>(btVector3(a, b, c)), size);
      case 1:
        return make<btSphereShape>(a);
      case 2:
        return make<btCapsuleShape>(a, b);
      case 3:
        return withMargin(make<btCylinderShape>(btVector3(a, b, a)), size);
      case 4:
        return withMargin(make<btConeShape>(a, b), size);
      default:
        return hull(size, 4 + random.index(57));
    }
  }

  /// A box, a sphere, or a hull: the kinds that detailed models are made of.
  btConvexShape* plain(float size) {
    const float half = size * random.between(0.2F, 0.5F);
    if (random.chance(0.2F)) return make<btBoxShape>(btVector3(half, half, half));
    return random.chance(0.2F) ? static_cast<btConvexShape*>(make<btSphereShape>(half)) : hull(size, 16);
  }

  btConvexHullShape* hull(float size, int points) {
    auto* shape = make<btConvexHullShape>();
    const btVector3 stretch(random.between(0.2F, 0.5F), random.between(0.2F, 0.5F),
                            random.between(0.2F, 0.5F));
    for (int i = 0; i < points; ++i) shape->addPoint(random.direction() * stretch * size, false);
    return finished(shape, size * random.between(0, 0.1F));
  }

  /// Hulls without volume, and with points that say nothing new.
  btConvexHullShape* degenerateHull(float size) {
    auto* shape = make<btConvexHullShape>();
    const int kind = random.index(5);
    const int points = kind == 3 ? 1 : 8;
    const btVector3 first = random.inCube(size / 2);
    const btVector3 last = random.inCube(size / 2);
    for (int i = 0; i < points; ++i) {
      btVector3 point = random.inCube(size / 2);
      if (kind == 0) point.setZ(0);
      if (kind == 1) point = first.lerp(last, static_cast<float>(i) / 7);
      if (kind == 2 && i >= 4) point = shape->getUnscaledPoints()[i - 4];
      if (kind == 4) point = first + point * 1e-5F;
      shape->addPoint(point, false);
    }
    return finished(shape, size * random.between(0.01F, 0.1F));
  }

  /// `parts` parts of mixed kinds, turned within the body, all of it about `size` across.
  btCompoundShape* compound(int parts, float size, float degenerate = 0) {
    auto* shape = make<btCompoundShape>();
    const float partSize = parts == 1 ? size : size * random.between(0.2F, 0.6F);
    for (int i = 0; i < parts; ++i) {
      const btTransform place = random.pose(parts == 1 ? 0 : (size - partSize) / 2);
      btConvexShape* part = random.chance(degenerate) ? degenerateHull(partSize) : convex(partSize);
      shape->addChildShape(place, part);
    }
    return shape;
  }

  /// The same, of boxes, spheres and hulls only.
  btCompoundShape* plainCompound(int parts, float size) {
    auto* shape = make<btCompoundShape>();
    for (int i = 0; i < parts; ++i) {
      const btTransform place = random.pose(size * 0.35F);
      shape->addChildShape(place, plain(size * 0.3F));
    }
    return shape;
  }

  /// A level set of one level.
  const btHybridLevelSet& oneLevel(btCollisionShape* shape) {
    levels_.push_back(std::make_unique<btHybridLevelSet>());
    addLevel(*levels_.back(), shape);
    return *levels_.back();
  }

  /// `coarse` holds `fine`.
  const btHybridLevelSet& twoLevels(btCollisionShape* coarse, btCollisionShape* fine) {
    levels_.push_back(std::make_unique<btHybridLevelSet>());
    addLevel(*levels_.back(), coarse);
    addLevel(*levels_.back(), fine);
    return *levels_.back();
  }

  /// Three boxes that overlap each other, and hold a shape together.
  btCompoundShape* boxesAround(const btCollisionShape& shape) {
    btVector3 low;
    btVector3 high;
    shape.getAabb(btTransform::getIdentity(), low, high);
    const btVector3 half = 0.51F * (high - low);
    const btVector3 center = 0.5F * (low + high);
    auto* boxes = make<btCompoundShape>();
    auto* slab = make<btBoxShape>(btVector3(0.4F * half.x(), half.y(), half.z()));
    for (const float side : {-0.6F, 0.0F, 0.6F}) {
      const btVector3 place = center + btVector3(side * half.x(), 0, 0);
      boxes->addChildShape(btTransform(btQuaternion::getIdentity(), place), slab);
    }
    return boxes;
  }

  Random random;

  /// Levels that are refused are a mistake of the test.
  static void addLevel(btHybridLevelSet& levels, btCollisionShape* shape) {
    const char* mistake = levels.addLevel(shape);
    if (mistake == nullptr) return;
    std::fprintf(stderr, "a test's levels are wrong: %s\n", mistake);
    std::abort();
  }

 private:
  // A hull caches its bounds with the margin that it has at the time.
  static btConvexHullShape* finished(btConvexHullShape* shape, float margin) {
    shape->setMargin(margin);
    shape->recalcLocalAabb();
    return shape;
  }

  btConvexShape* withMargin(btConvexShape* shape, float size) {
    shape->setMargin(size * random.between(0, 0.1F));
    return shape;
  }

  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btHybridLevelSet>> levels_;
};

}  // namespace scatter::test
