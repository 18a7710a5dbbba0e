// Box3D with its own settings, but for: only what may rest in the scene sleeps, one worker, friction and
// restitution multiplied as the scenes mean them, mass and inertia those of the finest level.

#include <box3d/box3d.h>

#include <algorithm>
#include <map>

#include "engine_physics.h"

namespace scatter::bench {

namespace {

constexpr int kSubSteps = 4;  // what Box3D's documentation recommends

b3Vec3 toBox3d(const Vec3& v) {
  return {v.x, v.y, v.z};
}
b3Quat toBox3d(const Quat& q) {
  return {{q.x, q.y, q.z}, q.w};
}
b3Matrix3 toBox3d(const Mat3& m) {
  return {toBox3d(m[0]), toBox3d(m[1]), toBox3d(m[2])};
}
Vec3 fromBox3d(const b3Vec3& v) {
  return {v.x, v.y, v.z};
}
Quat fromBox3d(const b3Quat& q) {
  return {q.s, q.v.x, q.v.y, q.v.z};
}

float product(float a, std::uint64_t, float b, std::uint64_t) {
  return a * b;
}

struct HullDeleter {
  void operator()(b3HullData* hull) const { b3DestroyHull(hull); }
};
using Hull = std::unique_ptr<b3HullData, HullDeleter>;

struct MeshDeleter {
  void operator()(b3MeshData* mesh) const { b3DestroyMesh(mesh); }
};
using Mesh = std::unique_ptr<b3MeshData, MeshDeleter>;

class Box3dPhysics final : public EnginePhysics {
 public:
  Box3dPhysics(const EngineOptions& options, const Vec3& gravity)
      : EnginePhysics(options), subSteps_(options.subSteps.value_or(kSubSteps)) {
    b3WorldDef def = b3DefaultWorldDef();
    def.gravity = toBox3d(gravity);
    def.workerCount = 1;
    def.frictionCallback = product;
    def.restitutionCallback = product;
    world_ = b3CreateWorld(&def);
  }
  ~Box3dPhysics() override { b3DestroyWorld(world_); }

  [[nodiscard]] std::string engine() const override {
    const b3Version version = b3GetVersion();
    return "box3d " + std::to_string(version.major) + "." + std::to_string(version.minor) + "." +
           std::to_string(version.revision);
  }

  [[nodiscard]] BodyState state(BodyId body) const override {
    const b3BodyId id = bodies_[indexOf(body)];
    BodyState state;
    state.pose = {fromBox3d(b3Body_GetPosition(id)), fromBox3d(b3Body_GetRotation(id))};
    state.centerOfMass = state.pose(centers_[indexOf(body)]);
    state.linearVelocity = fromBox3d(b3Body_GetLinearVelocity(id));
    state.angularVelocity = fromBox3d(b3Body_GetAngularVelocity(id));
    state.asleep = !b3Body_IsAwake(id);
    return state;
  }

  void applyCentralForce(BodyId body, const Vec3& force, bool wake) override {
    b3Body_ApplyForceToCenter(bodies_[indexOf(body)], toBox3d(force), wake);
  }

  void step(float seconds) override { b3World_Step(world_, seconds, subSteps_); }

 protected:
  Result<void> addBody(const EngineBodyDef& body) override {
    b3BodyDef def = b3DefaultBodyDef();
    def.type = b3_dynamicBody;
    def.linearDamping = body.def.material.linearDamping;
    def.angularDamping = body.def.material.angularDamping;
    def.enableSleep = body.def.mayRest;
    const bool isStill = body.def.motion == Motion::kStatic;
    const b3BodyId id = isStill ? createStill(body.def) : create(def, body.def.pose, body.mass.centerOfMass);
    for (const ConvexPart& part : body.parts) {
      if (auto added = addPart(id, part, body); !added) return added;
    }
    if (isStill) return {};
    b3Body_SetMassData(id, {.mass = body.def.mass,
                            .center = toBox3d(body.mass.centerOfMass),
                            .inertia = toBox3d(body.mass.inertia * body.def.mass)});
    b3Body_SetLinearVelocity(id, toBox3d(body.def.linearVelocity));
    b3Body_SetAngularVelocity(id, toBox3d(body.def.angularVelocity));
    return {};
  }

  /// A box whose upper side is the plane: Box3D has no half-spaces.
  Result<void> addGround(const BodyDef& def, const Plane& plane) override {
    constexpr float kReach = 1000.0F;  // metres
    constexpr float kThickness = 10.0F;
    const Vec3 up(0.0F, 1.0F, 0.0F);
    if (plane.normal != up) return fail("body \"" + def.name + "\": Box3D's measurement has level planes");
    const b3Transform pose{toBox3d(up * (plane.offset - kThickness)), toBox3d(kNoRotation)};
    const b3BoxHull made = b3MakeTransformedBoxHull(kReach, kThickness, kReach, pose);
    const b3ShapeDef shape = shapeDef(def.material);
    b3CreateHullShape(createStill(def), &shape, &made.base);
    return {};
  }

  Result<void> addGround(const BodyDef& def, const TriangleMesh& triangles) override {
    std::vector<b3Vec3> vertices;
    for (const Vec3& v : triangles.vertices) vertices.push_back(toBox3d(v));
    std::vector<std::int32_t> indices;
    for (const auto& triangle : triangles.triangles) {
      for (const std::uint32_t i : triangle) indices.push_back(static_cast<std::int32_t>(i));
    }
    b3MeshDef mesh{};
    mesh.vertices = vertices.data();
    mesh.indices = indices.data();
    mesh.vertexCount = static_cast<int>(vertices.size());
    mesh.triangleCount = static_cast<int>(triangles.triangles.size());
    mesh.identifyEdges = true;
    meshes_.emplace_back(b3CreateMesh(&mesh, nullptr, 0));
    if (!meshes_.back()) return fail("body \"" + def.name + "\": Box3D refuses its triangles");
    const b3ShapeDef shape = shapeDef(def.material);
    b3CreateMeshShape(createStill(def), &shape, meshes_.back().get(), {1.0F, 1.0F, 1.0F});
    return {};
  }

  /// Each contact is seen from both of its bodies.
  Contacts countContacts() const override {
    Contacts contacts;
    std::vector<b3ContactData> data;
    for (const b3BodyId body : bodies_) {
      data.resize(static_cast<std::size_t>(b3Body_GetContactCapacity(body)));
      const int count = b3Body_GetContactData(body, data.data(), static_cast<int>(data.size()));
      for (int i = 0; i < count; ++i) addContact(data[static_cast<std::size_t>(i)], contacts);
    }
    contacts.manifolds /= 2;
    contacts.points /= 2;
    return contacts;
  }

 private:
  b3BodyId create(b3BodyDef def, const Transform& pose, const Vec3& centerOfMass) {
    def.position = toBox3d(pose.position);
    def.rotation = toBox3d(pose.rotation);
    bodies_.push_back(b3CreateBody(world_, &def));
    centers_.push_back(centerOfMass);
    return bodies_.back();
  }

  b3BodyId createStill(const BodyDef& def) { return create(b3DefaultBodyDef(), def.pose, Vec3(0.0F)); }

  static b3ShapeDef shapeDef(const Material& material) {
    b3ShapeDef def = b3DefaultShapeDef();
    def.baseMaterial.friction = material.friction;
    def.baseMaterial.restitution = material.restitution;
    def.updateBodyMass = false;
    return def;
  }

  static void addContact(const b3ContactData& data, Contacts& contacts) {
    for (int i = 0; i < data.manifoldCount; ++i) {
      const b3Manifold& manifold = data.manifolds[i];
      ++contacts.manifolds;
      contacts.points += static_cast<std::uint32_t>(manifold.pointCount);
      for (int j = 0; j < manifold.pointCount; ++j) {
        contacts.deepest = std::max(contacts.deepest, -static_cast<double>(manifold.points[j].separation));
      }
    }
  }

  Result<void> addPart(b3BodyId id, const ConvexPart& part, const EngineBodyDef& body) {
    const b3ShapeDef def = shapeDef(body.def.material);
    if (const auto* hull = std::get_if<ConvexHull>(&part.shape)) {
      const b3HullData* made = hullOf(*hull, part.pose);
      if (made == nullptr) return fail("body \"" + body.def.name + "\": Box3D refuses one of its hulls");
      b3CreateHullShape(id, &def, made);
      return {};
    }
    if (const auto* box = std::get_if<Box>(&part.shape)) {
      const b3Transform pose{toBox3d(part.pose.position), toBox3d(part.pose.rotation)};
      const Vec3& half = box->halfExtents;
      const b3BoxHull made = b3MakeTransformedBoxHull(half.x, half.y, half.z, pose);
      b3CreateHullShape(id, &def, &made.base);
      return {};
    }
    if (const auto* sphere = std::get_if<Sphere>(&part.shape)) {
      const b3Sphere made{toBox3d(part.pose.position), sphere->radius};
      b3CreateSphereShape(id, &def, &made);
      return {};
    }
    return unknownPart(body);
  }

  const b3HullData* hullOf(const ConvexHull& hull, const Transform& pose) {
    Hull& shared = hulls_[&hull];
    if (!shared) {
      std::vector<b3Vec3> points;
      for (const Vec3& vertex : placedVertices(hull, pose)) points.push_back(toBox3d(vertex));
      const int count = static_cast<int>(points.size());
      shared.reset(b3CreateHull(points.data(), count, count));
    }
    return shared.get();
  }

  int subSteps_;
  b3WorldId world_{};
  std::map<const ConvexHull*, Hull> hulls_;
  std::vector<Mesh> meshes_;
  std::vector<b3BodyId> bodies_;
  std::vector<Vec3> centers_;  ///< Of mass, in the model's frame, by body.
};

}  // namespace

EngineInfo engineInfo() {
  return {.program = "engine_box3d"};
}

Result<std::unique_ptr<Physics>> makeEngine(const EngineOptions& options, const PhysicsDef& def) {
  if (options.convexRadius || options.iterations || options.boxes || options.pairAlgorithm || options.lean ||
      options.threads > 1) {
    return fail("Box3D's measurement has only --coarsest and --sub-steps");
  }
  return std::make_unique<Box3dPhysics>(options, def.gravity);
}

}  // namespace scatter::bench
