// A scene of one's own, compared in a standard and a hybrid world.

#include <scatter/bullet/bullet_physics.h>
#include <scatter/io/model_library.h>
#include <scatter/lab/comparison.h>

#include <cstdio>

class Drop final : public scatter::Scene {
 public:
  scatter::Result<void> build(scatter::World& world, const scatter::SceneOptions& /*options*/) override {
    auto ship = scatter::loadModel("hunter");  // levels and mass from a COLLADA physics file
    if (!ship) return scatter::fail(ship.error().message);
    for (const float x : {-20.0F, 20.0F}) {
      scatter::BodyDef body{.name = "ship", .shape = (*ship)->levels, .mass = (*ship)->mass};
      body.pose.position.x = x;
      if (auto added = world.add(body); !added) return scatter::fail(added.error().message);
    }
    world.addField(std::make_unique<scatter::PointField>(scatter::Vec3(0.0F), 2.0F, 50.0F));
    return {};
  }
};

const scatter::SceneRegistration kDrop({"drop", "two ships meet", 600,
                                        [] { return std::make_unique<Drop>(); }});

int main() {
  scatter::RunOptions standard{.scene = "drop", .engine = scatter::makeBulletPhysics};
  scatter::RunOptions hybrid = standard;
  hybrid.physics.world = scatter::WorldKind::kHybrid;
  hybrid.physics.switching.budget.units = 500.0;  // or .milliseconds
  auto comparison = scatter::compareWorlds({.runs = {standard, hybrid}, .repeat = 2});
  if (!comparison) {
    std::fprintf(stderr, "%s\n", comparison.error().message.c_str());
    return 1;
  }
  std::fputs(scatter::formatTable(*comparison).c_str(), stdout);
}
