#pragma once

#include <LinearMath/btTransform.h>
#include <scatter/math.h>

#include <cmath>

namespace scatter {

inline btVector3 toBullet(const Vec3& v) {
  return {v.x, v.y, v.z};
}
inline btQuaternion toBullet(const Quat& q) {
  return {q.x, q.y, q.z, q.w};
}
inline btTransform toBullet(const Transform& t) {
  return btTransform(toBullet(t.rotation), toBullet(t.position));
}

inline Vec3 fromBullet(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}
inline Quat fromBullet(const btQuaternion& q) {
  return {q.w(), q.x(), q.y(), q.z()};
}
inline Transform fromBullet(const btTransform& t) {
  return {fromBullet(t.getOrigin()), fromBullet(t.getRotation())};
}

inline bool isFinite(float x) {
  return std::isfinite(x);
}
inline bool isFinite(const Vec3& v) {
  return isFinite(v.x) && isFinite(v.y) && isFinite(v.z);
}
inline bool isFinite(const Quat& q) {
  return isFinite(q.x) && isFinite(q.y) && isFinite(q.z) && isFinite(q.w);
}
inline bool isFinite(const Transform& t) {
  return isFinite(t.position) && isFinite(t.rotation);
}
inline bool isFinite(const btVector3& v) {
  return isFinite(fromBullet(v));
}

}  // namespace scatter
