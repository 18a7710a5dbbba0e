#pragma once

#include <scatter/math.h>

#include <cstdint>
#include <glm/vec2.hpp>

#include "viewer/action.h"
#include "viewer/renderer.h"

namespace scatter::viewer {

enum class CameraMode : std::uint8_t {
  kAction,  ///< Goes where something happens, until it is steered.
  kOrbit,   ///< Turns around a point.
  kFly,     ///< Moves freely.
  kFollow,  ///< Turns around a point that moves.
};

/// A camera that watches what happens until the user steers it. Up is +y.
class CameraRig {
 public:
  [[nodiscard]] CameraMode mode() const { return mode_; }
  /// What is looked at stays where it is in the picture.
  void setMode(CameraMode mode) { mode_ = mode; }

  /// Looks at a ball from where it just fills a picture that is so many times as wide as it is high.
  void frame(const Ball& ball, float aspect);

  /// Watching the action, goes a part of the way to where it would frame the ball, as much as `seconds` are
  /// worth; the first time all of it. Does nothing in other modes.
  void watch(const Ball& action, float aspect, float seconds);

  /// Looks at a point from a direction, degrees to the right of +z and up, and a distance.
  void look(const Vec3& at, float right, float up, float distance);

  /// Turns around the point, or, flying, the line of sight: radians to the right and up.
  void turn(float right, float up);

  /// As a drag turns it that moves so far, in heights of the window, from the top left.
  void turnByDrag(const glm::vec2& moved);

  /// Moves sideways: shares of the picture's height.
  void pan(float right, float up);

  /// Comes nearer by a factor: 2 halves the distance. Flying, moves forward by as much.
  void zoom(float factor);

  /// As so many notches of a wheel do.
  void zoomByNotches(float notches);

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
  void takeOver();

  static constexpr float kFieldOfView = 0.8F;

  CameraMode mode_ = CameraMode::kAction;
  bool watched_ = false;  ///< Whether there was an action to watch.
  Vec3 pivot_{0.0F};
  float distance_ = 20.0F;
  float yaw_ = 0.6F;     ///< Radians about +y; 0 looks along -z.
  float pitch_ = -0.3F;  ///< Radians, positive looks up.
};

}  // namespace scatter::viewer
