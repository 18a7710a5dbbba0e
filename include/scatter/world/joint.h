#pragma once

#include <scatter/math.h>
#include <scatter/world/body.h>

#include <cstdint>
#include <variant>
#include <vector>

namespace scatter {

/// A point of one body stays on a point of the other.
struct PointJoint {};

/// Free rotation about the frame's z axis. Within limits if lower <= upper: radians, from -pi to pi, that
/// body B has turned relative to body A since the joint was made.
struct HingeJoint {
  float lower = 1.0F;
  float upper = -1.0F;
};

/// Free motion along the frame's x axis. Within limits if lower <= upper: metres that body B has moved
/// relative to body A since the joint was made.
struct SliderJoint {
  float lower = 1.0F;
  float upper = -1.0F;
};

struct FixedJoint {};

/// Each axis: locked if lower == upper, limited if lower < upper, free if lower > upper. Of body B
/// relative to body A: metres along the frame's axes, and radians of turns about the frame's x, then its y,
/// then its z axis, y from -pi/2 to pi/2.
struct SixDofJoint {
  Vec3 linearLower{0.0F};
  Vec3 linearUpper{0.0F};
  Vec3 angularLower{0.0F};
  Vec3 angularUpper{0.0F};
};

using JointKind = std::variant<PointJoint, HingeJoint, SliderJoint, FixedJoint, SixDofJoint>;

/// A non-contact constraint between two bodies, of which at least one is dynamic.
struct JointDef {
  JointKind kind{};
  BodyId bodyA{};
  BodyId bodyB{};
  Transform frame{};           ///< The joint's frame in the world, at creation.
  bool bodiesCollide = false;  ///< Whether the two bodies still collide with each other.
};

enum class JointId : std::uint32_t {};

struct WheelDef {
  Vec3 connection{0.0F};  ///< Where the suspension starts, in the chassis frame.
  Vec3 direction{0.0F, -1.0F, 0.0F};
  Vec3 axle{-1.0F, 0.0F, 0.0F};
  float suspensionRest = 0.3F;  ///< Metres.
  float radius = 0.4F;
  bool steered = false;
  bool driven = false;
};

/// A vehicle whose wheels are rays cast from a chassis body. A driven wheel pushes toward
/// axle x direction: +z with the defaults.
struct VehicleDef {
  BodyId chassis{};
  std::vector<WheelDef> wheels{};
  float suspensionStiffness = 20.0F;
  float frictionSlip = 10.0F;
};

struct VehicleControl {
  float engineForce = 0.0F;  ///< Newtons on each driven wheel.
  float brake = 0.0F;        ///< Brake impulse limit on every wheel.
  float steering = 0.0F;     ///< Radians, on steered wheels.
};

enum class VehicleId : std::uint32_t {};

}  // namespace scatter
