#include <scatter/world/scene.h>

#include "scenes/rocks.h"

namespace scatter {
namespace {

/// A thousand rocks of eight hulls fall into a pit and come to rest. None of them may fall asleep, so that
/// what a resting heap costs can be measured.
class Pile final : public Scene {
 public:
  Result<void> build(World& world, const SceneOptions& options) override {
    Random random(options.seed);
    return addHeap(world, {.rocks = 1000, .columns = 12}, random);
  }
};

const SceneRegistration kRegisterPile({
    "pile",
    "1000 rocks of 8 convex hulls each fall into a pit and come to rest",
    720,
    [] { return std::make_unique<Pile>(); },
});

}  // namespace
}  // namespace scatter
