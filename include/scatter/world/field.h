#pragma once

#include <scatter/math.h>

namespace scatter {

/// A force on every dynamic body of a world, proportional to its mass (report, section 2.7.1.1).
class Field {
 public:
  Field() = default;
  Field(const Field&) = delete;
  Field& operator=(const Field&) = delete;
  virtual ~Field() = default;

  /// Metres per second squared at `position`, world frame.
  [[nodiscard]] virtual Vec3 acceleration(const Vec3& position) const = 0;
};

/// Constant acceleration toward a point inside a radius, none outside it, so that fast bodies escape.
class PointField final : public Field {
 public:
  PointField(const Vec3& center, float acceleration, float radius);
  [[nodiscard]] Vec3 acceleration(const Vec3& position) const override;

 private:
  Vec3 center_;
  float acceleration_;
  float radius_;
};

}  // namespace scatter
