// Damaged scene files are read or refused, in one line; nothing else happens. $SCATTER_FUZZ_SECONDS makes it
// go on for longer.

#include <scatter/io/file.h>
#include <scatter/io/scene_file.h>
#include <scatter/io/scene_library.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "io/rich_scene.h"
#include "io/scene_file/toml_mutator.h"
#include "trials.h"

namespace scatter {
namespace {

bool isFinite(const Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void expectSound(const SceneFile& scene) {
  EXPECT_LE(scene.bodies.size(), kMostSceneBodies);
  std::size_t bodies = 0;
  for (const SceneFileObject& object : scene.objects) {
    EXPECT_EQ(object.firstBody, bodies);
    bodies += object.count;
    EXPECT_TRUE(!object.mass || (std::isfinite(*object.mass) && *object.mass > 0.0F));
    EXPECT_TRUE(isFinite(object.velocity.vector) && std::isfinite(object.velocity.amount));
    EXPECT_NEAR(glm::length(object.orientation.rotation), 1.0F, 1e-3F);
    if (const auto* terrain = std::get_if<SceneFileTerrain>(&object.shape)) {
      EXPECT_TRUE(terrain->size[0] > 0.0F && terrain->size[1] > 0.0F && terrain->relief >= 0.0F);
      EXPECT_TRUE(terrain->cells[0] > 0 && terrain->cells[1] > 0);
      EXPECT_EQ(object.motion, SceneFileMotion::kStatic);
    }
    if (const auto* places = std::get_if<std::vector<Vec3>>(&object.placement)) {
      EXPECT_EQ(places->size(), object.count);
      EXPECT_TRUE(std::all_of(places->begin(), places->end(), isFinite));
    }
    if (const auto* in = std::get_if<SceneFileRandomPlaces>(&object.placement)) {
      EXPECT_LT(in->region, scene.regions.size());
    }
  }
  EXPECT_EQ(bodies, scene.bodies.size());
  for (const SceneFileJoint& joint : scene.joints) {
    EXPECT_LT(joint.bodyA, bodies);
    EXPECT_LT(joint.bodyB.value_or(0), bodies);
  }
  for (const SceneFileEvent& event : scene.events) {
    for (const std::size_t body : event.bodies) EXPECT_LT(body, bodies);
    if (const auto* deed = std::get_if<SceneFileSwitch>(&event.deed)) {
      EXPECT_LT(deed->field, scene.fields.size());
    }
  }
}

void expectOneLine(const std::string& message) {
  EXPECT_EQ(message.rfind("fuzz.toml:", 0), 0U) << message;
  EXPECT_LT(message.size(), 600U) << message;
  EXPECT_TRUE(std::none_of(message.begin(), message.end(), [](char c) {
    return static_cast<unsigned char>(c) < 0x20;
  })) << message;
}

struct Outcome {
  int read = 0;
  int refused = 0;
};

void fuzz(const std::string& text, std::uint64_t seed, Outcome& outcome) {
  test::TomlMutator mutator(seed);
  SCOPED_TRACE("seed " + std::to_string(seed));
  if (const auto scene = parseSceneFile(mutator.mutate(text), "fuzz.toml")) {
    expectSound(*scene);
    ++outcome.read;
  } else {
    expectOneLine(scene.error().message);
    ++outcome.refused;
  }
}

std::vector<std::string> texts() {
  std::vector<std::string> texts{test::kRichScene, test::kRichScene, test::kRichScene};
  for (const std::string& name : sceneFileNames()) {
    const auto text = findSceneFile(name).and_then([](const auto& file) { return readFile(file); });
    EXPECT_TRUE(text);
    texts.push_back(text.value_or(""));
  }
  return texts;
}

TEST(SceneFileFuzz, TheRichFileIsSound) {
  const auto scene = parseSceneFile(test::kRichScene, "fuzz.toml");
  ASSERT_TRUE(scene) << scene.error().message;
  expectSound(*scene);
}

TEST(SceneFileFuzz, DamagedFilesAreReadOrRefused) {
  constexpr std::uint64_t kCases = test::trials(6000);
  const char* seconds = std::getenv("SCATTER_FUZZ_SECONDS");
  const auto end =
      std::chrono::steady_clock::now() + std::chrono::seconds(seconds != nullptr ? std::atoi(seconds) : 0);
  const std::vector<std::string> all = texts();
  Outcome outcome;
  std::uint64_t seed = 0;
  for (; seed < kCases || std::chrono::steady_clock::now() < end; ++seed) {
    fuzz(all[seed % all.size()], seed, outcome);
    ASSERT_FALSE(HasFailure());
  }
  // Both must occur, or the fuzzer tests nothing.
  EXPECT_GT(outcome.read, test::trials(100));
  EXPECT_GT(outcome.refused, test::trials(1000));
  RecordProperty("inputs", std::to_string(seed));
}

}  // namespace
}  // namespace scatter
