#pragma once

#include <scatter/levels/surface_mesh.h>
#include <scatter/math.h>
#include <scatter/world/shape.h>

#include <cstdint>
#include <memory>
#include <string>

namespace scatter {

/// Where two bodies touch, friction and restitution are the products of theirs.
struct Material {
  float friction = 0.5F;
  float rollingFriction = 0.0F;
  float spinningFriction = 0.0F;
  float restitution = 0.0F;     ///< 0 no bounce, 1 full bounce.
  float linearDamping = 0.0F;   ///< Share of velocity lost per second, 0 to 1.
  float angularDamping = 0.0F;  ///< Share of angular velocity lost per second, 0 to 1.
};

enum class Motion : std::uint8_t {
  kStatic,     ///< Never moves; mass is ignored.
  kKinematic,  ///< Moved by the program through setPose; pushes, is never pushed.
  kDynamic,    ///< Moved by forces; needs a positive mass.
};

/// What a body is made from. The pose is that of the model's frame, wherever its centre of mass is.
struct BodyDef {
  std::string name{};
  Shape shape = Box{};
  Motion motion = Motion::kDynamic;
  float mass = 1.0F;
  Transform pose{};
  Vec3 linearVelocity{0.0F};   ///< Of the centre of mass, metres per second.
  Vec3 angularVelocity{0.0F};  ///< Radians per second, world axes.
  Material material{};
  float gravityFactor = 1.0F;        ///< Of the world's gravity; 0 floats, negative rises.
  bool mayRest = true;               ///< May fall asleep when it hardly moves.
  bool sensor = false;               ///< Reports contacts, but neither pushes nor is pushed.
  std::uint32_t group = 1;           ///< Collision group bits.
  std::uint32_t collidesWith = ~0U;  ///< Groups it collides with; both bodies must agree.

  /// What is drawn, in the body's frame. None: its shape. Nothing else depends on it.
  std::shared_ptr<const SurfaceMesh> mesh{};
};

struct BodyState {
  Transform pose{};
  Vec3 linearVelocity{0.0F};
  Vec3 angularVelocity{0.0F};
  bool asleep = false;
  Vec3 centerOfMass{0.0F};  ///< World frame.
};

/// Names a body in a Physics; never reused within one.
enum class BodyId : std::uint32_t {};

}  // namespace scatter
