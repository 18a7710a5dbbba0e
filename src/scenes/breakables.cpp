#include <scatter/world/scene.h>

#include <cassert>
#include <glm/geometric.hpp>
#include <string>
#include <utility>
#include <vector>

#include "scenes/breakable.h"
#include "scenes/placement.h"
#include "scenes/room.h"

namespace scatter {
namespace {

constexpr RoomDef kYard{.halfWidth = 7.0F, .height = 10.0F};
constexpr int kUrnColumns = 4;       // of the square of urns
constexpr float kUrnSpacing = 1.5F;  // metres between them
constexpr float kLowest = 1.5F;      // from which the first urn falls, metres
constexpr float kRise = 0.3F;        // of each urn over the one before
constexpr int kThrownPerSide = 4;
constexpr float kThrowSpeed = 9.0F;   // m/s, toward the middle
constexpr float kThrowHeight = 2.0F;  // metres; of every next one from a side, 1.2 m more
constexpr float kThrowRise = 1.2F;
constexpr float kFrameTime = 1.0F / 60.0F;
constexpr float kYardGravity = 9.81F;

/// Part of the impact's speed with which the furthest gibs fly apart.
constexpr float kBurst = 0.25F;
constexpr float kReach = 0.5F;  // of the furthest gibs, metres

/// The report's section 3.2: urns fall and boxes are thrown at them; what is hit hard breaks into its gibs.
class Breakables final : public Scene {
 public:
  Result<void> build(World& world, const SceneOptions& options) override {
    Random random(options.seed);
    if (auto added = addRoom(world, kYard); !added) return added;
    auto urn = makeUrn(random);
    if (!urn) return fail(urn.error().message);
    auto box = makeBoardBox(random);
    if (!box) return fail(box.error().message);
    urn_ = std::move(*urn);
    box_ = std::move(*box);
    if (auto added = addUrns(world, random); !added) return added;
    return addBoxes(world, random);
  }

  void update(World& world) override {
    std::vector<Whole> broken;
    std::vector<Whole> left;
    for (Whole& whole : wholes_) {
      const Vec3 velocity = whole.object->state().linearVelocity;
      const Vec3 fall(0.0F, -kYardGravity * kFrameTime, 0.0F);
      // What gravity did not do, a contact did.
      whole.impact = world.frame() == 0 ? 0.0F : glm::length(velocity - whole.velocity - fall);
      whole.velocity = velocity;
      (whole.impact > whole.kind->toughness ? broken : left).push_back(whole);
    }
    wholes_ = std::move(left);
    for (const Whole& whole : broken) breakIt(world, whole);
  }

  void forget(const WorldObject& object) override {
    std::erase_if(wholes_, [&object](const Whole& whole) { return whole.object == &object; });
  }

 private:
  struct Whole {
    WorldObject* object = nullptr;
    const Breakable* kind = nullptr;
    Vec3 velocity{0.0F};  ///< Before the last step.
    float impact = 0.0F;  ///< Change of velocity by contacts in the last step, m/s.
  };

  Result<void> add(World& world, const Breakable& kind, std::string name, const Transform& pose,
                   const Vec3& velocity) {
    BodyDef def;
    def.name = std::move(name);
    def.shape = kind.whole;
    def.mass = kind.mass;
    def.pose = pose;
    def.linearVelocity = velocity;
    def.material = {.friction = 0.9F, .restitution = 0.2F, .linearDamping = 0.1F, .angularDamping = 0.6F};
    auto added = world.add(std::move(def));
    if (!added) return fail(added.error().message);
    wholes_.push_back({*added, &kind, velocity});
    return {};
  }

  Result<void> addUrns(World& world, Random& random) {
    for (int i = 0; i < kUrnColumns * kUrnColumns; ++i) {
      constexpr float kMiddle = 0.5F * static_cast<float>(kUrnColumns - 1);
      const int row = i / kUrnColumns;
      const Vec3 place(kUrnSpacing * (static_cast<float>(i % kUrnColumns) - kMiddle),
                       kLowest + kRise * static_cast<float>(i),
                       kUrnSpacing * (static_cast<float>(row) - kMiddle));
      const Transform pose{place, random.orientation()};
      if (auto added = add(world, urn_, "urn-" + std::to_string(i + 1), pose, Vec3(0.0F)); !added)
        return added;
    }
    return {};
  }

  Result<void> addBoxes(World& world, Random& random) {
    int boxes = 0;
    for (const Vec3& inward : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)}) {
      for (int i = 0; i < kThrownPerSide; ++i) {
        const Vec3 aside = Vec3(inward.z, 0.0F, inward.x) * (1.5F * (static_cast<float>(i) - 1.5F));
        const float height = kThrowHeight + kThrowRise * static_cast<float>(i);
        const Transform pose{aside + Vec3(0.0F, height, 0.0F) - 5.6F * inward, random.orientation()};
        const Vec3 velocity = kThrowSpeed * inward + Vec3(0.0F, 1.0F, 0.0F);
        const std::string name = "box-" + std::to_string(++boxes);
        if (auto added = add(world, box_, name, pose, velocity); !added) return added;
      }
    }
    return {};
  }

  static void breakIt(World& world, const Whole& whole) {
    const BodyDef def = whole.object->def();
    const BodyState state = whole.object->state();
    world.remove(*whole.object);
    for (BodyDef& gib : breakApart(*whole.kind, def, state, kBurst * whole.impact / kReach)) {
      [[maybe_unused]] const auto added = world.add(std::move(gib));
      assert(added && "gibs are valid bodies");
    }
  }

  Breakable urn_;
  Breakable box_;
  std::vector<Whole> wholes_;
};

const SceneRegistration kRegisterBreakables({
    "breakables",
    "the report's section 3.2: 16 urns and 16 boxes fall, are thrown, and break into up to 1200 gibs",
    600,
    [] { return std::make_unique<Breakables>(); },
});

}  // namespace
}  // namespace scatter
