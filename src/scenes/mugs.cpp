#include <scatter/world/scene.h>

#include <cassert>
#include <string>
#include <utility>

#include "scenes/placement.h"
#include "scenes/props.h"
#include "scenes/room.h"

namespace scatter {
namespace {

constexpr int kBatches = 20;             // each of three mugs and a lamp
constexpr std::uint64_t kInterval = 36;  // frames between batches: enough for one to make room for the next
constexpr RoomDef kTray{.halfWidth = 2.4F, .height = 6.0F};
constexpr float kQuarter = 1.2F;      // metres from the middle to that of a quarter of the tray
constexpr float kRelease = 3.4F;      // height from which the first batch falls, metres
constexpr float kReleaseRise = 0.1F;  // of each batch over the one before, as the heap grows
constexpr float kSpeed = 2.0F;        // m/s, downward
constexpr float kLargestSpin = 2.0F;  // rad/s

/// The report's Figure 3.4: lamps and mugs, poured into a tray, hook into each other. Only their finer levels
/// have the hollows and handles for it.
class Mugs final : public Scene {
 public:
  Result<void> build(World& world, const SceneOptions& options) override {
    random_ = Random(options.seed);
    auto models = loadProps({"mug", "lamp"});
    if (!models) return fail(models.error().message);
    mug_ = (*models)[0];
    lamp_ = (*models)[1];
    if (auto added = addRoom(world, kTray); !added) return added;
    return pour(world);
  }

  void update(World& world) override {
    if (poured_ == kBatches || world.frame() < kInterval * static_cast<std::uint64_t>(poured_)) return;
    [[maybe_unused]] const auto added = pour(world);
    assert(added && "the first batch was made of the same models");
  }

 private:
  Result<void> pour(World& world) {
    for (int quarter = 0; quarter < 4; ++quarter) {
      // The lamp goes round the quarters.
      const bool isLamp = quarter == poured_ % 4;
      const std::shared_ptr<const Model>& model = isLamp ? lamp_ : mug_;
      const std::string name = model->name + "-" + std::to_string(isLamp ? ++lamps_ : ++mugs_);
      const Vec3 center((quarter & 1) != 0 ? kQuarter : -kQuarter,
                        kRelease + kReleaseRise * static_cast<float>(poured_),
                        (quarter & 2) != 0 ? kQuarter : -kQuarter);
      const Quat turn = random_.orientation();
      BodyDef def = propBody(model, name, {center - turn * model->levels->mass().centerOfMass, turn});
      def.linearVelocity = Vec3(0.0F, -kSpeed, 0.0F);
      def.angularVelocity = kLargestSpin * random_.insideUnitBall();
      if (auto added = world.add(std::move(def)); !added) return fail(added.error().message);
    }
    ++poured_;
    return {};
  }

  Random random_{0};
  std::shared_ptr<const Model> mug_;
  std::shared_ptr<const Model> lamp_;
  int poured_ = 0;
  int mugs_ = 0;
  int lamps_ = 0;
};

const SceneRegistration kRegisterMugs({
    "mugs",
    "the report's Figure 3.4: 60 mugs and 20 lamps, poured into a tray, hook into each other",
    900,
    [] { return std::make_unique<Mugs>(); },
});

}  // namespace
}  // namespace scatter
