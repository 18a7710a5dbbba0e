#include "lab/hand_throw.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace scatter::lab {

namespace {

// More than this in metres per second squared is no field, but something that was in the way.
constexpr float kLargestAcceleration = 200.0F;

}  // namespace

ThrowAim::ThrowAim(const WorldObject& object, const Vec3& through, int steps)
    : body_(object.body()),
      through_(through),
      velocity_(object.state().linearVelocity),
      damping_(object.def().material.linearDamping),
      stepsLeft_(steps) {}

bool ThrowAim::beforeStep(World& world, float seconds) {
  const WorldObject* object = world.find(body_);
  if (object == nullptr) {
    return false;
  }
  if (!flies_) {
    flies_ = true;
    return true;
  }
  const BodyState state = object->state();
  const Vec3 acceleration = (state.linearVelocity - std::pow(1.0F - damping_, seconds) * velocity_) / seconds;
  if (glm::length(acceleration) <= kLargestAcceleration && stepsLeft_ > 1) {
    const Vec3 velocity =
        launchVelocity(through_ - state.centerOfMass, stepsLeft_ - 1, acceleration, damping_, seconds);
    world.physics().setVelocity(body_, velocity, state.angularVelocity);
  }
  return false;
}

Vec3 launchVelocity(const Vec3& offset, int steps, const Vec3& acceleration, float damping, float seconds) {
  const float kept = std::pow(1.0F - damping, seconds);
  float share = 1.0F;      // of the first velocity that is left
  float gain = 0.0F;       // velocity after the step, in units of acceleration · seconds
  float way = 0.0F;        // sum of the shares
  float gainedWay = 0.0F;  // sum of the gains
  for (int step = 0; step < steps; ++step) {
    share *= kept;
    gain = gain * kept + 1.0F;
    way += share;
    gainedWay += gain;
  }
  return (offset / seconds - seconds * gainedWay * acceleration) / way;
}

}  // namespace scatter::lab
