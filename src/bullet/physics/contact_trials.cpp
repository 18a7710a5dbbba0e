#include <BulletCollision/CollisionShapes/btBox2dShape.h>
#include <BulletCollision/CollisionShapes/btConvex2dShape.h>
#include <BulletCollision/CollisionShapes/btConvexPointCloudShape.h>
#include <BulletCollision/CollisionShapes/btConvexTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btMinkowskiSumShape.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <BulletHybrid/btHybridDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>
#include <scatter/bullet/contact_trials.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <functional>
#include <iterator>
#include <memory>
#include <random>
#include <span>
#include <utility>

namespace scatter {

namespace {

constexpr int kSteps = 60;
constexpr int kHybrids = 4;
constexpr int kMostParts = 5;

/// Random numbers that are the same everywhere: std's distributions are not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  float between(float low, float high) {
    return low + (high - low) * (static_cast<float>(engine_() >> 40U) / 16777216.0F);
  }
  float logBetween(float low, float high) { return std::exp(between(std::log(low), std::log(high))); }
  int index(int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }
  bool chance(float probability) { return between(0.0F, 1.0F) < probability; }

  btVector3 inCube(float half) {
    const float x = between(-half, half);
    const float y = between(-half, half);
    return {x, y, between(-half, half)};
  }
  btVector3 direction() {
    for (;;) {
      const btVector3 v = inCube(1.0F);
      if (v.length2() > 0.01F && v.length2() <= 1.0F) return v.normalized();
    }
  }
  btQuaternion rotation(float most = SIMD_PI) {
    const btVector3 axis = direction();
    return {axis, between(-most, most)};
  }

 private:
  std::mt19937_64 engine_;
};

/// A program's own shape: a half ball, which says of itself what Bullet's cones say.
class HalfBall : public btConvexInternalShape {
 public:
  explicit HalfBall(float radius) : radius_(radius) { m_shapeType = CUSTOM_CONVEX_SHAPE_TYPE; }

  [[nodiscard]] btVector3 localGetSupportingVertexWithoutMargin(const btVector3& vec) const override {
    btVector3 direction = vec;
    direction.setY(std::max(direction.y(), 0.0F));
    return direction.fuzzyZero() ? btVector3(0, 0, 0) : direction.normalized() * radius_;
  }
  void batchedUnitVectorGetSupportingVertexWithoutMargin(const btVector3* vectors, btVector3* vertices,
                                                         int count) const override {
    std::transform(vectors, vectors + count, vertices,
                   [this](const btVector3& v) { return localGetSupportingVertexWithoutMargin(v); });
  }
  void calculateLocalInertia(btScalar, btVector3& inertia) const override { inertia.setValue(1, 1, 1); }
  [[nodiscard]] const char* getName() const override { return "HalfBall"; }

 private:
  float radius_;
};

/// What the shapes of a world have in common.
struct Proportions {
  float size = 1.0F;  ///< Metres, across.
  enum class Form { kCompact, kNeedle, kPlate } form = Form::kCompact;
};

/// Makes shapes and owns them.
class ShapeMaker {
 public:
  ShapeMaker(Random& random, const Proportions& proportions) : random_(random), proportions_(proportions) {}

  template <class Shape, class... Args>
  Shape* make(Args&&... args) {
    auto owned = std::make_unique<Shape>(std::forward<Args>(args)...);
    Shape* raw = owned.get();
    shapes_.push_back(std::move(owned));
    return raw;
  }

  /// Three half extents of about the size; the second is the odd one of needles and plates.
  btVector3 half() {
    const float size = proportions_.size;
    const auto some = [&] { return size * random_.between(0.15F, 0.5F); };
    const float thin = size * random_.logBetween(0.0005F, 0.005F);
    switch (proportions_.form) {
      case Proportions::Form::kNeedle:
        return {thin, some(), thin};
      case Proportions::Form::kPlate:
        return {some(), thin, some()};
      case Proportions::Form::kCompact:
        break;
    }
    const float a = some();
    const float b = some();
    return {a, b, some()};
  }

  btVector3 pointIn(const btVector3& half) { return random_.direction() * half; }

  btConvexShape* withMargin(btConvexShape* shape) const {
    if (odd_) shape->setMargin(oddMargin_ * proportions_.size);
    // Hulls keep bounds with the margin that they had.
    if (auto* hull = dynamic_cast<btPolyhedralConvexAabbCachingShape*>(shape)) hull->recalcLocalAabb();
    return shape;
  }

  btConvexHullShape* hull(int points) {
    auto* shape = make<btConvexHullShape>();
    const btVector3 reach = half();
    for (int i = 0; i < points; ++i) shape->addPoint(pointIn(reach), false);
    shape->recalcLocalAabb();
    return shape;
  }

  btStridingMeshInterface* mesh(int triangles) {
    meshes_.push_back(std::make_unique<btTriangleMesh>());
    const btVector3 reach = half();
    for (int i = 0; i < triangles; ++i) {
      const btVector3 a = pointIn(reach);
      const btVector3 b = pointIn(reach);
      meshes_.back()->addTriangle(a, b, pointIn(reach));
    }
    return meshes_.back().get();
  }

  /// Memory for points that a shape only points to.
  btAlignedObjectArray<btVector3>& points(int count) {
    clouds_.push_back(std::make_unique<btAlignedObjectArray<btVector3>>());
    const btVector3 reach = half();
    for (int i = 0; i < count; ++i) clouds_.back()->push_back(pointIn(reach));
    return *clouds_.back();
  }

  const btHybridLevelSet& level(btCollisionShape* shape) {
    levels_.push_back(std::make_unique<btHybridLevelSet>());
    levels_.back()->addLevel(shape);
    return *levels_.back();
  }

  /// All shapes of a world have Bullet's margin, or all one of their own.
  void chooseMargin() {
    odd_ = random_.chance(0.6F);
    oddMargin_ = random_.chance(0.2F) ? 0.0F : random_.logBetween(1e-5F, 0.2F);
  }

  Random& random() { return random_; }
  [[nodiscard]] float size() const { return proportions_.size; }

 private:
  Random& random_;
  Proportions proportions_;
  bool odd_ = false;
  float oddMargin_ = 0.0F;
  std::vector<std::unique_ptr<btTriangleMesh>> meshes_;
  std::vector<std::unique_ptr<btAlignedObjectArray<btVector3>>> clouds_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btHybridLevelSet>> levels_;
};

struct Kind {
  const char* name;
  std::function<btConvexShape*(ShapeMaker&)> make;
};

/// Radius and height from the half extents.
template <class Shape>
btConvexShape* round(ShapeMaker& maker) {
  const btVector3 half = maker.half();
  return maker.make<Shape>(half.x(), 2.0F * half.y());
}

template <class Shape, int axis>
btConvexShape* cylinder(ShapeMaker& maker) {
  const btVector3 half = maker.half();
  btVector3 extents(half.x(), half.x(), half.x());
  extents[axis] = half.y();
  return maker.make<Shape>(extents);
}

btConvexShape* multiSphere(ShapeMaker& maker) {
  std::array<btVector3, 3> centres;
  std::array<btScalar, 3> radii{};
  const btVector3 half = maker.half();
  for (std::size_t i = 0; i < centres.size(); ++i) {
    centres[i] = maker.pointIn(half) * 0.7F;
    radii[i] = half.x() * maker.random().between(0.3F, 1.0F);
  }
  return maker.make<btMultiSphereShape>(centres.data(), radii.data(), 3);
}

btConvexShape* tetrahedron(ShapeMaker& maker) {
  const btAlignedObjectArray<btVector3>& p = maker.points(4);
  return maker.make<btBU_Simplex1to4>(p[0], p[1], p[2], p[3]);
}

btConvexShape* pointCloud(ShapeMaker& maker) {
  btAlignedObjectArray<btVector3>& p = maker.points(12);
  return maker.make<btConvexPointCloudShape>(&p[0], p.size(), btVector3(1, 1, 1));
}

btConvexShape* triangle(ShapeMaker& maker) {
  const btAlignedObjectArray<btVector3>& p = maker.points(3);
  return maker.make<btTriangleShape>(p[0], p[1], p[2]);
}

btConvexShape* featuredHull(ShapeMaker& maker) {
  btConvexHullShape* hull = maker.hull(12);
  hull->initializePolyhedralFeatures();
  return hull;
}

const std::vector<Kind>& simpleKinds() {
  static const std::vector<Kind> kinds{
      {"box", [](ShapeMaker& m) { return m.make<btBoxShape>(m.half()); }},
      {"sphere", [](ShapeMaker& m) { return m.make<btSphereShape>(m.half().y()); }},
      {"capsule y", round<btCapsuleShape>},
      {"capsule x", round<btCapsuleShapeX>},
      {"capsule z", round<btCapsuleShapeZ>},
      {"cylinder y", cylinder<btCylinderShape, 1>},
      {"cylinder x", cylinder<btCylinderShapeX, 0>},
      {"cylinder z", cylinder<btCylinderShapeZ, 2>},
      {"cone y", round<btConeShape>},
      {"cone x", round<btConeShapeX>},
      {"cone z", round<btConeShapeZ>},
      {"hull", [](ShapeMaker& m) { return m.hull(4 + m.random().index(20)); }},
      {"hull with features", featuredHull},
      {"multi-sphere", multiSphere},
      {"tetrahedron", tetrahedron},
      {"point cloud", pointCloud},
      {"triangle", triangle},
      {"triangle mesh", [](ShapeMaker& m) { return m.make<btConvexTriangleMeshShape>(m.mesh(6)); }},
      {"box 2d", [](ShapeMaker& m) { return m.make<btBox2dShape>(m.half()); }},
      {"own shape", [](ShapeMaker& m) { return m.make<HalfBall>(m.half().y()); }},
  };
  return kinds;
}

btConvexShape* anySimple(ShapeMaker& maker) {
  const std::vector<Kind>& kinds = simpleKinds();
  return maker.withMargin(
      kinds[static_cast<std::size_t>(maker.random().index(static_cast<int>(kinds.size())))].make(maker));
}

/// Wrappers of other shapes besides.
const std::vector<Kind>& allKinds() {
  static const std::vector<Kind> kinds = [] {
    std::vector<Kind> all = simpleKinds();
    all.push_back({"sum", [](ShapeMaker& m) {
                     btConvexShape* one = anySimple(m);
                     return m.make<btMinkowskiSumShape>(one, anySimple(m));
                   }});
    all.push_back({"convex 2d", [](ShapeMaker& m) { return m.make<btConvex2dShape>(anySimple(m)); }});
    for (const Kind& kind : simpleKinds()) {
      all.push_back({nullptr, [make = kind.make](ShapeMaker& m) {
                       btConvexShape* inner = m.withMargin(make(m));
                       return m.make<btUniformScalingShape>(inner, m.random().between(0.5F, 2.0F));
                     }});
    }
    return all;
  }();
  return kinds;
}

std::string nameOf(std::size_t kind) {
  const char* const name = allKinds()[kind].name;
  return name != nullptr
             ? name
             : std::string("scaled ") + simpleKinds()[kind - (allKinds().size() - simpleKinds().size())].name;
}

btConvexShape* makeOne(ShapeMaker& maker, std::size_t kind) {
  btConvexShape* shape = allKinds()[kind].make(maker);
  // A margin of a wrapper is that of what it wraps.
  return kind < simpleKinds().size() ? maker.withMargin(shape) : shape;
}

/// A way through the middle of the world, in sizes of a body.
class Path {
 public:
  Path(Random& random, float size)
      : random_(random),
        size_(size),
        kind_(random.index(5)),
        turn_(random.rotation()),
        offset_(random.inCube(0.6F) * size),
        direction_(random.direction()),
        axis_(random.direction()),
        speed_(random.logBetween(1e-4F, 0.3F)) {}

  btTransform next() {
    switch (kind_) {
      case 0:  // at rest
        break;
      case 1:  // it jumps
        if (random_.chance(0.2F)) {
          offset_ = random_.inCube(0.6F) * size_;
          turn_ = random_.rotation();
        }
        break;
      case 2:  // it trembles
        return btTransform(turn_ * random_.rotation(1e-4F), offset_ + random_.inCube(1e-4F) * size_);
      default:
        offset_ += direction_ * (speed_ * size_);
        turn_ = (btQuaternion(axis_, speed_) * turn_).normalized();
        // Back through the middle, so that the paths keep crossing.
        if (offset_.length() > size_) direction_ = -(offset_ + axis_ * (0.3F * size_)).normalized();
    }
    return btTransform(turn_, offset_);
  }

 private:
  Random& random_;
  float size_;
  int kind_;
  btQuaternion turn_;
  btVector3 offset_;
  btVector3 direction_;
  btVector3 axis_;
  float speed_;
};

class TrialWorld {
 public:
  TrialWorld(std::size_t kind, std::uint64_t seed)
      : random_(seed * 1000003U + kind), maker_(random_, proportions(random_)) {
    maker_.chooseMargin();
    world_.getSwitchingInfo().m_proximity = false;
    if (random_.chance(0.3F)) {
      dispatcher_.setDispatcherFlags(dispatcher_.getDispatcherFlags() &
                                     ~btCollisionDispatcher::CD_USE_RELATIVE_CONTACT_BREAKING_THRESHOLD);
    }
    centre_ = random_.chance(0.2F) ? random_.direction() * (100.0F * maker_.size()) : btVector3(0, 0, 0);
    for (int i = 0; i < kHybrids; ++i) addHybrid(compound(kind));
    addOther(compound(kind));
    addOther(makeOne(maker_, kind));
    addOther(anySimple(maker_));
    world_.verifyContacts(1);
  }
  TrialWorld(const TrialWorld&) = delete;
  TrialWorld& operator=(const TrialWorld&) = delete;
  ~TrialWorld() {
    for (auto& body : bodies_) world_.removeRigidBody(body.get());
  }

  const btHybridContactReport& run() {
    for (int step = 0; step < kSteps; ++step) {
      for (std::size_t i = 0; i < bodies_.size(); ++i) {
        btTransform pose = paths_[i].next();
        pose.setOrigin(pose.getOrigin() + centre_);
        bodies_[i]->setWorldTransform(pose);
        bodies_[i]->setInterpolationWorldTransform(pose);
      }
      world_.performDiscreteCollisionDetection();
    }
    return world_.getContactReport();
  }

 private:
  static Proportions proportions(Random& random) {
    const float size = random.logBetween(0.01F, 100.0F);
    return {size, static_cast<Proportions::Form>(random.index(3))};
  }

  btCollisionShape* compound(std::size_t kind) {
    auto* shape = maker_.make<btCompoundShape>(random_.chance(0.9F));
    const int parts = 1 + random_.index(kMostParts);
    for (int i = 0; i < parts; ++i) {
      const btVector3 place = random_.inCube(0.3F) * (parts > 1 ? maker_.size() : 0.0F);
      shape->addChildShape(btTransform(random_.rotation(), place), makeOne(maker_, kind));
    }
    return shape;
  }

  static btRigidBody::btRigidBodyConstructionInfo info(btCollisionShape* shape) {
    return {1.0F, nullptr, shape, btVector3(1, 1, 1)};
  }

  void addHybrid(btCollisionShape* shape) {
    add(std::make_unique<btHybridRigidBody>(info(shape), &maker_.level(shape), 1));
  }
  void addOther(btCollisionShape* shape) { add(std::make_unique<btRigidBody>(info(shape))); }

  void add(std::unique_ptr<btRigidBody> body) {
    body->setActivationState(DISABLE_DEACTIVATION);
    world_.addRigidBody(body.get());
    bodies_.push_back(std::move(body));
    paths_.emplace_back(random_, maker_.size());
  }

  Random random_;
  ShapeMaker maker_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btHybridDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  btVector3 centre_{0, 0, 0};
  std::vector<Path> paths_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

}  // namespace

ContactTrial& ContactTrial::operator+=(const ContactTrial& other) {
  worlds += other.worlds;
  childPairs += other.childPairs;
  expected += other.expected;
  missed += other.missed;
  extra += other.extra;
  doubtful += other.doubtful;
  engineErrs += other.engineErrs;
  return *this;
}

std::vector<std::string> contactTrialShapes() {
  std::vector<std::string> names;
  for (std::size_t kind = 0; kind < allKinds().size(); ++kind) names.push_back(nameOf(kind));
  return names;
}

ContactTrial runContactTrial(const std::string& shape, std::uint64_t seed) {
  const std::vector<std::string> names = contactTrialShapes();
  const auto kind = std::find(names.begin(), names.end(), shape);
  assert(kind != names.end());
  TrialWorld world(static_cast<std::size_t>(std::distance(names.begin(), kind)), seed);
  const btHybridContactReport& report = world.run();
  const auto wide = [](long count) { return static_cast<std::uint64_t>(count); };
  return {.shape = shape,
          .worlds = 1,
          .childPairs = wide(report.m_childPairs),
          .expected = wide(report.m_expected),
          .missed = wide(report.m_missed),
          .extra = wide(report.m_extra),
          .doubtful = wide(report.m_doubtful),
          .engineErrs = wide(report.m_bulletErrs)};
}

}  // namespace scatter
