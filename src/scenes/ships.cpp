#include "scenes/ships.h"

#include <scatter/io/model_library.h>

#include <algorithm>
#include <cmath>

namespace scatter {
namespace {

constexpr float kAsteroidDensity = 150.0F;  // kg/m³: an asteroid weighs about as much as a ship
constexpr float kPi = 3.14159265F;
constexpr float kLargestSpin = 0.5F;  // rad/s about each axis

/// How far a convex shape reaches from its own origin.
float reachOf(const Box& box) {
  return glm::length(box.halfExtents);
}
float reachOf(const Sphere& sphere) {
  return sphere.radius;
}
float reachOf(const Capsule& capsule) {
  return capsule.radius + capsule.halfHeight;
}
float reachOf(const Cylinder& cylinder) {
  return std::hypot(cylinder.radius, cylinder.halfHeight);
}
float reachOf(const ConvexHull& hull) {
  float reach = 0.0F;
  for (const Vec3& vertex : hull.vertices) reach = std::max(reach, glm::length(vertex));
  return reach;
}

Vec3 randomSpin(Random& random) {
  return random.insideUnitBall() * kLargestSpin;
}

Result<void> addShips(World& world, const Model& model, int count, const SwarmDef& swarm,
                      ShellPlacement& shell, Random& random) {
  const float radius = boundingRadius(model);
  for (int i = 0; i < count; ++i) {
    const Transform pose{shell.place(radius), random.orientation()};
    BodyDef def = shipBody(model, model.name + "-" + std::to_string(i + 1), pose);
    def.angularVelocity = randomSpin(random);
    def.material.restitution = swarm.restitution;
    if (auto added = world.add(std::move(def)); !added) return fail(added.error().message);
  }
  return {};
}

Result<void> addAsteroids(World& world, const SwarmDef& swarm, ShellPlacement& shell, Random& random) {
  for (int i = 0; i < swarm.asteroids; ++i) {
    const float radius = random.uniform(swarm.asteroidMinRadius, swarm.asteroidMaxRadius);
    BodyDef def;
    def.name = "asteroid-" + std::to_string(i + 1);
    def.shape = Sphere{radius};
    def.mass = kAsteroidDensity * 4.0F / 3.0F * kPi * radius * radius * radius;
    def.pose.position = shell.place(radius);
    def.angularVelocity = randomSpin(random);
    def.material.restitution = swarm.restitution;
    def.mayRest = false;
    if (auto added = world.add(std::move(def)); !added) return fail(added.error().message);
  }
  return {};
}

}  // namespace

Result<ShipModels> loadShips(const std::string& suffix) {
  auto hunter = loadModel("hunter" + suffix);
  if (!hunter) return fail(hunter.error().message);
  auto fighter = loadModel("fighter" + suffix);
  if (!fighter) return fail(fighter.error().message);
  return ShipModels{std::move(*hunter), std::move(*fighter)};
}

float boundingRadius(const Model& model) {
  float radius = 0.0F;
  for (const ConvexPart& part : model.levels->coarsest().parts) {
    const float reach = std::visit([](const auto& shape) { return reachOf(shape); }, part.shape);
    radius = std::max(radius, glm::length(part.pose.position) + reach);
  }
  return radius + model.levels->hullMargin();
}

BodyDef shipBody(const Model& model, std::string name, const Transform& pose) {
  BodyDef def;
  def.name = std::move(name);
  def.shape = model.levels;
  def.mass = model.mass;
  def.pose = pose;
  def.material.friction = model.friction;
  def.material.restitution = model.restitution;
  def.mayRest = false;
  return def;
}

Result<void> addSwarm(World& world, const ShipModels& models, const SwarmDef& def, Random& random) {
  ShellPlacement shell(random, Vec3(0.0F), def.innerRadius, def.outerRadius);
  if (auto added = addShips(world, *models.hunter, def.hunters, def, shell, random); !added) return added;
  if (auto added = addShips(world, *models.fighter, def.fighters, def, shell, random); !added) return added;
  return addAsteroids(world, def, shell, random);
}

}  // namespace scatter
