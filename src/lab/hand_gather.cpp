#include "lab/hand_gather.h"

namespace scatter::lab {

Gathering::Gathering(const Vec3& point, std::vector<BodyId> bodies)
    : point_(point), bodies_(bodies.begin(), bodies.end()) {}

bool Gathering::takes(const WorldObject& object, const std::set<BodyId>& frozen) const {
  return object.def().motion == Motion::kDynamic && frozen.count(object.body()) == 0 &&
         (bodies_.empty() || bodies_.count(object.body()) != 0);
}

// The mean over all, in which what they do to each other cancels out.
void Gathering::followLoad(const World& world, float seconds) {
  Vec3 momentum(0.0F);
  float mass = 0.0F;
  for (const Pulled& pulled : pulled_) {
    if (world.find(pulled.body) != nullptr) {
      momentum += pulled.mass * (world.physics().state(pulled.body).linearVelocity - pulled.expected);
      mass += pulled.mass;
    }
  }
  if (mass > 0.0F) {
    load_.follow(momentum / (mass * seconds));
  }
}

void Gathering::apply(World& world, const PullDef& def, const std::set<BodyId>& frozen, float seconds) {
  followLoad(world, seconds);
  pulled_.clear();
  for (const auto& object : world.objects()) {
    if (!takes(*object, frozen)) {
      continue;
    }
    const BodyState state = object->state();
    const Vec3 acceleration =
        pullAcceleration(def, point_ - state.centerOfMass, state.linearVelocity, seconds) -
        load_.acceleration();
    const float mass = object->def().mass;
    object->applyCentralForce(mass * acceleration);
    pulled_.push_back({object->body(), mass, state.linearVelocity + seconds * acceleration});
  }
}

}  // namespace scatter::lab
