#include "scenes/file_bodies.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numbers>
#include <string>
#include <utility>

#include "scenes/ground_shapes.h"

namespace scatter {
namespace {

void setMaterial(const SceneFileMaterial& given, Material& material) {
  material.friction = given.friction.value_or(material.friction);
  material.rollingFriction = given.rollingFriction.value_or(material.rollingFriction);
  material.spinningFriction = given.spinningFriction.value_or(material.spinningFriction);
  material.restitution = given.restitution.value_or(material.restitution);
  material.linearDamping = given.linearDamping.value_or(material.linearDamping);
  material.angularDamping = given.angularDamping.value_or(material.angularDamping);
}

Motion motionOf(SceneFileMotion motion) {
  switch (motion) {
    case SceneFileMotion::kStatic:
      return Motion::kStatic;
    case SceneFileMotion::kKinematic:
      return Motion::kKinematic;
    case SceneFileMotion::kDynamic:
      break;
  }
  return Motion::kDynamic;
}

bool hasRandomSize(const SceneFileObject& object) {
  const auto* ball = std::get_if<SceneFileBall>(&object.shape);
  return ball != nullptr && ball->minRadius != ball->maxRadius;
}

float massOfBall(float density, float radius) {
  return density * 4.0F / 3.0F * std::numbers::pi_v<float> * radius * radius * radius;
}

/// The shape of an object that is neither a model nor can only be static.
ConvexShape convexShape(const SceneFileShape& shape) {
  if (const auto* box = std::get_if<Box>(&shape)) return *box;
  if (const auto* capsule = std::get_if<Capsule>(&shape)) return *capsule;
  if (const auto* cylinder = std::get_if<Cylinder>(&shape)) return *cylinder;
  if (const auto* hull = std::get_if<ConvexHull>(&shape)) return *hull;
  return Sphere{std::get<SceneFileBall>(shape).minRadius};
}

}  // namespace

FileBodies::FileBodies(const SceneFile& file, SceneModels& models, Random& random)
    : file_(file), models_(models), random_(random) {
  for (const SceneFileRegion& region : file.regions) regions_.emplace_back(random, region);
}

Result<void> FileBodies::setConvex(const SceneFileObject& object, const ConvexShape& shape, Common& common) {
  std::visit([&common](const auto& convex) { common.def.shape = convex; }, shape);
  const std::vector<ConvexPart> parts{{.shape = shape, .pose = {}}};
  const auto mass = massProperties(parts);
  if (!mass) return fail(mass.error().message);
  common.volume = mass->volume;
  common.boundingRadius = reachOf(shape);
  common.heights = heightsOf(parts, 0.0F, object.orientation.rotation);
  return {};
}

Result<void> FileBodies::setShape(const SceneFileObject& object, Common& common) {
  if (std::holds_alternative<SceneFilePlane>(object.shape)) return {};
  if (const auto* terrain = std::get_if<SceneFileTerrain>(&object.shape)) {
    common.def.shape = terrainShape(*terrain);
    return {};
  }
  if (const auto* mesh = std::get_if<SceneFileMesh>(&object.shape)) {
    return readMeshShape(file_.path.parent_path() / mesh->file).map([&common](Shape shape) {
      common.def.shape = std::move(shape);
    });
  }
  if (const auto* named = std::get_if<SceneFileModel>(&object.shape)) return setModel(object, *named, common);
  return setConvex(object, convexShape(object.shape), common);
}

Result<void> FileBodies::setModel(const SceneFileObject& object, const SceneFileModel& named,
                                  Common& common) {
  const auto model = models_.load(named);
  if (!model) return fail(model.error().message);
  const LevelSet& levels = *(*model)->levels;
  common.def.shape = (*model)->levels;
  common.def.mesh = drawnMesh(*model);
  common.def.mass = (*model)->mass;
  common.def.material.friction = (*model)->friction;
  common.def.material.restitution = (*model)->restitution;
  common.volume = levels.mass().volume;
  common.boundingRadius = boundingRadius(levels);
  common.heights = heightsOf(levels.finest().parts, levels.hullMargin(), object.orientation.rotation);
  return {};
}

Result<FileBodies::Common> FileBodies::common(const SceneFileObject& object) {
  Common common;
  if (auto set = setShape(object, common); !set) return tl::unexpected(set.error());
  BodyDef& def = common.def;
  def.motion = motionOf(object.motion);
  def.mass = object.mass.value_or(def.mass);
  if (object.density) def.mass = *object.density * common.volume;
  setMaterial(object.material, def.material);
  def.mayRest = object.mayRest;
  def.sensor = object.sensor;
  def.group = object.group;
  def.collidesWith = object.collidesWith;
  return common;
}

void FileBodies::setSize(const SceneFileObject& object, BodyDef& def, float& radius) {
  const auto* ball = std::get_if<SceneFileBall>(&object.shape);
  if (ball == nullptr) return;
  radius = hasRandomSize(object) ? random_.uniform(ball->minRadius, ball->maxRadius) : ball->minRadius;
  def.shape = Sphere{radius};
  if (object.density) def.mass = massOfBall(*object.density, radius);
}

Vec3 FileBodies::place(const SceneFileObject& object, const Common& common, float radius, std::size_t index) {
  if (const auto* points = std::get_if<std::vector<Vec3>>(&object.placement)) return (*points)[index];
  if (const auto* stack = std::get_if<SceneFileStack>(&object.placement)) {
    const float pitch = common.heights.high - common.heights.low + stack->gap;
    return stack->base + Vec3(0.0F, static_cast<float>(index) * pitch - common.heights.low, 0.0F);
  }
  return regions_[std::get<SceneFileRandomPlaces>(object.placement).region].place(radius);
}

Quat FileBodies::orient(const SceneFileOrientation& orientation) {
  switch (orientation.kind) {
    case SceneFileOrientation::Kind::kRandom:
      return random_.orientation();
    case SceneFileOrientation::Kind::kUpright:
      return glm::angleAxis(random_.uniform(-std::numbers::pi_v<float>, std::numbers::pi_v<float>),
                            Vec3(0.0F, 1.0F, 0.0F));
    case SceneFileOrientation::Kind::kGiven:
      break;
  }
  return orientation.rotation;
}

Vec3 FileBodies::velocity(const SceneFileVelocity& velocity, const Vec3& position) {
  switch (velocity.kind) {
    case SceneFileVelocity::Kind::kRandom:
      return velocity.amount * random_.insideUnitBall();
    case SceneFileVelocity::Kind::kToward: {
      const Vec3 way = velocity.vector - position;
      const float distance = glm::length(way);
      return distance > 0.0F ? way * (velocity.amount / distance) : Vec3(0.0F);
    }
    case SceneFileVelocity::Kind::kAway:
      return velocity.amount * (position - velocity.vector);
    case SceneFileVelocity::Kind::kGiven:
      break;
  }
  return velocity.vector;
}

Result<std::vector<BodyDef>> FileBodies::make(const SceneFileObject& object) {
  const auto common = this->common(object);
  if (!common) {
    return fail(file_.path.string() + ":" + std::to_string(object.line) + ": " + common.error().message);
  }
  std::vector<BodyDef> bodies;
  bodies.reserve(object.count);
  for (std::size_t i = 0; i < object.count; ++i) {
    BodyDef& def = bodies.emplace_back(common->def);
    def.name = file_.bodies[object.firstBody + i];
    float radius = common->boundingRadius;
    setSize(object, def, radius);
    def.pose.position = place(object, *common, radius, i);
    def.pose.rotation = orient(object.orientation);
    def.linearVelocity = velocity(object.velocity, def.pose.position);
    def.angularVelocity = velocity(object.spin, def.pose.position);
    if (const auto* plane = std::get_if<SceneFilePlane>(&object.shape)) {
      def.shape = Plane{plane->normal, glm::dot(plane->normal, def.pose.position)};
      def.pose = {};
    }
  }
  return bodies;
}

}  // namespace scatter
