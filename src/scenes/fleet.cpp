#include <scatter/world/scene.h>

#include <string>
#include <utility>

#include "scenes/ships.h"

namespace scatter {
namespace {

constexpr float kAcceleration = 2.0F;  // m/s²: the first ships meet after about ten seconds

/// The report's Scene 2 at today's size: detailed ships and asteroids drawn to one point.
class Fleet final : public Scene {
 public:
  /// `models` is the suffix of the ships' models.
  Fleet(const SwarmDef& swarm, std::string models) : swarm_(swarm), models_(std::move(models)) {}

  Result<void> build(World& world, const SceneOptions& options) override {
    auto models = loadShips(models_);
    if (!models) return fail(models.error().message);
    Random random(options.seed);
    if (auto added = addSwarm(world, *models, swarm_, random); !added) return added;
    // Twice the shell: only what is thrown out at great speed escapes.
    world.addField(std::make_unique<PointField>(Vec3(0.0F), kAcceleration, 2.0F * swarm_.outerRadius));
    return {};
  }

 private:
  SwarmDef swarm_;
  std::string models_;
};

const SwarmDef kFleet{
    .hunters = 100, .fighters = 100, .asteroids = 100, .innerRadius = 100.0F, .outerRadius = 200.0F};
const SwarmDef kArmada{
    .hunters = 500, .fighters = 500, .asteroids = 500, .innerRadius = 120.0F, .outerRadius = 220.0F};

const SceneRegistration kRegisterFleet({
    "fleet",
    "200 ships of about 64 convex hulls each and 100 asteroids, drawn to one point",
    1600,
    [] { return std::make_unique<Fleet>(kFleet, "_hulls"); },
});

const SceneRegistration kRegisterFleetBoxes({
    "fleet_boxes",
    "the fleet with ships of 18 and 22 boxes each",
    1600,
    [] { return std::make_unique<Fleet>(kFleet, ""); },
});

const SceneRegistration kRegisterArmada({
    "armada",
    "1000 ships of about 64 convex hulls each and 500 asteroids, drawn to one point",
    1600,
    [] { return std::make_unique<Fleet>(kArmada, "_hulls"); },
});

}  // namespace
}  // namespace scatter
