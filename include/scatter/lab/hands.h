#pragma once

#include <scatter/lab/hand_script.h>
#include <scatter/world/world.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace scatter {

namespace lab {
class Drag;
class Gathering;
class ThrowAim;
}  // namespace lab

/// A pull toward a point like that of a critically damped spring: the quickest that does not swing past it.
struct PullDef {
  float stiffness =
      12.0F;  ///< Radians per second: a distance within `reach` halves in about 1.7 / stiffness.

  /// Metres; from further away the pull is as from here, so that nothing gets faster than about half of
  /// stiffness · reach.
  float reach = 2.5F;
  float maxAcceleration = 500.0F;  ///< Metres per second squared.
};

struct HandsDef {
  PullDef drag{};
  float dragSpinDamping = 6.0F;  ///< Share of angular velocity that a dragged body loses, per second.
  PullDef gather{.stiffness = 4.0F, .reach = 4.0F, .maxAcceleration = 200.0F};

  /// Called before remove() deletes an object, for whoever keeps a pointer to it; may be empty.
  std::function<void(WorldObject&)> onRemove{};
};

/// What a ray meets.
struct Pick {
  WorldObject* object = nullptr;  ///< Never null.
  Vec3 point{0.0F};
  Vec3 normal{0.0F};
};

/// What a user does to a running world. Call between steps; the same calls at the same frames do the same.
/// What needs more than a moment - a drag, a gathering - acts in beforeStep(). Bodies may leave the world at
/// any time; what is done to a body that is not there is refused.
class Hands {
 public:
  /// The world must outlive them.
  explicit Hands(World& world, HandsDef def = {});
  Hands(const Hands&) = delete;
  Hands& operator=(const Hands&) = delete;
  ~Hands();

  /// The first object on the way.
  [[nodiscard]] std::optional<Pick> pick(const Vec3& from, const Vec3& to) const;

  /// Takes hold of a dynamic body that is not frozen, at a point of it, which is then pulled to a target:
  /// that point until dragTo(). The force is scaled by the mass that moves with the point; the load that the
  /// body bears, such as gravity, is carried, up to 30 m/s². Spin is damped. The physics knows that it is
  /// held. Ends the drag before. False if there is no such body.
  bool drag(BodyId body, const Vec3& point);
  void dragTo(const Vec3& target);  ///< Nothing happens while nothing is dragged.
  void drop();                      ///< Lets go; the body keeps its velocity.
  [[nodiscard]] std::optional<BodyId> dragged() const;
  [[nodiscard]] Vec3 grip() const;        ///< Where the dragged body is held now. Something must be dragged.
  [[nodiscard]] Vec3 dragTarget() const;  ///< Something must be dragged.

  /// Newton seconds, at a point. False if there is no such dynamic body, or if it is frozen.
  bool push(BodyId body, const Vec3& impulse, const Vec3& point);

  /// Throws a copy of an object so that its centre of mass starts at `from` and goes through `through`, at a
  /// mean speed in metres per second. Gravity and fields are taken into account as they are in its first
  /// step, in which they are measured. Fails unless the model is dynamic, the points differ and the speed is
  /// positive.
  [[nodiscard]] Result<WorldObject*> throwLike(BodyId model, const Vec3& from, const Vec3& through,
                                               float speed = 20.0F);

  /// Adds a copy of an object, at rest.
  [[nodiscard]] Result<WorldObject*> spawnLike(BodyId model, const Transform& pose);

  /// Deletes an object. False if it is not there. Whoever keeps a pointer to it must let go of it: see
  /// HandsDef::onRemove.
  bool remove(BodyId body);

  /// Pulls dynamic bodies - all there are at any time, if `bodies` is empty - to a point until release(),
  /// each by its centre of mass, and carries what load they bear together. In place of the gathering before.
  /// What is gathered is not held: a policy may give it any level.
  void gather(const Vec3& point, std::vector<BodyId> bodies = {});
  void release();
  [[nodiscard]] bool gathering() const { return gathering_ != nullptr; }

  /// Return how many bodies it was done to: dynamic ones, and see Physics::setFrozen().
  std::size_t freeze(std::span<const BodyId> bodies);
  std::size_t thaw(std::span<const BodyId> bodies);
  [[nodiscard]] bool isFrozen(BodyId body) const { return frozen_.count(body) != 0; }

  /// Asks for a level of these bodies, or of everything if there are none; returns how many of them took the
  /// request, which stands until it is fulfilled or retracted.
  std::size_t requestLevel(std::span<const BodyId> bodies, int level, Scope scope);
  void retract(std::span<const BodyId> bodies);  ///< Of everything, whoever asked, if there are none.

  /// Does what a script says. Fails as the method of that name does.
  [[nodiscard]] Result<void> perform(const HandAction& action);

  /// What was done until now, without what was refused.
  [[nodiscard]] const HandScript& script() const { return script_; }

  /// To be called before each step of this many seconds.
  void beforeStep(float seconds);

 private:
  [[nodiscard]] WorldObject* movable(BodyId body) const;
  [[nodiscard]] Result<WorldObject*> addCopy(BodyId model, BodyDef def);
  [[nodiscard]] BodyDef copyOf(const WorldObject& model) const;
  void letGo();
  void record(HandAction action);

  World& world_;
  HandsDef def_;
  HandScript script_;
  std::unique_ptr<lab::Drag> drag_;
  std::unique_ptr<lab::Gathering> gathering_;
  std::vector<lab::ThrowAim> throws_;
  std::set<BodyId> frozen_;
  std::uint64_t copies_ = 0;
};

}  // namespace scatter
