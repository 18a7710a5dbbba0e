#include <scatter/world/scene.h>

#include <string>

#include "scenes/ground.h"

namespace scatter {
namespace {

constexpr int kLayers = 12;
constexpr int kBlocksPerLayer = 3;
constexpr Vec3 kHalf{1.5F, 0.25F, 0.45F};  // a block three times as long as wide, metres
constexpr float kBlockMass = 20.0F;
constexpr std::uint64_t kKnockFrame = 240;  // the tower has come to rest by then
constexpr float kKnockSpeed = 14.0F;        // m/s
constexpr int kKnockedLayer = 4;            // one whose blocks lie along x

/// The report's Figure 1.1: a stable tower of blocks, and then one block is knocked out of it.
class Tower final : public Scene {
 public:
  Result<void> build(World& world, const SceneOptions& /*options*/) override {
    if (auto added = addGround(world); !added) return added;
    for (int layer = 0; layer < kLayers; ++layer) {
      for (int i = 0; i < kBlocksPerLayer; ++i) {
        auto block = addBlock(world, layer, i);
        if (!block) return fail(block.error().message);
        if (layer == kKnockedLayer && i == kBlocksPerLayer / 2) knocked_ = *block;
      }
    }
    return {};
  }

  void update(World& world) override {
    if (world.frame() != kKnockFrame) return;
    const BodyState state = knocked_->state();
    // Along the block's length, so that it slides out between its neighbours.
    const Vec3 along = state.pose.rotation * Vec3(1.0F, 0.0F, 0.0F);
    knocked_->applyImpulse(along * (kKnockSpeed * kBlockMass), state.pose.position);
  }

 private:
  static Result<WorldObject*> addBlock(World& world, int layer, int index) {
    constexpr float kGap = 0.002F;  // keeps neighbours from rubbing
    const float across = (static_cast<float>(index) - 1.0F) * (2.0F * kHalf.z + kGap);
    const float height = kHalf.y * static_cast<float>(2 * layer + 1);
    const bool turned = layer % 2 == 1;
    BodyDef block;
    block.name = "block-" + std::to_string(layer + 1) + "-" + std::to_string(index + 1);
    block.shape = Box{turned ? Vec3(kHalf.z, kHalf.y, kHalf.x) : kHalf};
    block.mass = kBlockMass;
    block.pose.position = turned ? Vec3(across, height, 0.0F) : Vec3(0.0F, height, across);
    block.material.friction = 0.6F;
    return world.add(std::move(block));
  }

  WorldObject* knocked_ = nullptr;
};

const SceneRegistration kRegister({
    "tower",
    "the report's Figure 1.1: a tower of blocks, and one of them is knocked out",
    900,
    [] { return std::make_unique<Tower>(); },
});

}  // namespace
}  // namespace scatter
