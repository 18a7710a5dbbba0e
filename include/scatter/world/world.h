#pragma once

#include <scatter/result.h>
#include <scatter/world/field.h>
#include <scatter/world/physics.h>
#include <scatter/world/world_object.h>

#include <cstdint>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

namespace scatter {

/// The objects, fields and joints of a simulation, and the physics that moves them (report, section
/// 4.1). One thread at a time.
class World {
 public:
  explicit World(std::unique_ptr<Physics> physics);
  ~World();

  /// Adds an object; a HybridObject if the shape is a LevelSet. Fails as Physics::createBody does.
  [[nodiscard]] Result<WorldObject*> add(BodyDef def);
  void remove(WorldObject& object);

  [[nodiscard]] Result<JointId> join(const JointDef& def) { return physics_->createJoint(def); }
  [[nodiscard]] Result<VehicleId> addVehicle(const VehicleDef& def) { return physics_->createVehicle(def); }

  /// Fields act at the centre of mass of every dynamic object whose `inFields` is set. Asleep bodies stay
  /// asleep.
  void addField(std::unique_ptr<Field> field) { fields_.push_back(std::move(field)); }
  void clearFields() { fields_.clear(); }

  /// Applies fields, steps the physics by `seconds`, then tells hybrids about their requests.
  void step(float seconds);

  [[nodiscard]] std::uint64_t frame() const { return frame_; }  ///< Steps so far.
  [[nodiscard]] double time() const { return time_; }           ///< Simulated seconds so far.

  [[nodiscard]] std::span<const std::unique_ptr<WorldObject>> objects() const { return objects_; }
  [[nodiscard]] WorldObject* find(BodyId body) const;
  [[nodiscard]] WorldObject* find(std::string_view name) const;

  [[nodiscard]] Physics& physics() { return *physics_; }
  [[nodiscard]] const Physics& physics() const { return *physics_; }

 private:
  void applyFields();
  void tellHybrids();

  std::unique_ptr<Physics> physics_;
  std::vector<std::unique_ptr<Field>> fields_;
  std::vector<std::unique_ptr<WorldObject>> objects_;
  std::unordered_map<BodyId, WorldObject*> byBody_;
  std::uint64_t frame_ = 0;
  double time_ = 0.0;
};

}  // namespace scatter
