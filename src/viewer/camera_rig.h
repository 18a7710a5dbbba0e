#pragma once

#include <scatter/math.h>

#include <cstdint>

#include "viewer/renderer.h"

namespace scatter::viewer {

enum class CameraMode : std::uint8_t {
  kOrbit,   ///< Turns around a point.
  kFly,     ///< Moves freely.
  kFollow,  ///< Turns around a point that moves.
};

/// A camera that the user steers. Up is +y.
class CameraRig {
 public:
  [[nodiscard]] CameraMode mode() const { return mode_; }
  /// What is looked at stays where it is in the picture.
  void setMode(CameraMode mode) { mode_ = mode; }

  /// Looks at a ball from where it just fills the picture.
  void frame(const Vec3& center, float radius);

  /// Looks at a point from a direction, degrees to the right of +z and up, and a distance.
  void look(const Vec3& at, float right, float up, float distance);

  /// Turns around the point, or, flying, the line of sight: radians to the right and up.
  void turn(float right, float up);

  /// Moves sideways: shares of the picture's height.
  void pan(float right, float up);

  /// Comes nearer by a factor: 2 halves the distance. Flying, moves forward by as much.
  void zoom(float factor);

  /// Moves along its own axes, metres: right, up, forward.
  void move(const Vec3& along);

  /// The point to follow; does nothing in other modes.
  void follow(const Vec3& point);

  [[nodiscard]] const Vec3& pivot() const { return pivot_; }
  [[nodiscard]] float distance() const { return distance_; }
  [[nodiscard]] Vec3 eye() const;
  [[nodiscard]] Camera camera() const;

 private:
  [[nodiscard]] Vec3 forward() const;
  [[nodiscard]] Vec3 right() const;

  static constexpr float kFieldOfView = 0.8F;

  CameraMode mode_ = CameraMode::kOrbit;
  Vec3 pivot_{0.0F};
  float distance_ = 20.0F;
  float yaw_ = 0.6F;     ///< Radians about +y; 0 looks along -z.
  float pitch_ = -0.3F;  ///< Radians, positive looks up.
};

}  // namespace scatter::viewer
