#pragma once

#include <scatter/world/field.h>

#include <memory>
#include <utility>

namespace scatter {

/// The same acceleration everywhere.
class UniformField final : public Field {
 public:
  explicit UniformField(const Vec3& acceleration) : acceleration_(acceleration) {}
  [[nodiscard]] Vec3 acceleration(const Vec3& /*position*/) const override { return acceleration_; }

 private:
  Vec3 acceleration_;
};

/// Another field, while it is on.
class SwitchedField final : public Field {
 public:
  SwitchedField(std::unique_ptr<Field> field, bool isOn) : on(isOn), field_(std::move(field)) {}
  [[nodiscard]] Vec3 acceleration(const Vec3& position) const override {
    return on ? field_->acceleration(position) : Vec3(0.0F);
  }

  bool on;

 private:
  std::unique_ptr<Field> field_;
};

}  // namespace scatter
