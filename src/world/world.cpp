#include <scatter/world/world.h>

#include <algorithm>
#include <cassert>

namespace scatter {

namespace {

bool isHybrid(const BodyDef& def) {
  return std::holds_alternative<std::shared_ptr<const LevelSet>>(def.shape);
}

}  // namespace

World::World(std::unique_ptr<Physics> physics) : physics_(std::move(physics)) {
  assert(physics_);
}

World::~World() = default;

Result<WorldObject*> World::add(BodyDef def) {
  const Result<BodyId> body = physics_->createBody(def);
  if (!body) return tl::unexpected(body.error());
  std::unique_ptr<WorldObject> object;
  if (isHybrid(def)) {
    object = std::make_unique<HybridObject>(*physics_, *body, std::move(def));
  } else {
    object = std::make_unique<WorldObject>(*physics_, *body, std::move(def));
  }
  objects_.push_back(std::move(object));
  byBody_.emplace(*body, objects_.back().get());
  return objects_.back().get();
}

void World::remove(WorldObject& object) {
  const auto owner = std::find_if(objects_.begin(), objects_.end(),
                                  [&object](const auto& candidate) { return candidate.get() == &object; });
  assert(owner != objects_.end());
  physics_->destroyBody(object.body());
  byBody_.erase(object.body());
  objects_.erase(owner);
}

void World::step(float seconds) {
  applyFields();
  physics_->step(seconds);
  ++frame_;
  time_ += static_cast<double>(seconds);
  tellHybrids();
}

WorldObject* World::find(BodyId body) const {
  const auto found = byBody_.find(body);
  return found == byBody_.end() ? nullptr : found->second;
}

WorldObject* World::find(std::string_view name) const {
  const auto found = std::find_if(objects_.begin(), objects_.end(),
                                  [name](const auto& object) { return object->name() == name; });
  return found == objects_.end() ? nullptr : found->get();
}

void World::applyFields() {
  if (fields_.empty()) return;
  for (const auto& object : objects_) {
    if (!object->inFields || object->def().motion != Motion::kDynamic) continue;
    const BodyState state = object->state();
    if (state.asleep) continue;
    Vec3 acceleration(0.0F);
    for (const auto& field : fields_) acceleration += field->acceleration(state.centerOfMass);
    physics_->applyCentralForce(object->body(), object->def().mass * acceleration, /*wake=*/false);
  }
}

void World::tellHybrids() {
  for (const LevelEvent& event : physics_->switching().levelEvents()) {
    // An object may have gone since the event, or go in another one's callback.
    auto* hybrid = dynamic_cast<HybridObject*>(find(event.body));
    if (hybrid == nullptr || !hybrid->onLevelEvent) continue;
    // The copy outlives an object that removes itself.
    const auto tell = hybrid->onLevelEvent;
    tell(event);
  }
}

}  // namespace scatter
