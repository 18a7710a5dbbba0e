#include "viewer/hand_tools.h"

#include <scatter/lab/selection.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

namespace scatter::viewer {
namespace {

constexpr float kReach = 2000.0F;       // metres
constexpr float kEmptyDepth = 20.0F;    // metres, where the ray hits nothing
constexpr float kSpawnDistance = 3.0F;  // metres before what is hit

}  // namespace

std::string_view toolName(Tool tool) {
  static constexpr std::array<std::string_view, kToolCount> kNames{"grab", "push", "throw", "gather",
                                                                   "spawn"};
  return kNames[static_cast<std::size_t>(tool)];
}

void HandTools::perform(const HandAction& action) {
  message_.clear();
  for (const auto& pane : panes_) {
    if (const auto done = pane->experiment().hands().perform(action); !done) message_ = done.error().message;
  }
}

WorldObject* HandTools::pickedObject() const {
  return picked_ ? panes_.front()->experiment().world().find(*picked_) : nullptr;
}

void HandTools::press(std::size_t pane, const Ray& ray, float clear) {
  const Hands& hands = panes_[pane]->experiment().hands();
  const auto hit = hands.pick(ray.origin + clear * ray.direction, ray.origin + kReach * ray.direction);
  depth_ = hit ? glm::length(hit->point - ray.origin) : clear + kEmptyDepth;
  act(hit, ray, clear);
}

void HandTools::act(const std::optional<Pick>& hit, const Ray& ray, float clear) {
  const Vec3 point = ray.origin + depth_ * ray.direction;
  const auto model = picked_ ? picked_ : hit ? std::optional(hit->object->body()) : std::nullopt;
  switch (tool) {
    case Tool::kGrab:
      picked_ = hit ? std::optional(hit->object->body()) : std::nullopt;
      if (!hit || hit->object->def().motion != Motion::kDynamic) break;
      perform(DragAction{hit->object->body(), hit->point});
      dragging_ = message_.empty();
      break;
    case Tool::kPush:
      if (hit && hit->object->def().motion == Motion::kDynamic) {
        perform(
            PushAction{hit->object->body(), impulse * hit->object->def().mass * ray.direction, hit->point});
      }
      break;
    case Tool::kThrow:
      if (model) perform(ThrowAction{*model, ray.origin + (clear + 1.0F) * ray.direction, point, throwSpeed});
      break;
    case Tool::kGather:
      perform(GatherAction{point, {}});
      gathering_ = true;
      break;
    case Tool::kSpawn:
      if (model)
        perform(SpawnAction{*model, {point - (hit ? kSpawnDistance : 0.0F) * ray.direction, kNoRotation}});
      break;
  }
}

void HandTools::move(const Ray& ray) {
  const Vec3 point = ray.origin + depth_ * ray.direction;
  if (dragging_) perform(DragToAction{point});
  if (gathering_) perform(GatherAction{point, {}});
}

void HandTools::release() {
  if (dragging_) perform(DropAction{});
  if (gathering_) perform(ReleaseAction{});
  dragging_ = gathering_ = false;
}

void HandTools::removePicked() {
  if (pickedObject() == nullptr) return;
  release();
  perform(RemoveAction{*picked_});
  picked_.reset();
}

void HandTools::toggleFrozen() {
  if (pickedObject() == nullptr) return;
  release();
  const bool frozen = panes_.front()->experiment().hands().isFrozen(*picked_);
  if (frozen) {
    perform(ThawAction{{*picked_}});
  } else {
    perform(FreezeAction{{*picked_}});
  }
}

std::vector<BodyId> HandTools::reached() const {
  const WorldObject* object = pickedObject();
  if (object == nullptr) return {};
  if (reach == RequestReach::kObject) return {object->body()};
  return objectsNamedLike(panes_.front()->experiment().world(), *object);
}

void HandTools::request(int level) {
  const std::vector<BodyId> bodies = reach == RequestReach::kAll ? std::vector<BodyId>{} : reached();
  if (bodies.empty() && reach != RequestReach::kAll) {
    message_ = "pick an object first, or ask everything";
    return;
  }
  const Scope scope = reach == RequestReach::kObject  ? Scope::kLocal
                      : reach == RequestReach::kGroup ? Scope::kGroup
                                                      : Scope::kGlobal;
  if (level > 0) {
    perform(RequestAction{level, scope, bodies});
  } else {
    perform(RetractAction{bodies});
  }
}

void HandTools::requestBy(int finer) {
  const World& world = panes_.back()->experiment().world();
  const LevelSwitching& switching = world.physics().switching();
  const auto hasLevels = [&switching](const WorldObject& object) {
    return switching.levelCount(object.body()) > 1;
  };
  const WorldObject* like = pickedObject();
  if (reach == RequestReach::kAll && (like == nullptr || !hasLevels(*like))) {
    const auto first = std::find_if(world.objects().begin(), world.objects().end(),
                                    [&](const auto& object) { return hasLevels(*object); });
    like = first != world.objects().end() ? first->get() : nullptr;
  }
  if (like == nullptr || !hasLevels(*like)) {
    message_ = "pick an object with levels first";
    return;
  }
  request(std::clamp(switching.level(like->body()) + finer, 1, switching.levelCount(like->body())));
}

void HandTools::reset() {
  picked_.reset();
  dragging_ = gathering_ = false;
  message_.clear();
}

}  // namespace scatter::viewer
