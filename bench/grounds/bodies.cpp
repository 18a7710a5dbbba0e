#include "bodies.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <algorithm>

namespace scatter::bench {

namespace {

constexpr float kMargin = 0.01F;

std::unique_ptr<btConvexHullShape> hullOf(const std::vector<btVector3>& points) {
  auto hull = std::make_unique<btConvexHullShape>();
  for (const btVector3& point : points) hull->addPoint(point, false);
  hull->recalcLocalAabb();
  hull->setMargin(kMargin);
  return hull;
}

std::unique_ptr<btConvexHullShape> rock(Random& random) {
  std::vector<btVector3> points;
  for (int i = 0; i < 24; ++i) points.push_back(0.4F * random.inCube(1.0F).normalized());
  return hullOf(points);
}

}  // namespace

Model::Model(BodyKind kind, Random& random) {
  switch (kind) {
    case BodyKind::kShip:
      addShip(random);
      break;
    case BodyKind::kWheel:
      addWheel(random);
      break;
    case BodyKind::kPlate:
      addPlate(random);
      break;
    case BodyKind::kRock:
      bare_ = rock(random);
      break;
    case BodyKind::kCrate:
      bare_ = std::make_unique<btBoxShape>(
          btVector3(random.in(0.2F, 0.4F), random.in(0.2F, 0.4F), random.in(0.2F, 0.4F)));
      break;
  }
  if (!bare_) addLevels();
  btVector3 center;
  finest()->getBoundingSphere(center, radius_);
}

void Model::addLevels() {
  // Coarser hulls are of all points of the finer ones that they hold, with the same margin.
  for (auto& level : levels_) level = std::make_unique<btCompoundShape>();
  addCoarser(2, 1);
  addCoarser(1, 8);
  addCoarser(0, hulls_.size());
  for (auto& level : levels_) {
    if (const char* mistake = set_.addLevel(level.get())) throw std::runtime_error(mistake);
  }
}

void Model::addHull(std::vector<btVector3> points) {
  hulls_.push_back(std::move(points));
}

// 64 hulls along a body of 2.4 m.
void Model::addShip(Random& random) {
  constexpr int kHulls = 64;
  for (int i = 0; i < kHulls; ++i) {
    const float along = 2.4F * (static_cast<float>(i) + 0.5F) / kHulls - 1.2F;
    const float wide = 0.5F - 0.25F * std::abs(along);
    const btVector3 center(along, random.in(-0.2F, 0.2F), random.in(-wide, wide));
    std::vector<btVector3> points;
    for (int k = 0; k < 14; ++k) points.push_back(center + random.inCube(0.16F));
    addHull(std::move(points));
  }
}

// A rim, spokes and a hub: 37 to 45 hulls.
void Model::addWheel(Random& random) {
  const int segments = random.in(24, 30);
  const int spokes = random.in(12, 14);
  const float outer = random.in(0.42F, 0.5F);
  const float inner = 0.8F * outer;
  const float half = random.in(0.1F, 0.14F);
  const auto at = [](float radius, float angle, float y) {
    return btVector3(radius * std::cos(angle), y, radius * std::sin(angle));
  };
  for (int i = 0; i < segments; ++i) {
    const float from = 2 * SIMD_PI * static_cast<float>(i) / static_cast<float>(segments);
    const float to = 2 * SIMD_PI * static_cast<float>(i + 1) / static_cast<float>(segments);
    std::vector<btVector3> points;
    for (const float y : {-half, half}) {
      for (const float angle : {from, to}) {
        points.push_back(at(inner, angle, y));
        points.push_back(at(outer, angle, y));
      }
    }
    addHull(std::move(points));
  }
  for (int i = 0; i < spokes; ++i) {
    const float angle = 2 * SIMD_PI * static_cast<float>(i) / static_cast<float>(spokes);
    std::vector<btVector3> points;
    for (const float y : {-0.4F * half, 0.4F * half}) {
      for (const float off : {-0.06F, 0.06F}) {
        points.push_back(at(0.2F * outer, angle + 4 * off, y));
        points.push_back(at(inner, angle + off, y));
      }
    }
    addHull(std::move(points));
  }
  std::vector<btVector3> hub;
  for (int i = 0; i < 8; ++i) {
    for (const float y : {-0.8F * half, 0.8F * half}) {
      hub.push_back(at(0.22F * outer, SIMD_PI / 4 * static_cast<float>(i), y));
    }
  }
  addHull(std::move(hub));
}

// As thin as a board, and as wide as a table.
void Model::addPlate(Random& random) {
  const float half = random.in(0.01F, 0.08F);
  for (int x = -1; x <= 1; ++x) {
    std::vector<btVector3> points;
    for (int k = 0; k < 10; ++k) {
      const btVector3 point = random.inCube(1.0F) * btVector3(0.25F, half, 0.25F);
      points.push_back(point + btVector3(0.4F * static_cast<float>(x), 0, 0));
    }
    addHull(std::move(points));
  }
}

void Model::addCoarser(int level, std::size_t group) {
  for (std::size_t first = 0; first < hulls_.size(); first += group) {
    std::vector<btVector3> points;
    for (std::size_t i = first; i < std::min(first + group, hulls_.size()); ++i) {
      points.insert(points.end(), hulls_[i].begin(), hulls_[i].end());
    }
    auto hull = hullOf(points);
    levels_[level]->addChildShape(btTransform::getIdentity(), hull.get());
    shapes_.push_back(std::move(hull));
  }
}

}  // namespace scatter::bench
