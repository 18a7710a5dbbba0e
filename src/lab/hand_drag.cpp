#include "lab/hand_drag.h"

#include <scatter/levels/mass_properties.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <memory>
#include <type_traits>
#include <variant>
#include <vector>

namespace scatter::lab {

namespace {

// Of a ball with a radius of half a metre, for what has no parts of its own to say better.
const Mat3 kBallInertia = Mat3(0.1F);

// Per kilogram, along the model's axes.
Mat3 unitInertia(const Shape& shape) {
  return std::visit(
      [](const auto& kind) -> Mat3 {
        using Kind = std::decay_t<decltype(kind)>;
        if constexpr (std::is_same_v<Kind, std::shared_ptr<const LevelSet>>) {
          return kind->mass().inertia;
        } else if constexpr (std::is_same_v<Kind, Compound>) {
          const auto mass = massProperties(kind.parts);
          return mass ? mass->inertia : kBallInertia;
        } else if constexpr (std::is_constructible_v<ConvexShape, Kind>) {
          const auto mass = massProperties({ConvexPart{kind, {}}});
          return mass ? mass->inertia : kBallInertia;
        } else {
          return kBallInertia;
        }
      },
      shape);
}

// Of a cross product: cross(a) * b is a × b.
Mat3 cross(const Vec3& a) {
  return {Vec3(0.0F, a.z, -a.y), Vec3(-a.z, 0.0F, a.x), Vec3(a.y, -a.x, 0.0F)};
}

}  // namespace

Drag::Drag(const WorldObject& object, const Vec3& point)
    : target(point),
      body_(object.body()),
      mass_(object.def().mass),
      inertia_(object.def().mass * unitInertia(object.def().shape)),
      local_(object.state().pose.inverse()(point)) {}

// How a force at a point accelerates that point.
Mat3 Drag::inverseMassAt(const Vec3& arm, const Mat3& inertia) const {
  const Mat3 lever = cross(arm);
  return Mat3(1.0F / mass_) - lever * glm::inverse(inertia) * lever;
}

void Drag::apply(World& world, const HandsDef& def, float seconds) {
  const BodyState state = world.physics().state(body_);
  const Vec3 point = grip(state);
  const Vec3 arm = point - state.centerOfMass;
  const Vec3 velocity = state.linearVelocity + glm::cross(state.angularVelocity, arm);
  if (expected_) {
    load_.follow((velocity - *expected_) / seconds);
  }
  const Vec3 pull = pullAcceleration(def.drag, target - point, velocity, seconds);
  const Mat3 turn = glm::mat3_cast(state.pose.rotation);
  const Mat3 inertia = turn * inertia_ * glm::transpose(turn);
  world.physics().applyForce(body_, glm::inverse(inverseMassAt(arm, inertia)) * (pull - load_.acceleration()),
                             point);
  // It turns about the grip, so its spin has the inertia that it has there.
  const Mat3 inertiaAtGrip = inertia + mass_ * (Mat3(glm::dot(arm, arm)) - glm::outerProduct(arm, arm));
  const float damping = def.dragSpinDamping / (1.0F + def.dragSpinDamping * seconds);
  world.physics().applyTorque(body_, -damping * (inertiaAtGrip * state.angularVelocity));
  expected_ = velocity + seconds * (pull - load_.acceleration());
}

}  // namespace scatter::lab
