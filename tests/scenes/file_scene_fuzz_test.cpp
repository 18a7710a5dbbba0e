// Damaged scene files that can still be read make worlds, or an error in one line. $SCATTER_FUZZ_SECONDS
// makes it go on for longer.

#include <gtest/gtest.h>
#include <scatter/bullet/bullet_physics.h>

#include <chrono>
#include <cstdlib>
#include <string>

#include "io/rich_scene.h"
#include "io/scene_file/toml_mutator.h"
#include "scenes/file_scene.h"

namespace scatter::test {
namespace {

constexpr std::size_t kMostBodies = 300;  // more are slow, and nothing new

struct Outcome {
  int built = 0;
  int refused = 0;
};

void fuzz(std::uint64_t seed, Outcome& outcome) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  const auto file = parseSceneFile(TomlMutator(seed).mutate(kRichScene), "fuzz.toml");
  if (!file || file->bodies.size() > kMostBodies) return;
  FileScene scene(std::make_shared<const SceneFile>(*file));
  PhysicsDef def;
  scene.configure(def);
  World world(makeBulletPhysics(def));
  if (const auto built = scene.build(world, {.seed = seed}); !built) {
    EXPECT_EQ(built.error().message.rfind("fuzz.toml:", 0), 0U) << built.error().message;
    EXPECT_EQ(built.error().message.find('\n'), std::string::npos);
    ++outcome.refused;
    return;
  }
  for (int frame = 0; frame < 35 && !world.physics().findInvalidState(); ++frame) {
    scene.update(world);
    world.step(1.0F / 60.0F);
  }
  ++outcome.built;
}

TEST(FileSceneFuzz, DamagedFilesMakeWorldsOrAnError) {
  constexpr std::uint64_t kCases = 800;
  const char* seconds = std::getenv("SCATTER_FUZZ_SECONDS");
  const auto end =
      std::chrono::steady_clock::now() + std::chrono::seconds(seconds != nullptr ? std::atoi(seconds) : 0);
  Outcome outcome;
  for (std::uint64_t seed = 0; seed < kCases || std::chrono::steady_clock::now() < end; ++seed) {
    fuzz(seed, outcome);
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_GT(outcome.built, 10);
  RecordProperty("built", outcome.built);
  RecordProperty("refused", outcome.refused);
}

}  // namespace
}  // namespace scatter::test
