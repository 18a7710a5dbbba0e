#include <scatter/bullet/bullet_physics.h>
#include <scatter/lab/run.h>
#include <scatter/world/world.h>

#include <cstdio>

// A ball falls onto a floor; then a scene that this program did not write runs.
int main() {
  scatter::World world(scatter::makeBulletPhysics({.gravity = {0.0F, -9.8F, 0.0F}}));
  const auto floor =
      world.add({.name = "floor", .shape = scatter::Plane{}, .motion = scatter::Motion::kStatic, .pose = {}});
  const auto ball = world.add({.name = "ball", .shape = scatter::Sphere{0.5F}, .pose = {{0.0F, 2.0F, 0.0F}}});
  if (!floor || !ball) {
    return 1;
  }
  for (int frame = 0; frame < 240; ++frame) {
    world.step(1.0F / 60.0F);
  }
  std::printf("the ball rests at %.2f\n", static_cast<double>((*ball)->state().pose.position.y));

  const auto run = scatter::runScene({.scene = "tower", .engine = scatter::makeBulletPhysics, .frames = 3});
  if (!run) {
    std::printf("%s\n", run.error().message.c_str());
    return 1;
  }
  std::printf("%zu scenes, tower ran %d frames\n", scatter::SceneRegistry::instance().all().size(),
              static_cast<int>(run->summary.frames));
}
