#pragma once

#include <scatter/world/body.h>
#include <scatter/world/level_event.h>
#include <scatter/world/physics.h>

#include <functional>
#include <string>

namespace scatter {

/// A body in a World, and what a program may do with it. Owned by the World; valid until removed.
class WorldObject {
 public:
  WorldObject(Physics& physics, BodyId body, BodyDef def);
  WorldObject(const WorldObject&) = delete;
  WorldObject& operator=(const WorldObject&) = delete;
  virtual ~WorldObject() = default;

  [[nodiscard]] BodyId body() const { return body_; }
  [[nodiscard]] const std::string& name() const { return def_.name; }

  /// What it was made from.
  [[nodiscard]] const BodyDef& def() const { return def_; }

  [[nodiscard]] BodyState state() const { return physics_.state(body_); }
  void setPose(const Transform& pose) { physics_.setPose(body_, pose); }
  void setVelocity(const Vec3& linear, const Vec3& angular) { physics_.setVelocity(body_, linear, angular); }
  void applyForce(const Vec3& force, const Vec3& point) { physics_.applyForce(body_, force, point); }
  void applyCentralForce(const Vec3& force) { physics_.applyCentralForce(body_, force); }
  void applyTorque(const Vec3& torque) { physics_.applyTorque(body_, torque); }
  void applyImpulse(const Vec3& impulse, const Vec3& point) { physics_.applyImpulse(body_, impulse, point); }

  /// Whether the World's fields act on it.
  bool inFields = true;

 protected:
  [[nodiscard]] Physics& physics() const { return physics_; }

 private:
  Physics& physics_;
  BodyId body_;
  BodyDef def_;
};

/// An object with several encapsulation levels: a transparent wrapper that switches only in a hybrid
/// world and otherwise simply is its finest level (report, sections 4.4 and 4.5.1).
class HybridObject final : public WorldObject {
 public:
  using WorldObject::WorldObject;

  [[nodiscard]] int level() const { return physics().switching().level(body()); }
  [[nodiscard]] int levelCount() const { return physics().switching().levelCount(body()); }

  /// Asks for a level, 1 the coarsest. False in a standard world.
  bool requestLevel(int level, Scope scope = Scope::kLocal) {
    return physics().switching().requestLevel(body(), level, scope);
  }
  void retractRequest() { physics().switching().retractRequest(body()); }

  /// Called after the step in which something happened to its requests.
  std::function<void(const LevelEvent&)> onLevelEvent;
};

}  // namespace scatter
