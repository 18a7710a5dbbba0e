// Jolt with its own settings, but for: only what may rest in the scene sleeps, no damping but the scene's,
// friction and restitution multiplied as the scenes mean them, mass and inertia those of the finest level.

#include <Jolt/Jolt.h>
// Jolt's header must come first.
#include <Jolt/ConfigurationString.h>
#include <Jolt/Core/Factory.h>
#include <Jolt/Core/JobSystemSingleThreaded.h>
#include <Jolt/Core/JobSystemThreadPool.h>
#include <Jolt/Core/TempAllocator.h>
#include <Jolt/Physics/Body/BodyCreationSettings.h>
#include <Jolt/Physics/Collision/BroadPhase/BroadPhaseLayerInterfaceTable.h>
#include <Jolt/Physics/Collision/BroadPhase/ObjectVsBroadPhaseLayerFilterTable.h>
#include <Jolt/Physics/Collision/ContactListener.h>
#include <Jolt/Physics/Collision/ObjectLayerPairFilterTable.h>
#include <Jolt/Physics/Collision/Shape/BoxShape.h>
#include <Jolt/Physics/Collision/Shape/ConvexHullShape.h>
#include <Jolt/Physics/Collision/Shape/MeshShape.h>
#include <Jolt/Physics/Collision/Shape/OffsetCenterOfMassShape.h>
#include <Jolt/Physics/Collision/Shape/PlaneShape.h>
#include <Jolt/Physics/Collision/Shape/SphereShape.h>
#include <Jolt/Physics/Collision/Shape/StaticCompoundShape.h>
#include <Jolt/Physics/PhysicsSystem.h>
#include <Jolt/RegisterTypes.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string_view>

#include "engine_physics.h"

namespace scatter::bench {

namespace {

constexpr JPH::ObjectLayer kMoving = 0;
constexpr JPH::ObjectLayer kStill = 1;
constexpr JPH::uint kLayers = 2;
constexpr JPH::BroadPhaseLayer kMovingPhase(0);
constexpr JPH::BroadPhaseLayer kStillPhase(1);
constexpr JPH::uint kMostBodies = 4096;
constexpr JPH::uint kMostPairs = 65536;
constexpr JPH::uint kMostContacts = 65536;
constexpr JPH::uint kScratchBytes = 256U * 1024U * 1024U;

JPH::Vec3 toJolt(const Vec3& v) {
  return {v.x, v.y, v.z};
}
JPH::Quat toJolt(const Quat& q) {
  return {q.x, q.y, q.z, q.w};
}
Vec3 fromJolt(const JPH::Vec3& v) {
  return {v.GetX(), v.GetY(), v.GetZ()};
}

std::unique_ptr<JPH::JobSystem> makeJobs(int threads) {
  if (threads == 1) return std::make_unique<JPH::JobSystemSingleThreaded>(JPH::cMaxPhysicsJobs);
  return std::make_unique<JPH::JobSystemThreadPool>(JPH::cMaxPhysicsJobs, JPH::cMaxPhysicsBarriers,
                                                    threads - 1);
}

/// Jolt's types are registered once in a process.
class Library {
 public:
  Library() {
    JPH::RegisterDefaultAllocator();
    JPH::Factory::sInstance = new JPH::Factory();
    JPH::RegisterTypes();
  }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  ~Library() {
    JPH::UnregisterTypes();
    delete JPH::Factory::sInstance;
    JPH::Factory::sInstance = nullptr;
  }
};

class ContactCounter final : public JPH::ContactListener {
 public:
  void OnContactAdded(const JPH::Body&, const JPH::Body&, const JPH::ContactManifold& manifold,
                      JPH::ContactSettings&) override {
    count(manifold);
  }
  void OnContactPersisted(const JPH::Body&, const JPH::Body&, const JPH::ContactManifold& manifold,
                          JPH::ContactSettings&) override {
    count(manifold);
  }

  void reset() { *this = {}; }

  std::uint32_t manifolds = 0;
  std::uint32_t points = 0;
  float deepest = 0.0F;

 private:
  void count(const JPH::ContactManifold& manifold) {
    ++manifolds;
    points += static_cast<std::uint32_t>(manifold.mRelativeContactPointsOn1.size());
    deepest = std::max(deepest, manifold.mPenetrationDepth);
  }
};

float combinedFriction(const JPH::Body& a, const JPH::SubShapeID&, const JPH::Body& b,
                       const JPH::SubShapeID&) {
  return a.GetFriction() * b.GetFriction();
}
float combinedRestitution(const JPH::Body& a, const JPH::SubShapeID&, const JPH::Body& b,
                          const JPH::SubShapeID&) {
  return a.GetRestitution() * b.GetRestitution();
}

class JoltPhysics final : public EnginePhysics {
 public:
  JoltPhysics(const EngineOptions& options, const Vec3& gravity)
      : EnginePhysics(options),
        convexRadius_(options.convexRadius.value_or(JPH::cDefaultConvexRadius)),
        collisionSteps_(options.subSteps.value_or(1)),
        scratch_(kScratchBytes),
        jobs_(makeJobs(options.threads)),
        phases_(kLayers, kLayers),
        layers_(kLayers) {
    phases_.MapObjectToBroadPhaseLayer(kMoving, kMovingPhase);
    phases_.MapObjectToBroadPhaseLayer(kStill, kStillPhase);
    layers_.EnableCollision(kMoving, kMoving);
    layers_.EnableCollision(kMoving, kStill);
    phaseFilter_ =
        std::make_unique<JPH::ObjectVsBroadPhaseLayerFilterTable>(phases_, kLayers, layers_, kLayers);
    system_.Init(kMostBodies, 0, kMostPairs, kMostContacts, phases_, *phaseFilter_, layers_);
    JPH::PhysicsSettings settings;
    if (options.iterations) settings.mNumVelocitySteps = static_cast<JPH::uint>(*options.iterations);
    system_.SetPhysicsSettings(settings);
    system_.SetGravity(toJolt(gravity));
    system_.SetCombineFriction(combinedFriction);
    system_.SetCombineRestitution(combinedRestitution);
    if (options.countContacts) system_.SetContactListener(&counter_);
  }

  ~JoltPhysics() override {
    for (const JPH::BodyID body : bodies_) {
      interface().RemoveBody(body);
      interface().DestroyBody(body);
    }
  }

  [[nodiscard]] std::string engine() const override {
    return "jolt " + std::to_string(JPH_VERSION_MAJOR) + "." + std::to_string(JPH_VERSION_MINOR) + "." +
           std::to_string(JPH_VERSION_PATCH) + " (" + JPH::GetConfigurationString() + ")";
  }

  [[nodiscard]] BodyState state(BodyId body) const override {
    const JPH::BodyID id = bodies_[indexOf(body)];
    JPH::RVec3 position;
    JPH::Quat rotation = JPH::Quat::sIdentity();
    interface().GetPositionAndRotation(id, position, rotation);
    BodyState state;
    state.pose = {fromJolt(position),
                  Quat(rotation.GetW(), rotation.GetX(), rotation.GetY(), rotation.GetZ())};
    state.centerOfMass = fromJolt(interface().GetCenterOfMassPosition(id));
    state.linearVelocity = fromJolt(interface().GetLinearVelocity(id));
    state.angularVelocity = fromJolt(interface().GetAngularVelocity(id));
    state.asleep = !interface().IsActive(id);
    return state;
  }

  void applyCentralForce(BodyId body, const Vec3& force, bool) override {
    interface().AddForce(bodies_[indexOf(body)], toJolt(force), JPH::EActivation::DontActivate);
  }

  void step(float seconds) override {
    if (!optimized_) {
      system_.OptimizeBroadPhase();
      optimized_ = true;
    }
    counter_.reset();
    const JPH::EPhysicsUpdateError error = system_.Update(seconds, collisionSteps_, &scratch_, jobs_.get());
    if (error == JPH::EPhysicsUpdateError::None) return;
    std::fprintf(stderr, "engine_jolt: a buffer was too small and contacts were lost (error %u)\n",
                 static_cast<unsigned>(error));
    std::abort();
  }

 protected:
  Result<void> addBody(const EngineBodyDef& body) override {
    Result<JPH::ShapeRefC> shape = shapeOf(body);
    if (!shape) return tl::unexpected(shape.error());
    if (body.def.motion == Motion::kStatic) return addStill(body.def, *shape);
    JPH::BodyCreationSettings settings(*shape, toJolt(body.def.pose.position), toJolt(body.def.pose.rotation),
                                       JPH::EMotionType::Dynamic, kMoving);
    settings.mFriction = body.def.material.friction;
    settings.mRestitution = body.def.material.restitution;
    settings.mLinearDamping = body.def.material.linearDamping;
    settings.mAngularDamping = body.def.material.angularDamping;
    settings.mLinearVelocity = toJolt(body.def.linearVelocity);
    settings.mAngularVelocity = toJolt(body.def.angularVelocity);
    settings.mAllowSleeping = body.def.mayRest;
    settings.mOverrideMassProperties = JPH::EOverrideMassProperties::MassAndInertiaProvided;
    settings.mMassPropertiesOverride.mMass = body.def.mass;
    const Mat3 inertia = body.mass.inertia * body.def.mass;
    for (int i = 0; i < 3; ++i) {
      settings.mMassPropertiesOverride.mInertia.SetColumn3(static_cast<JPH::uint>(i), toJolt(inertia[i]));
    }
    settings.mMassPropertiesOverride.mInertia(3, 3) = 1.0F;
    bodies_.push_back(interface().CreateAndAddBody(settings, JPH::EActivation::Activate));
    return {};
  }

  Result<void> addGround(const BodyDef& def, const Plane& plane) override {
    constexpr float kReach = 1000.0F;  // metres
    return addStill(def,
                    new JPH::PlaneShape(JPH::Plane(toJolt(plane.normal), -plane.offset), nullptr, kReach));
  }

  Result<void> addGround(const BodyDef& def, const TriangleMesh& triangles) override {
    JPH::VertexList vertices;
    for (const Vec3& v : triangles.vertices) vertices.emplace_back(v.x, v.y, v.z);
    JPH::IndexedTriangleList faces;
    for (const auto& [a, b, c] : triangles.triangles) faces.emplace_back(a, b, c, 0U);
    const auto made = JPH::MeshShapeSettings(std::move(vertices), std::move(faces)).Create();
    if (made.HasError()) return fail("body \"" + def.name + "\": " + std::string(made.GetError().c_str()));
    return addStill(def, made.Get());
  }

  Contacts countContacts() const override {
    return {.manifolds = counter_.manifolds,
            .points = counter_.points,
            .deepest = static_cast<double>(counter_.deepest)};
  }

 private:
  JPH::BodyInterface& interface() const { return system_.GetBodyInterfaceNoLock(); }

  Result<void> addStill(const BodyDef& def, const JPH::ShapeRefC& shape) {
    JPH::BodyCreationSettings settings(shape, toJolt(def.pose.position), toJolt(def.pose.rotation),
                                       JPH::EMotionType::Static, kStill);
    settings.mFriction = def.material.friction;
    settings.mRestitution = def.material.restitution;
    bodies_.push_back(interface().CreateAndAddBody(settings, JPH::EActivation::DontActivate));
    return {};
  }

  Result<JPH::ShapeRefC> shapeOf(const EngineBodyDef& body) {
    JPH::ShapeRefC& shared = shapes_[&body.parts];
    if (shared != nullptr) return shared;
    JPH::StaticCompoundShapeSettings compound;
    for (const ConvexPart& part : body.parts) {
      if (!addPart(compound, part)) return unknownPart(body);
    }
    // A compound of one part would cost a tree for nothing.
    const bool plain = body.parts.size() == 1 && isInPlace(body.parts[0]);
    const JPH::ShapeSettings::ShapeResult made =
        plain ? compound.mSubShapes[0].mShape->Create() : compound.Create();
    if (made.HasError()) {
      const std::string_view reason = made.GetError();
      return fail("body \"" + body.def.name + "\": " + std::string(reason));
    }
    shared = withCenter(*made.Get(), body.mass.centerOfMass);
    return shared;
  }

  /// The centre of mass is the finest level's, also at level 1.
  static JPH::ShapeRefC withCenter(const JPH::Shape& shape, const Vec3& center) {
    constexpr float kNegligible = 1e-3F;  // metres: how Jolt rounds hulls moves it by less
    const JPH::Vec3 offset = toJolt(center) - shape.GetCenterOfMass();
    if (offset.Length() < kNegligible) return &shape;
    return new JPH::OffsetCenterOfMassShape(&shape, offset);
  }

  static bool isInPlace(const ConvexPart& part) {
    return std::holds_alternative<ConvexHull>(part.shape) ||
           (part.pose.position == Vec3(0.0F) && part.pose.rotation == kNoRotation);
  }

  bool addPart(JPH::StaticCompoundShapeSettings& compound, const ConvexPart& part) const {
    const JPH::Vec3 position = toJolt(part.pose.position);
    const JPH::Quat rotation = toJolt(part.pose.rotation);
    if (const auto* hull = std::get_if<ConvexHull>(&part.shape)) {
      JPH::Array<JPH::Vec3> points;
      for (const Vec3& vertex : placedVertices(*hull, part.pose)) points.push_back(toJolt(vertex));
      compound.AddShape(JPH::Vec3::sZero(), JPH::Quat::sIdentity(),
                        new JPH::ConvexHullShapeSettings(points, convexRadius_));
      return true;
    }
    if (const auto* box = std::get_if<Box>(&part.shape)) {
      compound.AddShape(position, rotation, new JPH::BoxShapeSettings(toJolt(box->halfExtents)));
      return true;
    }
    if (const auto* sphere = std::get_if<Sphere>(&part.shape)) {
      compound.AddShape(position, rotation, new JPH::SphereShapeSettings(sphere->radius));
      return true;
    }
    return false;
  }

  float convexRadius_;
  int collisionSteps_;
  JPH::TempAllocatorImpl scratch_;
  std::unique_ptr<JPH::JobSystem> jobs_;
  JPH::BroadPhaseLayerInterfaceTable phases_;
  JPH::ObjectLayerPairFilterTable layers_;
  std::unique_ptr<JPH::ObjectVsBroadPhaseLayerFilterTable> phaseFilter_;
  ContactCounter counter_;
  mutable JPH::PhysicsSystem system_;
  std::map<const void*, JPH::ShapeRefC> shapes_;  ///< By their list of parts.
  std::vector<JPH::BodyID> bodies_;
  bool optimized_ = false;
};

}  // namespace

EngineInfo engineInfo() {
  return {.program = "engine_jolt"};
}

Result<std::unique_ptr<Physics>> makeEngine(const EngineOptions& options, const PhysicsDef& def) {
  if (options.boxes || options.pairAlgorithm || options.lean) {
    return fail("Jolt's measurement has no --boxes, no --pair-algorithm and no --lean");
  }
  static Library library;
  return std::make_unique<JoltPhysics>(options, def.gravity);
}

}  // namespace scatter::bench
