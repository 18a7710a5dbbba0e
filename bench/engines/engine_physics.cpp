#include "engine_physics.h"

#include <bit>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>

namespace scatter::bench {

namespace {

/// A scene of the measurement has no use for what calls this.
void assertUnused() {
  assert(false && "not part of the engine measurement");
}

bool isFinite(const Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// The convex shape that a shape is, if it is one.
std::optional<ConvexShape> convexOf(const Shape& shape) {
  return std::visit(
      [](const auto& concrete) -> std::optional<ConvexShape> {
        if constexpr (std::is_convertible_v<decltype(concrete), ConvexShape>) return ConvexShape(concrete);
        return std::nullopt;
      },
      shape);
}

bool isGround(const Shape& shape) {
  return std::holds_alternative<Plane>(shape) ||
         std::holds_alternative<std::shared_ptr<const TriangleMesh>>(shape) ||
         std::holds_alternative<std::shared_ptr<const HeightField>>(shape);
}

class Hash {
 public:
  void add(float value) {
    constexpr std::uint64_t kPrime = 0x100000001b3U;
    hash_ = (hash_ ^ std::bit_cast<std::uint32_t>(value)) * kPrime;
    hash_ ^= hash_ >> 29U;
  }
  void add(const Vec3& v) {
    for (int axis = 0; axis < 3; ++axis) add(v[axis]);
  }
  [[nodiscard]] std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325U;
};

}  // namespace

Result<EnginePhysics::Record> EnginePhysics::makeRecord(const BodyDef& def) const {
  if (def.motion == Motion::kKinematic) {
    return fail("body \"" + def.name + "\" must be dynamic or static");
  }
  Record record;
  if (isGround(def.shape)) return record;
  record.mass = def.motion == Motion::kDynamic ? def.mass : 0.0F;
  if (const auto* levels = std::get_if<std::shared_ptr<const LevelSet>>(&def.shape)) {
    record.levels = *levels;
    record.properties = (*levels)->mass();
    return record;
  }
  const std::optional<ConvexShape> convex = convexOf(def.shape);
  if (!convex) return fail("body \"" + def.name + "\" must be convex or have levels");
  record.own = std::make_shared<std::vector<ConvexPart>>(1, ConvexPart{*convex, Transform{}});
  auto properties = massProperties(*record.own);
  if (!properties) return tl::unexpected(properties.error());
  record.properties = *properties;
  return record;
}

Result<void> EnginePhysics::add(const BodyDef& def, const Record& record) {
  if (const auto* plane = std::get_if<Plane>(&def.shape)) return addGround(def, *plane);
  if (const auto* mesh = std::get_if<std::shared_ptr<const TriangleMesh>>(&def.shape)) {
    return addGround(def, **mesh);
  }
  if (const auto* field = std::get_if<std::shared_ptr<const HeightField>>(&def.shape)) {
    return addGround(def, trianglesOf(**field));
  }
  return addBody({.def = def, .parts = partsOf(record), .mass = record.properties});
}

Result<void> EnginePhysics::addGround(const BodyDef& def, const Plane&) {
  return fail("body \"" + def.name + "\": this engine's measurement has no planes");
}

Result<void> EnginePhysics::addGround(const BodyDef& def, const TriangleMesh&) {
  return fail("body \"" + def.name + "\": this engine's measurement has no triangles");
}

const std::vector<ConvexPart>& EnginePhysics::partsOf(const Record& record) const {
  if (record.own) return *record.own;
  return coarsest_ ? record.levels->coarsest().parts : record.levels->finest().parts;
}

Result<BodyId> EnginePhysics::createBody(const BodyDef& def) {
  Result<Record> record = makeRecord(def);
  if (!record) return tl::unexpected(record.error());
  if (auto added = add(def, *record); !added) return tl::unexpected(added.error());
  hybrids_ += record->levels ? 1 : 0;
  records_.push_back(std::move(*record));
  return static_cast<BodyId>(records_.size() - 1);
}

const StepCounters& EnginePhysics::counters() const {
  const Contacts contacts = countContacts();
  counters_.objects = static_cast<std::uint32_t>(records_.size());
  counters_.hybrids = hybrids_;
  counters_.manifolds = contacts.manifolds;
  counters_.contacts = contacts.points;
  deepest_ = contacts.deepest;
  return counters_;
}

std::uint64_t EnginePhysics::stateHash() const {
  Hash hash;
  for (std::size_t i = 0; i < records_.size(); ++i) {
    const BodyState body = state(static_cast<BodyId>(i));
    hash.add(body.pose.position);
    hash.add(body.pose.rotation.w);
    hash.add(Vec3(body.pose.rotation.x, body.pose.rotation.y, body.pose.rotation.z));
    hash.add(body.linearVelocity);
    hash.add(body.angularVelocity);
  }
  return hash.value();
}

double EnginePhysics::kineticEnergy() const {
  double energy = 0.0;
  for (std::size_t i = 0; i < records_.size(); ++i) {
    const BodyState body = state(static_cast<BodyId>(i));
    const Vec3 spin = glm::conjugate(body.pose.rotation) * body.angularVelocity;
    const float square = glm::dot(body.linearVelocity, body.linearVelocity) +
                         glm::dot(spin, records_[i].properties.inertia * spin);
    energy += 0.5 * static_cast<double>(records_[i].mass) * static_cast<double>(square);
  }
  return energy;
}

std::optional<BodyId> EnginePhysics::findInvalidState() const {
  for (std::size_t i = 0; i < records_.size(); ++i) {
    const BodyState body = state(static_cast<BodyId>(i));
    if (!isFinite(body.pose.position) || !isFinite(body.linearVelocity) || !isFinite(body.angularVelocity)) {
      return static_cast<BodyId>(i);
    }
  }
  return std::nullopt;
}

void EnginePhysics::destroyBody(BodyId) {
  assertUnused();
}
void EnginePhysics::setPose(BodyId, const Transform&) {
  assertUnused();
}
void EnginePhysics::setVelocity(BodyId, const Vec3&, const Vec3&) {
  assertUnused();
}
void EnginePhysics::activate(BodyId) {
  assertUnused();
}
void EnginePhysics::applyForce(BodyId, const Vec3&, const Vec3&, bool) {
  assertUnused();
}
void EnginePhysics::applyTorque(BodyId, const Vec3&) {
  assertUnused();
}
void EnginePhysics::applyImpulse(BodyId, const Vec3&, const Vec3&) {
  assertUnused();
}
void EnginePhysics::setGravity(const Vec3&) {
  assertUnused();
}
Result<JointId> EnginePhysics::createJoint(const JointDef&) {
  return fail("the engine measurement has no joints");
}
void EnginePhysics::destroyJoint(JointId) {
  assertUnused();
}
Result<VehicleId> EnginePhysics::createVehicle(const VehicleDef&) {
  return fail("the engine measurement has no vehicles");
}
void EnginePhysics::control(VehicleId, const VehicleControl&) {
  assertUnused();
}
void EnginePhysics::destroyVehicle(VehicleId) {
  assertUnused();
}
std::optional<RayHit> EnginePhysics::castRay(const Vec3&, const Vec3&) const {
  assertUnused();
  return std::nullopt;
}

std::vector<Vec3> placedVertices(const ConvexHull& hull, const Transform& pose) {
  std::vector<Vec3> vertices;
  vertices.reserve(hull.vertices.size());
  for (const Vec3& vertex : hull.vertices) vertices.push_back(pose(vertex));
  return vertices;
}

tl::unexpected<Error> unknownPart(const EngineBodyDef& body) {
  return fail("body \"" + body.def.name + "\": only boxes, spheres and hulls are measured here");
}

}  // namespace scatter::bench
