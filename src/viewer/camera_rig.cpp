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
const Vec3 kUp(0.0F, 1.0F, 0.0F);

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

void CameraRig::frame(const Vec3& center, float radius) {
  pivot_ = center;
  distance_ = std::clamp(radius / std::sin(0.5F * kFieldOfView), kNearest, kFurthest);
}

void CameraRig::look(const Vec3& at, float right, float up, float distance) {
  pivot_ = at;
  yaw_ = glm::radians(right);
  pitch_ = std::clamp(-glm::radians(up), -kLargestPitch, kLargestPitch);
  distance_ = std::clamp(distance, kNearest, kFurthest);
}

void CameraRig::turn(float right, float up) {
  const Vec3 from = eye();
  yaw_ -= right;
  pitch_ = std::clamp(pitch_ + up, -kLargestPitch, kLargestPitch);
  if (mode_ == CameraMode::kFly) pivot_ = from + distance_ * forward();
}

void CameraRig::pan(float right, float up) {
  const float height = 2.0F * distance_ * std::tan(0.5F * kFieldOfView);
  pivot_ += height * (right * this->right() + up * glm::cross(this->right(), forward()));
}

void CameraRig::zoom(float factor) {
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
