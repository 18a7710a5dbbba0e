#include "viewer/camera_rig.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace scatter::viewer {
namespace {

constexpr float kLargestPitch = 1.5F;
constexpr float kNearest = 0.05F;
constexpr float kFurthest = 5000.0F;
constexpr float kTurnPerHeight = 3.2F;  // radians for a drag over the window's height
constexpr float kZoomPerNotch = 1.15F;
constexpr float kTurnSeconds = 0.5F;  // in which most of the way to the action is gone
constexpr float kNearerSeconds = 0.6F;
constexpr float kFurtherSeconds = 0.3F;
constexpr float kRoom = 1.15F;  // around the action, so that it does not touch the picture's edges
const Vec3 kUp(0.0F, 1.0F, 0.0F);

/// From where a ball just fills the narrower side of a picture.
float distanceFor(float radius, float fieldOfView, float aspect) {
  const float tall = 0.5F * fieldOfView;
  const float half = std::min(tall, std::atan(aspect * std::tan(tall)));
  return std::clamp(radius / std::sin(half), kNearest, kFurthest);
}

}  // namespace

Vec3 CameraRig::forward() const {
  const float flat = std::cos(pitch_);
  return {-std::sin(yaw_) * flat, std::sin(pitch_), -std::cos(yaw_) * flat};
}

Vec3 CameraRig::right() const {
  return {std::cos(yaw_), 0.0F, -std::sin(yaw_)};
}

Vec3 CameraRig::eye() const {
  return pivot_ - distance_ * forward();
}

/// What the user does to a camera that watches the action is steering.
void CameraRig::takeOver() {
  if (mode_ == CameraMode::kAction) mode_ = CameraMode::kOrbit;
}

void CameraRig::frame(const Ball& ball, float aspect) {
  takeOver();
  pivot_ = ball.center;
  distance_ = distanceFor(ball.radius, kFieldOfView, aspect);
}

void CameraRig::watch(const Ball& action, float aspect, float seconds) {
  if (mode_ != CameraMode::kAction) return;
  const float distance = distanceFor(kRoom * action.radius, kFieldOfView, aspect);
  const float time = watched_ ? std::max(0.0F, seconds) : 1e3F;
  watched_ = true;
  pivot_ += (1.0F - std::exp(-time / kTurnSeconds)) * (action.center - pivot_);
  const float zoomSeconds = distance < distance_ ? kNearerSeconds : kFurtherSeconds;
  distance_ *= std::pow(distance / distance_, 1.0F - std::exp(-time / zoomSeconds));
}

void CameraRig::look(const Vec3& at, float right, float up, float distance) {
  takeOver();
  pivot_ = at;
  yaw_ = glm::radians(right);
  pitch_ = std::clamp(-glm::radians(up), -kLargestPitch, kLargestPitch);
  distance_ = std::clamp(distance, kNearest, kFurthest);
}

void CameraRig::turn(float right, float up) {
  takeOver();
  const Vec3 from = eye();
  yaw_ -= right;
  pitch_ = std::clamp(pitch_ + up, -kLargestPitch, kLargestPitch);
  if (mode_ == CameraMode::kFly) pivot_ = from + distance_ * forward();
}

void CameraRig::turnByDrag(const glm::vec2& moved) {
  turn(-kTurnPerHeight * moved.x, -kTurnPerHeight * moved.y);
}

void CameraRig::zoomByNotches(float notches) {
  zoom(std::pow(kZoomPerNotch, notches));
}

void CameraRig::pan(float right, float up) {
  takeOver();
  const float height = 2.0F * distance_ * std::tan(0.5F * kFieldOfView);
  pivot_ += height * (right * this->right() + up * glm::cross(this->right(), forward()));
}

void CameraRig::zoom(float factor) {
  takeOver();
  const float to = std::clamp(distance_ / factor, kNearest, kFurthest);
  if (mode_ == CameraMode::kFly) {
    pivot_ += (distance_ - to) * forward();
  } else {
    distance_ = to;
  }
}

void CameraRig::move(const Vec3& along) {
  pivot_ += along.x * right() + along.y * kUp + along.z * forward();
}

void CameraRig::follow(const Vec3& point) {
  if (mode_ == CameraMode::kFollow) pivot_ = point;
}

Camera CameraRig::camera() const {
  Camera camera;
  camera.eye = eye();
  camera.target = pivot_;
  camera.up = kUp;
  camera.fieldOfView = kFieldOfView;
  camera.near = std::max(0.02F, 0.01F * distance_);
  camera.far = std::max(2000.0F, 20.0F * distance_);
  return camera;
}

}  // namespace scatter::viewer
