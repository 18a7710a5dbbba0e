#include "scenes/breakable.h"

#include <cassert>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <utility>

#include "levels/point_inertia.h"

namespace scatter {
namespace {

/// The motion of a rigid body that has the momentum and angular momentum of another one.
struct RigidMotion {
  glm::dvec3 center;    ///< Of mass.
  glm::dvec3 velocity;  ///< Of the centre of mass.
  glm::dvec3 spin;
};

/// What the gibs, taken together, do. Their centre of mass and inertia differ a little from the whole's, as
/// there is room between them; the spin makes up for it.
RigidMotion motionOfGibs(const Breakable& object, const std::vector<double>& masses, const BodyState& state) {
  const glm::dmat3 rotation = glm::mat3_cast(glm::dquat(state.pose.rotation));
  const auto mass = static_cast<double>(object.mass);
  RigidMotion motion{glm::dvec3(0.0), glm::dvec3(state.linearVelocity), glm::dvec3(0.0)};
  for (std::size_t i = 0; i < masses.size(); ++i) {
    motion.center += masses[i] / mass * glm::dvec3(object.gibs[i]->mass().centerOfMass);
  }
  glm::dmat3 inertia(0.0);
  for (std::size_t i = 0; i < masses.size(); ++i) {
    const MassProperties& gib = object.gibs[i]->mass();
    const glm::dvec3 out = glm::dvec3(gib.centerOfMass) - motion.center;
    inertia += masses[i] * (glm::dmat3(gib.inertia) + levels::pointInertia(out));
  }
  motion.center = glm::dvec3(state.pose.position) + rotation * motion.center;
  const glm::dmat3 wholeInertia =
      rotation * (mass * glm::dmat3(object.whole->mass().inertia)) * glm::transpose(rotation);
  const glm::dvec3 shift = motion.center - glm::dvec3(state.centerOfMass);
  const glm::dvec3 angularMomentum =
      wholeInertia * glm::dvec3(state.angularVelocity) - mass * glm::cross(shift, motion.velocity);
  motion.spin = glm::inverse(rotation * inertia * glm::transpose(rotation)) * angularMomentum;
  return motion;
}

}  // namespace

std::vector<BodyDef> breakApart(const Breakable& object, const BodyDef& def, const BodyState& state,
                                float burst) {
  double volume = 0.0;
  for (const auto& gib : object.gibs) volume += static_cast<double>(gib->mass().volume);
  std::vector<double> masses;
  for (const auto& gib : object.gibs) {
    masses.push_back(static_cast<double>(object.mass) * static_cast<double>(gib->mass().volume) / volume);
  }
  const RigidMotion motion = motionOfGibs(object, masses, state);
  std::vector<BodyDef> gibs;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    BodyDef& gib = gibs.emplace_back(def);
    gib.name = def.name + "-gib-" + std::to_string(i + 1);
    gib.shape = object.gibs[i];
    gib.mass = static_cast<float>(masses[i]);
    gib.pose = state.pose;
    const glm::dvec3 out = glm::dvec3(state.pose(object.gibs[i]->mass().centerOfMass)) - motion.center;
    gib.linearVelocity =
        Vec3(motion.velocity + glm::cross(motion.spin, out) + static_cast<double>(burst) * out);
    gib.angularVelocity = Vec3(motion.spin);
  }
  return gibs;
}

double PrimitiveCount::pairGrowth() const {
  assert(whole > 1);
  const auto pairs = [](std::size_t primitives) {
    const auto n = static_cast<double>(primitives);
    return 0.5 * n * (n - 1.0);
  };
  return pairs(broken) / pairs(whole);
}

PrimitiveCount countPrimitives(const Breakable& object, std::size_t count, bool finestGibs) {
  PrimitiveCount primitives{count * object.whole->finest().parts.size(), 0};
  for (const auto& gib : object.gibs) {
    primitives.broken += count * (finestGibs ? gib->finest() : gib->coarsest()).parts.size();
  }
  return primitives;
}

}  // namespace scatter
