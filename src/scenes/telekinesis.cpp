#include <scatter/world/scene.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "scenes/placement.h"
#include "scenes/props.h"
#include "scenes/room.h"

namespace scatter {
namespace {

constexpr float kGravity = 9.81F;      // m/s²
constexpr std::uint64_t kLift = 30;    // frame in which everything is lifted
constexpr std::uint64_t kThrow = 150;  // and in which the throw begins
constexpr std::uint64_t kPulse = 45;   // frames from one pulse to the next
constexpr std::uint64_t kPush = 35;    // of those, with force
constexpr int kPulses = 6;
constexpr float kHover = 2.5F;       // metres to which things are lifted
constexpr float kLiftPull = 2.5F;    // m/s² more than gravity
constexpr float kThrowPull = 14.0F;  // m/s² toward the target
constexpr Vec3 kTarget{0.0F, 2.2F, 0.0F};

constexpr RoomDef kRoom{.halfWidth = 12.0F, .height = 9.0F, .ceiling = true};
constexpr int kGridColumns = 13;       // of the grid on which things stand
constexpr float kGridSpacing = 1.75F;  // metres
constexpr float kLiftedSpin = 1.5F;    // rad/s, given when lifted

/// A will that moves things: lifts them, or pulls them to one point, and holds them up against gravity while
/// it does.
class Will final : public Field {
 public:
  enum class Deed { kNothing, kRaise, kPull };
  Deed deed = Deed::kNothing;

  [[nodiscard]] Vec3 acceleration(const Vec3& position) const override {
    if (deed == Deed::kNothing) return Vec3(0.0F);
    const Vec3 hold(0.0F, kGravity, 0.0F);
    if (deed == Deed::kPull) return hold + throw_.acceleration(position);
    const float missing = std::clamp(kHover - position.y, -1.0F, 1.0F);
    return hold + Vec3(0.0F, kLiftPull * missing, 0.0F);
  }

 private:
  PointField throw_{kTarget, kThrowPull, 4.0F * kRoom.halfWidth};
};

/// What the will does in a frame.
Will::Deed deedAt(std::uint64_t frame) {
  if (frame < kLift) return Will::Deed::kNothing;
  if (frame < kThrow) return Will::Deed::kRaise;
  const std::uint64_t pulse = (frame - kThrow) / kPulse;
  const bool pushes = pulse < kPulses && (frame - kThrow) % kPulse < kPush;
  return pushes ? Will::Deed::kPull : Will::Deed::kNothing;
}

/// The places on the floor: a grid without its corners and without the nine around the target.
std::vector<Vec3> floorPlaces() {
  constexpr int kMiddle = kGridColumns / 2;
  std::vector<Vec3> places;
  for (int x = -kMiddle; x <= kMiddle; ++x) {
    for (int z = -kMiddle; z <= kMiddle; ++z) {
      const bool nearTarget = std::abs(x) <= 1 && std::abs(z) <= 1;
      const bool corner = std::abs(x) == kMiddle && std::abs(z) == kMiddle;
      if (nearTarget || corner) continue;
      places.push_back(kGridSpacing * Vec3(x, 0.0F, z));
    }
  }
  return places;
}

/// The game that the report starts from (section 1.1): everything in a room is lifted and thrown at one
/// target, arrives at once, falls, and lies in a heap.
class Telekinesis final : public Scene {
 public:
  Result<void> build(World& world, const SceneOptions& options) override {
    Random random(options.seed);
    if (auto added = addRoom(world, kRoom); !added) return added;
    BodyDef target;
    target.name = "target";
    target.shape = Box{{0.35F, 0.5F * kTarget.y, 0.35F}};
    target.motion = Motion::kStatic;
    target.pose.position = 0.5F * kTarget;
    if (auto added = world.add(std::move(target)); !added) return fail(added.error().message);
    if (auto added = addProps(world, random); !added) return added;
    auto will = std::make_unique<Will>();
    will_ = will.get();
    world.addField(std::move(will));
    return {};
  }

  void update(World& world) override {
    const Will::Deed deed = deedAt(world.frame());
    // A field leaves alone what sleeps.
    if (deed != will_->deed && deed != Will::Deed::kNothing) {
      for (const Thing& thing : things_) world.physics().activate(thing.object->body());
    }
    will_->deed = deed;
    if (world.frame() != kLift) return;
    for (const Thing& thing : things_) thing.object->setVelocity(Vec3(0.0F), thing.spin);
  }

  void forget(const WorldObject& object) override {
    std::erase_if(things_, [&object](const Thing& thing) { return thing.object == &object; });
  }

 private:
  struct Thing {
    WorldObject* object = nullptr;
    Vec3 spin{0.0F};  ///< Given when lifted, rad/s.
  };

  Result<void> addProps(World& world, Random& random) {
    const auto models = loadProps({"table", "chair", "shelf", "lamp", "crate", "barrel"});
    if (!models) return fail(models.error().message);
    std::vector<Vec3> places = floorPlaces();
    for (std::size_t left = places.size(); left > 1; --left) {
      std::swap(places[left - 1], places[random.below(left)]);
    }
    const Vec3 up(0.0F, 1.0F, 0.0F);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const std::shared_ptr<const Model>& model = (*models)[i % models->size()];
      const Quat turn = glm::angleAxis(random.uniform(-3.14F, 3.14F), up);
      BodyDef def =
          propBody(model, model->name + "-" + std::to_string(i / models->size() + 1), {places[i], turn});
      auto added = world.add(std::move(def));
      if (!added) return fail(added.error().message);
      things_.push_back({*added, kLiftedSpin * random.insideUnitBall()});
    }
    return {};
  }

  Will* will_ = nullptr;
  std::vector<Thing> things_;
};

const SceneRegistration kRegisterTelekinesis({
    "telekinesis",
    "the report's section 1.1: 156 pieces of furniture in a room, lifted and thrown at one target",
    900,
    [] { return std::make_unique<Telekinesis>(); },
});

}  // namespace
}  // namespace scatter
