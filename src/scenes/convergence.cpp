#include <scatter/world/scene.h>

#include "scenes/ships.h"

namespace scatter {
namespace {

constexpr int kFrames = 1600;
constexpr float kStep = 1.0F / 60.0F;
constexpr float kSunRadius = 8.0F;
constexpr float kSunStart = 120.0F;

/// The report's Scene 2 (section 5.1.2.2): everything is drawn to one point, and at the end the Sun, which
/// the field does not move, reaches that point.
class Convergence final : public Scene {
 public:
  Result<void> build(World& world, const SceneOptions& options) override {
    auto models = loadShips("");
    if (!models) return fail(models.error().message);
    Random random(options.seed);
    const SwarmDef swarm{
        .hunters = 10, .fighters = 10, .asteroids = 10, .innerRadius = 50.0F, .outerRadius = 75.0F};
    if (auto added = addSwarm(world, *models, swarm, random); !added) return added;
    world.addField(std::make_unique<PointField>(Vec3(0.0F), 4.0F, 110.0F));

    BodyDef sun;
    sun.name = "sun";
    sun.shape = Sphere{kSunRadius};
    sun.mass = 1.0e6F;
    sun.pose.position = Vec3(0.0F, kSunStart, 0.0F);
    sun.linearVelocity = Vec3(0.0F, -kSunStart / (static_cast<float>(kFrames) * kStep), 0.0F);
    sun.mayRest = false;
    auto added = world.add(std::move(sun));
    if (!added) return fail(added.error().message);
    (*added)->inFields = false;
    return {};
  }
};

const SceneRegistration kRegister({
    "convergence",
    "the report's Scene 2: 10 Hunters, 10 Fighters, 10 asteroids and the Sun meet at one point",
    kFrames,
    [] { return std::make_unique<Convergence>(); },
});

}  // namespace
}  // namespace scatter
