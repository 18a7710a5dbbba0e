#include <scatter/world/scene.h>

#include "scenes/ships.h"

namespace scatter {
namespace {

constexpr float kStart = 14.0F;        // metres from the centre
constexpr float kAcceleration = 2.0F;  // m/s²
constexpr float kMiss = 0.2F;          // metres by which the ships pass each other's centre line
constexpr float kBounce = 0.8F;        // enough for their bounds to part after the first collision

/// The report's Scene 1 (section 5.1.2.1): a Hunter and a Fighter are drawn together, collide, part, meet
/// again and settle into a slow rotation about the centre.
class Duel final : public Scene {
 public:
  Result<void> build(World& world, const SceneOptions& /*options*/) override {
    auto models = loadShips("");
    if (!models) return fail(models.error().message);
    // A model looks along x, so the Fighter turns half round to face the Hunter.
    const Quat halfTurn(0.0F, 0.0F, 1.0F, 0.0F);
    if (auto added = addShip(world, *models->hunter, "hunter", {{-kStart, kMiss, 0.0F}, kNoRotation});
        !added) {
      return added;
    }
    if (auto added = addShip(world, *models->fighter, "fighter", {{kStart, -kMiss, 0.0F}, halfTurn});
        !added) {
      return added;
    }
    world.addField(std::make_unique<PointField>(Vec3(0.0F), kAcceleration, 4.0F * kStart));
    return {};
  }

 private:
  static Result<void> addShip(World& world, const Model& model, const char* name, const Transform& pose) {
    BodyDef def = shipBody(model, name, pose);
    def.material.restitution = kBounce;
    def.material.angularDamping = 0.3F;
    def.material.linearDamping = 0.2F;
    auto added = world.add(std::move(def));
    if (!added) return fail(added.error().message);
    return {};
  }
};

const SceneRegistration kRegister({
    "duel",
    "the report's Scene 1: a Hunter and a Fighter collide, part, and come to rest against each other",
    1300,
    [] { return std::make_unique<Duel>(); },
});

}  // namespace
}  // namespace scatter
