#include <scatter/world/scene.h>

#include <numbers>
#include <utility>

#include "scenes/ground.h"
#include "scenes/rocks.h"

// Scenes without an overload: what detail and switching cost where they have nothing to gain.

namespace scatter {
namespace {

constexpr int kFrames = 300;
constexpr float kBlockHalf = 0.5F;  // of a block, metres

/// Blocks in stacks on a square, each stack turned another way. Nothing may fall asleep.
Result<void> addStacks(World& world, int columns, int height, const BodyDef& block, Random& random) {
  constexpr float kSpacing = 3.0F;
  for (int stack = 0; stack < columns * columns; ++stack) {
    const float x = kSpacing * (static_cast<float>(stack % columns) - 0.5F * static_cast<float>(columns - 1));
    const int row = stack / columns;
    const float z = kSpacing * (static_cast<float>(row) - 0.5F * static_cast<float>(columns - 1));
    const Quat turn = glm::angleAxis(random.uniform(0.0F, std::numbers::pi_v<float>), Vec3(0.0F, 1.0F, 0.0F));
    for (int i = 0; i < height; ++i) {
      BodyDef def = block;
      def.name = "block-" + std::to_string(stack + 1) + "-" + std::to_string(i + 1);
      def.pose = {{x, kBlockHalf * static_cast<float>(2 * i + 1), z}, turn};
      def.mass = 100.0F;
      def.material.friction = 0.6F;
      def.mayRest = false;
      if (auto added = world.add(std::move(def)); !added) return fail(added.error().message);
    }
  }
  return {};
}

/// Stacks of plain boxes, and four rocks that lie far from them and from one another.
class Stacks final : public Scene {
 public:
  Result<void> build(World& world, const SceneOptions& options) override {
    Random random(options.seed);
    if (auto added = addGround(world); !added) return added;
    BodyDef block;
    block.shape = Box{Vec3(kBlockHalf)};
    if (auto added = addStacks(world, 10, 5, block, random); !added) return added;
    const auto forms = makeRocks(4, random);
    if (!forms) return fail(forms.error().message);
    for (std::size_t i = 0; i < forms->size(); ++i) {
      const Transform pose{{40.0F + 10.0F * static_cast<float>(i), 1.1F * kRockRadius, 0.0F},
                           random.orientation()};
      auto added = world.add(rockBody((*forms)[i], "rock-" + std::to_string(i + 1), pose));
      if (!added) return fail(added.error().message);
    }
    return {};
  }
};

/// A block of eight boxes in one that just holds them.
Result<std::shared_ptr<const LevelSet>> makeBrick() {
  constexpr float kGap = 0.01F;  // half of what is between the boxes
  constexpr float kSide = 0.5F * (kBlockHalf - kGap);
  Level finest;
  for (const float x : {-1.0F, 1.0F}) {
    for (const float y : {-1.0F, 1.0F}) {
      for (const float z : {-1.0F, 1.0F}) {
        finest.parts.push_back(
            {.shape = Box{Vec3(kSide)}, .pose = {(kGap + kSide) * Vec3(x, y, z), kNoRotation}});
      }
    }
  }
  LevelSetDef def;
  def.name = "brick";
  def.levels = {Level{{{.shape = Box{Vec3(kBlockHalf)}, .pose = {}}}}, std::move(finest)};
  return LevelSet::create(std::move(def));
}

/// Low stacks of hybrids at rest.
class Hybrids final : public Scene {
 public:
  Result<void> build(World& world, const SceneOptions& options) override {
    Random random(options.seed);
    if (auto added = addGround(world); !added) return added;
    auto brick = makeBrick();
    if (!brick) return fail(brick.error().message);
    BodyDef block;
    block.shape = std::move(*brick);
    return addStacks(world, 10, 3, block, random);
  }
};

const SceneRegistration kRegisterStacks({
    "quiet_stacks",
    "100 stacks of plain boxes at rest, and four rocks far from them",
    kFrames,
    [] { return std::make_unique<Stacks>(); },
});

const SceneRegistration kRegisterHybrids({
    "quiet_hybrids",
    "100 low stacks of bricks of 8 boxes each, at rest",
    kFrames,
    [] { return std::make_unique<Hybrids>(); },
});

}  // namespace
}  // namespace scatter
