// ODE with its own settings, but for: friction and restitution multiplied as the scenes mean them, bounce
// from Bullet's 0.2 m/s on, a contact surface layer of 5 mm against jitter, mass and inertia those of the
// finest level. A body with several parts is a space of its own within the world's. Nothing sleeps.

#include <ode/ode.h>

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/gtc/quaternion.hpp>
#include <list>
#include <map>
#include <memory>

#include "engine_physics.h"
#include "levels/convex_hull.h"

namespace scatter::bench {

namespace {

constexpr int kMostPoints = 4;  // of two parts, as many as the other engines keep
constexpr dReal kBounceVelocity = 0.2;
constexpr dReal kSurfaceLayer = 0.005;

dReal wide(float value) {
  return static_cast<dReal>(value);
}
std::array<dReal, 4> toOde(const Quat& turn) {
  return {wide(turn.w), wide(turn.x), wide(turn.y), wide(turn.z)};
}
Vec3 fromOde(const dReal* v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

/// A hull as ODE takes it; ODE keeps pointers into it.
struct OdeHull {
  std::vector<dReal> planes;
  std::vector<dReal> points;
  std::vector<unsigned> polygons;
  Vec3 center{0.0F};  ///< Of its bounds, in the model's frame: the origin of points and planes.
  Vec3 halfExtents{0.0F};
};

Result<OdeHull> makeHull(const ConvexHull& source, const Transform& pose) {
  const std::vector<Vec3> vertices = placedVertices(source, pose);
  Vec3 low = vertices.front();
  Vec3 high = low;
  for (const Vec3& vertex : vertices) {
    low = glm::min(low, vertex);
    high = glm::max(high, vertex);
  }
  OdeHull hull;
  hull.center = 0.5F * (low + high);
  hull.halfExtents = 0.5F * (high - low);
  std::vector<glm::dvec3> points;
  for (const Vec3& vertex : vertices) points.emplace_back(vertex - hull.center);
  const auto polytope = levels::convexHull(points);
  if (!polytope) return tl::unexpected(polytope.error());
  for (const glm::dvec3& vertex : polytope->vertices()) {
    hull.points.insert(hull.points.end(), {vertex.x, vertex.y, vertex.z});
  }
  for (const levels::Polytope::Face& face : polytope->faces()) {
    const glm::dvec3& normal = face.plane.normal;
    hull.planes.insert(hull.planes.end(), {normal.x, normal.y, normal.z, face.plane.offset});
    hull.polygons.push_back(face.count);
    for (const std::uint32_t vertex : polytope->loop(face)) hull.polygons.push_back(vertex);
  }
  return hull;
}

class OdePhysics final : public EnginePhysics {
 public:
  OdePhysics(const EngineOptions& options, const Vec3& gravity)
      : EnginePhysics(options),
        boxes_(options.boxes),
        world_(dWorldCreate()),
        space_(dHashSpaceCreate(nullptr)),
        contactGroup_(dJointGroupCreate(0)) {
    dWorldSetGravity(world_, wide(gravity.x), wide(gravity.y), wide(gravity.z));
    dWorldSetAutoDisableFlag(world_, 0);
    dWorldSetContactSurfaceLayer(world_, kSurfaceLayer);
    if (options.iterations) dWorldSetQuickStepNumIterations(world_, *options.iterations);
  }
  ~OdePhysics() override {
    dJointGroupDestroy(contactGroup_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
  }

  [[nodiscard]] std::string engine() const override {
    return std::string("ode (") + dGetConfiguration() + ")";
  }

  [[nodiscard]] BodyState state(BodyId body) const override {
    const Body& record = bodies_[indexOf(body)];
    BodyState state;
    if (record.id == nullptr) {
      state.pose = record.pose;
      state.centerOfMass = record.pose(record.center);
      return state;
    }
    const dReal* q = dBodyGetQuaternion(record.id);
    state.centerOfMass = fromOde(dBodyGetPosition(record.id));
    state.pose.rotation = Quat(static_cast<float>(q[0]), static_cast<float>(q[1]), static_cast<float>(q[2]),
                               static_cast<float>(q[3]));
    state.pose.position = state.centerOfMass - state.pose.rotation * record.center;
    state.linearVelocity = fromOde(dBodyGetLinearVel(record.id));
    state.angularVelocity = fromOde(dBodyGetAngularVel(record.id));
    return state;
  }

  void applyCentralForce(BodyId body, const Vec3& force, bool) override {
    dBodyAddForce(bodies_[indexOf(body)].id, wide(force.x), wide(force.y), wide(force.z));
  }

  void step(float seconds) override {
    contacts_ = {};
    dSpaceCollide(space_, this, collide);
    dWorldQuickStep(world_, wide(seconds));
    dJointGroupEmpty(contactGroup_);
  }

 protected:
  Result<void> addBody(const EngineBodyDef& body) override {
    const bool isStill = body.def.motion == Motion::kStatic;
    if (!isStill && body.def.motion != Motion::kDynamic)
      return fail("ODE's measurement has no kinematic bodies");
    const Body record{isStill ? nullptr : dBodyCreate(world_), body.mass.centerOfMass, body.def.pose,
                      wide(body.def.material.friction), wide(body.def.material.restitution)};
    if (!isStill) set(record.id, body);
    bodies_.push_back(record);
    dSpaceID space = body.parts.size() == 1 ? space_ : dSimpleSpaceCreate(space_);
    for (const ConvexPart& part : body.parts) {
      if (auto added = addPart(space, record, part, body); !added) return added;
    }
    return {};
  }

  Result<void> addGround(const BodyDef& def, const Plane& plane) override {
    const Vec3& normal = plane.normal;
    addStill(def, dCreatePlane(space_, wide(normal.x), wide(normal.y), wide(normal.z), wide(plane.offset)));
    return {};
  }

  Result<void> addGround(const BodyDef& def, const TriangleMesh& triangles) override {
    Ground& ground = grounds_.emplace_back();
    for (const Vec3& vertex : triangles.vertices) {
      const Vec3 placed = def.pose(vertex);
      ground.vertices.insert(ground.vertices.end(), {placed.x, placed.y, placed.z});
    }
    for (const auto& triangle : triangles.triangles)
      ground.indices.insert(ground.indices.end(), triangle.begin(), triangle.end());
    ground.data.reset(dGeomTriMeshDataCreate());
    dGeomTriMeshDataBuildSingle(ground.data.get(), ground.vertices.data(), 3 * sizeof(float),
                                static_cast<int>(ground.vertices.size() / 3), ground.indices.data(),
                                static_cast<int>(ground.indices.size()), 3 * sizeof(dTriIndex));
    if (dGeomTriMeshDataPreprocess2(ground.data.get(), 1U << dTRIDATAPREPROCESS_BUILD_FACE_ANGLES, nullptr) ==
        0)
      return fail("body \"" + def.name + "\": ODE refuses its triangles");
    addStill(def, dCreateTriMesh(space_, ground.data.get(), nullptr, nullptr, nullptr));
    return {};
  }

  Contacts countContacts() const override { return contacts_; }

 private:
  struct Body {
    dBodyID id;      ///< Null of a static one.
    Vec3 center;     ///< Of mass, in the model's frame; ODE's bodies have theirs at the origin.
    Transform pose;  ///< Where it was made.
    dReal friction;
    dReal restitution;
  };

  struct FreeTriangles {
    void operator()(dTriMeshDataID data) const { dGeomTriMeshDataDestroy(data); }
  };

  /// ODE keeps pointers into it.
  struct Ground {
    std::vector<float> vertices;
    std::vector<dTriIndex> indices;
    std::unique_ptr<dxTriMeshData, FreeTriangles> data;
  };

  static void* toData(std::size_t index) {
    // NOLINTNEXTLINE(performance-no-int-to-ptr): ODE's user data is a pointer.
    return reinterpret_cast<void*>(index);
  }
  const Body& bodyOf(dGeomID geometry) const {
    return bodies_[reinterpret_cast<std::size_t>(dGeomGetData(geometry))];
  }

  void addStill(const BodyDef& def, dGeomID geometry) {
    dGeomSetData(geometry, toData(bodies_.size()));
    bodies_.push_back(
        {nullptr, Vec3(0.0F), def.pose, wide(def.material.friction), wide(def.material.restitution)});
  }

  static void set(dBodyID id, const EngineBodyDef& body) {
    const Vec3 center = body.def.pose(body.mass.centerOfMass);
    dBodySetPosition(id, wide(center.x), wide(center.y), wide(center.z));
    dBodySetQuaternion(id, toOde(body.def.pose.rotation).data());
    const Vec3& velocity = body.def.linearVelocity;
    const Vec3& spin = body.def.angularVelocity;
    dBodySetLinearVel(id, wide(velocity.x), wide(velocity.y), wide(velocity.z));
    dBodySetAngularVel(id, wide(spin.x), wide(spin.y), wide(spin.z));
    dBodySetLinearDamping(id, wide(body.def.material.linearDamping));
    dBodySetAngularDamping(id, wide(body.def.material.angularDamping));
    setMass(id, body);
  }

  static void setMass(dBodyID id, const EngineBodyDef& body) {
    const Mat3 inertia = body.mass.inertia * body.def.mass;
    dMass mass;
    dMassSetParameters(&mass, wide(body.def.mass), 0.0, 0.0, 0.0, wide(inertia[0][0]), wide(inertia[1][1]),
                       wide(inertia[2][2]), wide(inertia[1][0]), wide(inertia[2][0]), wide(inertia[2][1]));
    dBodySetMass(id, &mass);
  }

  Result<void> addPart(dSpaceID space, const Body& body, const ConvexPart& part, const EngineBodyDef& def) {
    if (const auto* hull = std::get_if<ConvexHull>(&part.shape)) {
      const auto made = hullOf(*hull, part.pose);
      if (!made) return fail("body \"" + def.def.name + "\": " + made.error().message);
      place(createHull(space, **made), body, {(*made)->center, kNoRotation});
      return {};
    }
    if (const auto* box = std::get_if<Box>(&part.shape)) {
      place(createBox(space, box->halfExtents), body, part.pose);
      return {};
    }
    if (const auto* sphere = std::get_if<Sphere>(&part.shape)) {
      place(dCreateSphere(space, wide(sphere->radius)), body, part.pose);
      return {};
    }
    return unknownPart(def);
  }

  dGeomID createHull(dSpaceID space, const OdeHull& hull) const {
    if (boxes_) return createBox(space, hull.halfExtents);
    return dCreateConvex(space, hull.planes.data(), static_cast<unsigned>(hull.planes.size() / 4),
                         hull.points.data(), static_cast<unsigned>(hull.points.size() / 3),
                         hull.polygons.data());
  }

  static dGeomID createBox(dSpaceID space, const Vec3& half) {
    return dCreateBox(space, 2.0 * wide(half.x), 2.0 * wide(half.y), 2.0 * wide(half.z));
  }

  void place(dGeomID geometry, const Body& body, const Transform& pose) const {
    dGeomSetData(geometry, toData(bodies_.size() - 1));
    if (body.id == nullptr) return placeStill(geometry, body.pose * pose);
    const Vec3 offset = pose.position - body.center;
    dGeomSetBody(geometry, body.id);
    dGeomSetOffsetPosition(geometry, wide(offset.x), wide(offset.y), wide(offset.z));
    dGeomSetOffsetQuaternion(geometry, toOde(pose.rotation).data());
  }

  static void placeStill(dGeomID geometry, const Transform& pose) {
    dGeomSetPosition(geometry, wide(pose.position.x), wide(pose.position.y), wide(pose.position.z));
    dGeomSetQuaternion(geometry, toOde(pose.rotation).data());
  }

  Result<const OdeHull*> hullOf(const ConvexHull& source, const Transform& pose) {
    auto found = hulls_.find(&source);
    if (found == hulls_.end()) {
      auto made = makeHull(source, pose);
      if (!made) return tl::unexpected(made.error());
      found = hulls_.emplace(&source, std::move(*made)).first;
    }
    return &found->second;
  }

  static void collide(void* self, dGeomID a, dGeomID b) {
    if (dGeomIsSpace(a) != 0 || dGeomIsSpace(b) != 0) {
      dSpaceCollide2(a, b, self, collide);
    } else {
      static_cast<OdePhysics*>(self)->collideParts(a, b);
    }
  }

  void collideParts(dGeomID a, dGeomID b) {
    const Body& first = bodyOf(a);
    const Body& second = bodyOf(b);
    if (first.id == nullptr && second.id == nullptr) return;
    const int count = dCollide(a, b, kMostPoints, &found_[0].geom, sizeof(dContact));
    if (count == 0) return;
    ++contacts_.manifolds;
    contacts_.points += static_cast<std::uint32_t>(count);
    for (int i = 0; i < count; ++i) {
      dContact& contact = found_[static_cast<std::size_t>(i)];
      contacts_.deepest = std::max(contacts_.deepest, contact.geom.depth);
      contact.surface = {};
      contact.surface.mode = dContactBounce | dContactApprox1;
      contact.surface.mu = first.friction * second.friction;
      contact.surface.bounce = first.restitution * second.restitution;
      contact.surface.bounce_vel = kBounceVelocity;
      dJointAttach(dJointCreateContact(world_, contactGroup_, &contact), first.id, second.id);
    }
  }

  bool boxes_;
  dWorldID world_;
  dSpaceID space_;
  dJointGroupID contactGroup_;
  std::map<const ConvexHull*, OdeHull> hulls_;
  std::vector<Body> bodies_;
  std::list<Ground> grounds_;
  std::array<dContact, kMostPoints> found_{};
  Contacts contacts_;
};

}  // namespace

EngineInfo engineInfo() {
  return {.program = "engine_ode"};
}

Result<std::unique_ptr<Physics>> makeEngine(const EngineOptions& options, const PhysicsDef& def) {
  if (options.convexRadius || options.subSteps || options.pairAlgorithm || options.lean ||
      options.threads > 1) {
    return fail("ODE's measurement has only --coarsest, --iterations and --boxes");
  }
  if (dInitODE2(0) == 0) return fail("ODE does not start");
  return std::make_unique<OdePhysics>(options, def.gravity);
}

}  // namespace scatter::bench
