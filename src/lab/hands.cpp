#include <scatter/lab/hands.h>

#include <scatter/lab/recorder.h>

#include "lab/hand_drag.h"
#include "lab/hand_gather.h"
#include "lab/hand_throw.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <type_traits>
#include <utility>

namespace scatter {

namespace {

// What an action that is refused says.
std::string numberOf(BodyId body) {
  return "body " + std::to_string(static_cast<std::uint32_t>(body));
}

Result<void> require(bool done, BodyId body, const char* what) {
  return done ? Result<void>()
              : fail(numberOf(body) + " cannot be " + what + "; name a dynamic body that is there");
}

Result<void> discardValue(const Result<WorldObject*>& result) {
  return result ? Result<void>() : tl::unexpected(result.error());
}

}  // namespace

Hands::Hands(World& world, HandsDef def) : world_(world), def_(std::move(def)) {}

Hands::~Hands() = default;

std::optional<Pick> Hands::pick(const Vec3& from, const Vec3& to) const {
  const auto hit = world_.physics().castRay(from, to);
  WorldObject* object = hit ? world_.find(hit->body) : nullptr;
  if (object == nullptr) {
    return std::nullopt;
  }
  return Pick{.object = object, .point = hit->point, .normal = hit->normal};
}

bool Hands::drag(BodyId body, const Vec3& point) {
  const WorldObject* object = movable(body);
  if (object == nullptr) {
    return false;
  }
  letGo();
  drag_ = std::make_unique<lab::Drag>(*object, point);
  world_.physics().switching().setHeld(body, true);
  record(DragAction{body, point});
  return true;
}

void Hands::dragTo(const Vec3& target) {
  if (drag_) {
    drag_->target = target;
    record(DragToAction{target});
  }
}

void Hands::drop() {
  if (drag_) {
    letGo();
    record(DropAction{});
  }
}

std::optional<BodyId> Hands::dragged() const {
  return drag_ && world_.find(drag_->body()) != nullptr ? std::optional(drag_->body()) : std::nullopt;
}

Vec3 Hands::grip() const {
  assert(dragged());
  return drag_->grip(world_.physics().state(drag_->body()));
}

Vec3 Hands::dragTarget() const {
  assert(dragged());
  return drag_->target;
}

bool Hands::push(BodyId body, const Vec3& impulse, const Vec3& point) {
  WorldObject* object = movable(body);
  if (object == nullptr) {
    return false;
  }
  object->applyImpulse(impulse, point);
  record(PushAction{body, impulse, point});
  return true;
}

Result<WorldObject*> Hands::throwLike(BodyId model, const Vec3& from, const Vec3& through, float speed) {
  const WorldObject* object = world_.find(model);
  if (object == nullptr || object->def().motion != Motion::kDynamic) {
    return fail(numberOf(model) + " cannot be thrown; name a dynamic body that is there");
  }
  const float distance = glm::distance(from, through);
  if (!(distance > 0.0F) || !(speed > 0.0F) || !std::isfinite(distance) || !std::isfinite(speed)) {
    return fail("'" + object->name() +
                "' cannot be thrown; give two different points and a speed of more than 0 m/s");
  }
  constexpr auto kSeconds = static_cast<float>(kStepSeconds);
  const int steps = static_cast<int>(std::clamp(std::round(distance / (speed * kSeconds)), 2.0F, 36000.0F));
  const BodyState state = object->state();
  BodyDef def = copyOf(*object);
  def.pose = {from - (state.centerOfMass - state.pose.position), state.pose.rotation};
  def.linearVelocity =
      lab::launchVelocity(through - from, steps, Vec3(0.0F), def.material.linearDamping, kSeconds);
  auto thrown = addCopy(model, std::move(def));
  if (thrown) {
    throws_.emplace_back(**thrown, through, steps);
    record(ThrowAction{model, from, through, speed});
  }
  return thrown;
}

Result<WorldObject*> Hands::spawnLike(BodyId model, const Transform& pose) {
  const WorldObject* object = world_.find(model);
  if (object == nullptr) {
    return fail(numberOf(model) + " cannot be copied; name a body that is there");
  }
  BodyDef def = copyOf(*object);
  def.pose = pose;
  auto added = addCopy(model, std::move(def));
  if (added) {
    record(SpawnAction{model, pose});
  }
  return added;
}

bool Hands::remove(BodyId body) {
  WorldObject* object = world_.find(body);
  if (object == nullptr) {
    return false;
  }
  if (dragged() == body) {
    letGo();
  }
  if (def_.onRemove) {
    def_.onRemove(*object);
  }
  frozen_.erase(body);
  world_.remove(*object);
  record(RemoveAction{body});
  return true;
}

void Hands::gather(const Vec3& point, std::vector<BodyId> bodies) {
  gathering_ = std::make_unique<lab::Gathering>(point, bodies);
  record(GatherAction{point, std::move(bodies)});
}

void Hands::release() {
  if (gathering_) {
    gathering_.reset();
    record(ReleaseAction{});
  }
}

std::size_t Hands::freeze(std::span<const BodyId> bodies) {
  FreezeAction done;
  for (const BodyId body : bodies) {
    if (movable(body) != nullptr && world_.physics().setFrozen(body, true)) {
      if (dragged() == body) {
        letGo();
      }
      frozen_.insert(body);
      done.bodies.push_back(body);
    }
  }
  const std::size_t count = done.bodies.size();
  if (count > 0) {
    record(std::move(done));
  }
  return count;
}

std::size_t Hands::thaw(std::span<const BodyId> bodies) {
  ThawAction done;
  for (const BodyId body : bodies) {
    if (frozen_.erase(body) != 0 && world_.find(body) != nullptr) {
      world_.physics().setFrozen(body, false);
      done.bodies.push_back(body);
    }
  }
  const std::size_t count = done.bodies.size();
  if (count > 0) {
    record(std::move(done));
  }
  return count;
}

std::size_t Hands::requestLevel(std::span<const BodyId> bodies, int level, Scope scope) {
  LevelSwitching& switching = world_.physics().switching();
  std::size_t taken = 0;
  if (bodies.empty()) {
    for (const auto& object : world_.objects()) {
      taken += switching.requestLevel(object->body(), level, scope) ? 1 : 0;
    }
  }
  for (const BodyId body : bodies) {
    taken += world_.find(body) != nullptr && switching.requestLevel(body, level, scope) ? 1 : 0;
  }
  if (taken > 0) {
    record(RequestAction{level, scope, {bodies.begin(), bodies.end()}});
  }
  return taken;
}

void Hands::retract(std::span<const BodyId> bodies) {
  if (bodies.empty()) {
    world_.physics().switching().retractAllRequests();
  }
  for (const BodyId body : bodies) {
    if (world_.find(body) != nullptr) {
      world_.physics().switching().retractRequest(body);
    }
  }
  record(RetractAction{{bodies.begin(), bodies.end()}});
}

Result<void> Hands::perform(const HandAction& action) {
  return std::visit(
      [this](const auto& what) -> Result<void> {
        using Kind = std::decay_t<decltype(what)>;
        if constexpr (std::is_same_v<Kind, DragAction>) {
          return require(drag(what.body, what.point), what.body, "dragged");
        } else if constexpr (std::is_same_v<Kind, DragToAction>) {
          dragTo(what.target);
        } else if constexpr (std::is_same_v<Kind, DropAction>) {
          drop();
        } else if constexpr (std::is_same_v<Kind, PushAction>) {
          return require(push(what.body, what.impulse, what.point), what.body, "pushed");
        } else if constexpr (std::is_same_v<Kind, ThrowAction>) {
          return discardValue(throwLike(what.model, what.from, what.through, what.speed));
        } else if constexpr (std::is_same_v<Kind, SpawnAction>) {
          return discardValue(spawnLike(what.model, what.pose));
        } else if constexpr (std::is_same_v<Kind, RemoveAction>) {
          return require(remove(what.body), what.body, "removed");
        } else if constexpr (std::is_same_v<Kind, GatherAction>) {
          gather(what.point, what.bodies);
        } else if constexpr (std::is_same_v<Kind, ReleaseAction>) {
          release();
        } else if constexpr (std::is_same_v<Kind, FreezeAction>) {
          freeze(what.bodies);
        } else if constexpr (std::is_same_v<Kind, ThawAction>) {
          thaw(what.bodies);
        } else if constexpr (std::is_same_v<Kind, RequestAction>) {
          requestLevel(what.bodies, what.level, what.scope);
        } else {
          static_assert(std::is_same_v<Kind, RetractAction>);
          retract(what.bodies);
        }
        return {};
      },
      action);
}

void Hands::beforeStep(float seconds) {
  if (drag_ && !dragged()) {
    drag_.reset();
  }
  if (drag_) {
    drag_->apply(world_, def_, seconds);
  }
  if (gathering_) {
    gathering_->apply(world_, def_.gather, frozen_, seconds);
  }
  throws_.erase(std::remove_if(throws_.begin(), throws_.end(),
                               [&](lab::ThrowAim& aim) { return !aim.beforeStep(world_, seconds); }),
                throws_.end());
}

WorldObject* Hands::movable(BodyId body) const {
  WorldObject* object = world_.find(body);
  const bool moves = object != nullptr && object->def().motion == Motion::kDynamic && !isFrozen(body);
  return moves ? object : nullptr;
}

Result<WorldObject*> Hands::addCopy(BodyId model, BodyDef def) {
  auto added = world_.add(std::move(def));
  if (added) {
    ++copies_;
    (*added)->inFields = world_.find(model)->inFields;
  }
  return added;
}

BodyDef Hands::copyOf(const WorldObject& model) const {
  BodyDef def = model.def();
  def.name += "-copy-" + std::to_string(copies_ + 1);
  def.linearVelocity = Vec3(0.0F);
  def.angularVelocity = Vec3(0.0F);
  return def;
}

void Hands::letGo() {
  if (const auto body = dragged()) {
    world_.physics().switching().setHeld(*body, false);
  }
  drag_.reset();
}

void Hands::record(HandAction action) {
  script_.add(world_.frame(), std::move(action));
}

}  // namespace scatter
