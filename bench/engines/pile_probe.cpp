#include "pile_probe.h"

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace scatter::bench {

namespace {

constexpr float kProbeMargin = 0.001F;  // metres; Bullet's detector works best with some
constexpr double kTouching = 0.02;      // metres; less than where Bullet drops a contact point
constexpr double kDeep = 0.05;          // metres
constexpr double kShare = 0.9;

btTransform toBullet(const Transform& t) {
  return btTransform(btQuaternion(t.rotation.x, t.rotation.y, t.rotation.z, t.rotation.w),
                     btVector3(t.position.x, t.position.y, t.position.z));
}

double radiusOf(const World& world) {
  std::vector<double> distances;
  for (const auto& object : world.objects()) {
    if (object->def().motion != Motion::kDynamic) continue;
    distances.push_back(static_cast<double>(glm::length(object->state().centerOfMass)));
  }
  if (distances.empty()) return 0.0;
  const auto rank = static_cast<std::size_t>(std::ceil(kShare * static_cast<double>(distances.size()))) - 1;
  std::nth_element(distances.begin(), distances.begin() + static_cast<std::ptrdiff_t>(rank), distances.end());
  return distances[rank];
}

std::unique_ptr<btConvexShape> convert(const ConvexShape& shape, float margin) {
  if (const auto* box = std::get_if<Box>(&shape)) {
    return std::make_unique<btBoxShape>(
        btVector3(box->halfExtents.x, box->halfExtents.y, box->halfExtents.z));
  }
  if (const auto* sphere = std::get_if<Sphere>(&shape))
    return std::make_unique<btSphereShape>(sphere->radius);
  const auto* hull = std::get_if<ConvexHull>(&shape);
  assert(hull != nullptr);
  auto made = std::make_unique<btConvexHullShape>();
  for (const Vec3& v : hull->vertices)
    made->addPoint(btVector3(v.x, v.y, v.z), /*recalculateLocalAabb=*/false);
  made->setMargin(margin);
  made->recalcLocalAabb();
  return made;
}

}  // namespace

/// Bullet's shapes of the world's objects; models share theirs.
class PileProbe::Shapes {
 public:
  explicit Shapes(bool hasMargins) : hasMargins_(hasMargins) {}

  btCollisionShape* of(const WorldObject& object) {
    const auto* levels = std::get_if<std::shared_ptr<const LevelSet>>(&object.def().shape);
    const void* key = levels != nullptr ? static_cast<const void*>(levels->get()) : &object;
    std::unique_ptr<btCompoundShape>& shape = compounds_[key];
    if (!shape) {
      shape = std::make_unique<btCompoundShape>();
      if (levels != nullptr) {
        const float margin = hasMargins_ ? (*levels)->hullMargin() : kProbeMargin;
        for (const ConvexPart& part : (*levels)->finest().parts) add(*shape, part.shape, part.pose, margin);
      } else if (const auto* sphere = std::get_if<Sphere>(&object.def().shape)) {
        add(*shape, *sphere, Transform{}, kProbeMargin);
      } else {
        const auto* box = std::get_if<Box>(&object.def().shape);
        assert(box != nullptr);
        add(*shape, *box, Transform{}, kProbeMargin);
      }
    }
    return shape.get();
  }

  /// How much closer the solids of the measured engine are than a contact of two such parts says: those of an
  /// engine without margins are not as large as the probe's.
  [[nodiscard]] double correction(const btCollisionObject& body, int part) const {
    const auto& compound = static_cast<const btCompoundShape&>(*body.getCollisionShape());
    const bool isHull =
        compound.getChildShape(std::max(part, 0))->getShapeType() == CONVEX_HULL_SHAPE_PROXYTYPE;
    return isHull && !hasMargins_ ? -static_cast<double>(kProbeMargin) : 0.0;
  }

 private:
  void add(btCompoundShape& compound, const ConvexShape& shape, const Transform& pose, float margin) {
    parts_.push_back(convert(shape, margin));
    compound.addChildShape(toBullet(pose), parts_.back().get());
  }

  bool hasMargins_;
  std::vector<std::unique_ptr<btConvexShape>> parts_;
  std::map<const void*, std::unique_ptr<btCompoundShape>> compounds_;
};

namespace {

/// The deepest overlap of each pair of bodies; negative where they are apart.
using Overlaps = std::map<std::pair<int, int>, double>;

Pile summarise(const Overlaps& overlaps) {
  Pile pile;
  std::set<int> touching;
  for (const auto& [bodies, overlap] : overlaps) {
    if (overlap < -kTouching) continue;
    touching.insert({bodies.first, bodies.second});
    ++pile.touchingPairs;
    pile.deepPairs += overlap > kDeep ? 1 : 0;
    pile.deepest = std::max(pile.deepest, overlap);
  }
  pile.touchingBodies = static_cast<int>(touching.size());
  return pile;
}

}  // namespace

PileProbe::PileProbe(bool hasMargins) : shapes_(std::make_unique<Shapes>(hasMargins)) {}
PileProbe::~PileProbe() = default;

Pile PileProbe::measure(const World& world) {
  // Everything is made anew, so that no contact of an earlier pose is left.
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btCollisionWorld probe(&dispatcher, &broadphase, &configuration);
  std::vector<std::unique_ptr<btCollisionObject>> objects;
  for (const auto& object : world.objects()) {
    if (object->def().motion != Motion::kDynamic) continue;
    auto copy = std::make_unique<btCollisionObject>();
    copy->setCollisionShape(shapes_->of(*object));
    copy->setWorldTransform(toBullet(object->state().pose));
    copy->setUserIndex(static_cast<int>(objects.size()));
    probe.addCollisionObject(copy.get());
    objects.push_back(std::move(copy));
  }
  probe.performDiscreteCollisionDetection();

  Overlaps overlaps;
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
    const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
    const btCollisionObject& a = *manifold.getBody0();
    const btCollisionObject& b = *manifold.getBody1();
    for (int j = 0; j < manifold.getNumContacts(); ++j) {
      const btManifoldPoint& point = manifold.getContactPoint(j);
      const double overlap = -static_cast<double>(point.getDistance()) +
                             shapes_->correction(a, point.m_index0) + shapes_->correction(b, point.m_index1);
      const std::pair<int, int> key = std::minmax({a.getUserIndex(), b.getUserIndex()});
      const auto [found, added] = overlaps.emplace(key, overlap);
      if (!added) found->second = std::max(found->second, overlap);
    }
  }
  for (const auto& object : objects) probe.removeCollisionObject(object.get());
  Pile pile = summarise(overlaps);
  pile.radius = radiusOf(world);
  return pile;
}

}  // namespace scatter::bench
