#include "scenes/file_scene.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <iterator>
#include <string>
#include <utility>

#include "scenes/anchor.h"
#include "scenes/pieces.h"

namespace scatter {
namespace {

JointKind kindOf(const SceneFileJoint& joint) {
  switch (joint.kind) {
    case SceneFileJoint::Kind::kHinge:
      return HingeJoint{joint.lower, joint.upper};
    case SceneFileJoint::Kind::kSlider:
      return SliderJoint{joint.lower, joint.upper};
    case SceneFileJoint::Kind::kFixed:
      return FixedJoint{};
    case SceneFileJoint::Kind::kSixDof:
      return SixDofJoint{joint.linearLower, joint.linearUpper, joint.angularLower, joint.angularUpper};
    case SceneFileJoint::Kind::kPoint:
      break;
  }
  return PointJoint{};
}

std::unique_ptr<Field> makeField(const SceneFileField& field) {
  if (field.kind == SceneFileField::Kind::kPoint) {
    return std::make_unique<PointField>(field.center, field.acceleration, field.radius);
  }
  return std::make_unique<UniformField>(field.acceleration * field.direction);
}

}  // namespace

tl::unexpected<Error> FileScene::failAt(int line, const std::string& what) const {
  return fail(file_->path.string() + ":" + std::to_string(line) + ": " + what);
}

std::size_t FileScene::objectOf(std::size_t body) const {
  const auto after = std::upper_bound(
      file_->objects.begin(), file_->objects.end(), body,
      [](std::size_t index, const SceneFileObject& object) { return index < object.firstBody; });
  return static_cast<std::size_t>(after - file_->objects.begin()) - 1;
}

void FileScene::configure(PhysicsDef& physics) const {
  physics.gravity = file_->gravity;
  physics.solverIterations = file_->solverIterations.value_or(physics.solverIterations);
}

Result<void> FileScene::build(World& world, const SceneOptions& options) {
  world.physics().setGravity(file_->gravity);
  SceneModels models(file_->path.parent_path());
  Random random(options.seed);
  if (auto added = addObjects(world, models, random); !added) return added;
  addFields(world);
  if (auto added = addJoints(world); !added) return added;
  return preparePieces(models);
}

Result<void> FileScene::addObjects(World& world, SceneModels& models, Random& random) {
  FileBodies bodies(*file_, models, random);
  for (const SceneFileObject& object : file_->objects) {
    auto defs = bodies.make(object);
    if (!defs) return tl::unexpected(defs.error());
    for (BodyDef& def : *defs) {
      const auto added = world.add(std::move(def));
      if (!added) return failAt(object.line, added.error().message);
      (*added)->inFields = object.inFields;
      bodies_.push_back(*added);
    }
  }
  return {};
}

void FileScene::addFields(World& world) {
  for (const SceneFileField& field : file_->fields) {
    auto switched = std::make_unique<SwitchedField>(makeField(field), field.on);
    fields_.push_back(switched.get());
    world.addField(std::move(switched));
  }
}

Result<void> FileScene::addJoints(World& world) {
  WorldObject* anchor = nullptr;
  for (const SceneFileJoint& joint : file_->joints) {
    if (!joint.bodyB && anchor == nullptr) {
      const auto added = addAnchor(world);
      if (!added) return failAt(joint.line, added.error().message);
      anchor = *added;
    }
    JointDef def;
    def.kind = kindOf(joint);
    def.bodyA = bodies_[joint.bodyA]->body();
    def.bodyB = joint.bodyB ? bodies_[*joint.bodyB]->body() : anchor->body();
    def.frame = joint.frame;
    def.bodiesCollide = joint.bodiesCollide;
    if (const auto joined = world.join(def); !joined) return failAt(joint.line, joined.error().message);
  }
  return {};
}

Result<void> FileScene::preparePieces(SceneModels& models) {
  std::size_t count = 0;
  for (const SceneFileEvent& event : file_->events) {
    const auto* deed = std::get_if<SceneFileBreak>(&event.deed);
    if (deed == nullptr) continue;
    for (const std::size_t body : event.bodies) {
      const std::size_t object = objectOf(body);
      const std::pair key(object, deed->shrink);
      if (!pieces_.contains(key)) {
        auto made = makePieces(file_->objects[object], bodies_[body]->def(), deed->shrink, models);
        if (!made) return failAt(event.line, made.error().message);
        pieces_.emplace(key, std::move(*made));
      }
      count += pieces_.at(key).gibs.size();
    }
    if (count > kMostSceneBodies) {
      return failAt(event.line, "the bodies break into more than " + std::to_string(kMostSceneBodies) +
                                    " pieces; break fewer of them");
    }
  }
  return {};
}

void FileScene::update(World& world) {
  while (nextEvent_ < file_->events.size() && file_->events[nextEvent_].frame <= world.frame()) {
    perform(world, file_->events[nextEvent_++]);
  }
}

void FileScene::forget(const WorldObject& object) {
  const auto found = std::find(bodies_.begin(), bodies_.end(), &object);
  if (found != bodies_.end()) *found = nullptr;
}

void FileScene::perform(World& world, const SceneFileEvent& event) {
  std::visit([&](const auto& deed) { perform(world, event, deed); }, event.deed);
}

std::vector<WorldObject*> FileScene::movable(const SceneFileEvent& event) const {
  std::vector<WorldObject*> objects;
  for (const std::size_t body : event.bodies) {
    WorldObject* object = bodies_[body];
    if (object != nullptr && object->def().motion == Motion::kDynamic) objects.push_back(object);
  }
  return objects;
}

void FileScene::perform(World& /*world*/, const SceneFileEvent& event, const SceneFileThrow& deed) {
  Vec3 target(0.0F);
  if (const auto* point = std::get_if<Vec3>(&deed.target)) {
    target = *point;
  } else {
    const WorldObject* body = bodies_[std::get<std::size_t>(deed.target)];
    if (body == nullptr) return;
    target = body->state().centerOfMass;
  }
  for (WorldObject* object : movable(event)) {
    const BodyState state = object->state();
    Vec3 velocity = target;
    if (deed.speed) {
      const Vec3 way = target - state.centerOfMass;
      const float distance = glm::length(way);
      velocity = distance > 0.0F ? way * (*deed.speed / distance) : state.linearVelocity;
    }
    object->setVelocity(velocity, deed.spin.value_or(state.angularVelocity));
  }
}

void FileScene::perform(World& /*world*/, const SceneFileEvent& event, const SceneFileKnock& deed) {
  for (WorldObject* object : movable(event)) {
    const BodyState state = object->state();
    const Vec3 along = deed.inBodyFrame ? state.pose.rotation * deed.direction : deed.direction;
    const float impulse = deed.impulse ? *deed.impulse : deed.speed.value_or(0.0F) * object->def().mass;
    object->applyImpulse(along * impulse, state.centerOfMass);
  }
}

void FileScene::perform(World& world, const SceneFileEvent& event, const SceneFileBreak& deed) {
  for (const std::size_t body : event.bodies) {
    if (bodies_[body] == nullptr) continue;
    breakBody(world, body, pieces_.at({objectOf(body), deed.shrink}), deed.burst);
  }
}

void FileScene::breakBody(World& world, std::size_t body, const Breakable& kind, float burst) {
  WorldObject& object = *bodies_[body];
  const BodyDef def = object.def();
  const BodyState state = object.state();
  const bool inFields = object.inFields;
  Breakable breakable = kind;
  breakable.mass = def.mass;
  world.remove(object);
  bodies_[body] = nullptr;
  for (BodyDef& gib : breakApart(breakable, def, state, burst)) {
    // A body whose state is not finite has no pieces either; the run ends on it.
    if (const auto added = world.add(std::move(gib))) (*added)->inFields = inFields;
  }
}

void FileScene::perform(World& world, const SceneFileEvent& event, const SceneFileRemove& /*deed*/) {
  for (const std::size_t body : event.bodies) {
    if (bodies_[body] == nullptr) continue;
    world.remove(*bodies_[body]);
    bodies_[body] = nullptr;
  }
}

void FileScene::perform(World& world, const SceneFileEvent& /*event*/, const SceneFileSwitch& deed) {
  fields_[deed.field]->on = deed.on;
  if (!deed.on) return;
  // A field leaves alone what sleeps.
  for (const auto& object : world.objects()) {
    if (object->inFields && object->def().motion == Motion::kDynamic)
      world.physics().activate(object->body());
  }
}

}  // namespace scatter
