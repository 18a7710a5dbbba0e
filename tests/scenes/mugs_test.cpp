#include <gtest/gtest.h>
#include <scatter/io/model_library.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <string>
#include <vector>

#include "collision/box_separation.h"
#include "scenes/props.h"
#include "scenes/scene_world.h"
#include "scenes/worlds.h"
#include "trials.h"

namespace scatter::test {
namespace {

constexpr int kMugFrames = 900;
constexpr float kTray = 2.4F;
constexpr float kMugHeight = 8.0F;  // the highest things come from a little above the walls

Frame frameOf(const Transform& pose) {
  const Mat3 columns = glm::mat3_cast(pose.rotation);
  Frame frame;
  for (int i = 0; i < 3; ++i) frame.row[i] = {columns[0][i], columns[1][i], columns[2][i]};
  frame.origin = pose.position;
  return frame;
}

/// How far the level-1 boxes of two objects overlap at least; negative if they are apart.
float coarseOverlap(const WorldObject& a, const WorldObject& b) {
  const auto box = [](const WorldObject& object) -> const ConvexPart& {
    return std::get<std::shared_ptr<const LevelSet>>(object.def().shape)->coarsest().parts.front();
  };
  const Frame frameA = frameOf(a.state().pose * box(a).pose);
  const Frame frameB = frameOf(b.state().pose * box(b).pose);
  return -boxSeparation(Vec3(0.0F), std::get<Box>(box(a).shape).halfExtents, Vec3(0.0F),
                        std::get<Box>(box(b).shape).halfExtents, relativeFrame(frameA, frameB), 0.0F);
}

/// Pairs that lie in each other's hollows: their level-1 boxes overlap by more than a wall of a mug is thick.
int hookedPairs(const World& world) {
  std::vector<const WorldObject*> things;
  for (const auto& object : world.objects()) {
    if (object->def().motion == Motion::kDynamic) things.push_back(object.get());
  }
  int hooked = 0;
  for (std::size_t i = 0; i < things.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) hooked += coarseOverlap(*things[i], *things[k]) > 0.1F;
  }
  return hooked;
}

struct Pouring {
  int hooked = 0;
  float highest = 0.0F;
};

Pouring pour(const WorldCase& kind) {
  SceneWorld scene("mugs", kind.def);
  double peakEnergy = 0.0;
  for (int i = 0; i < kMugFrames; ++i) {
    scene.step();
    peakEnergy = std::max(peakEnergy, scene.world.physics().kineticEnergy());
    EXPECT_FALSE(scene.world.physics().findInvalidState()) << kind.name << " frame " << i;
    const auto outside = objectsOutside(scene.world, kTray, kMugHeight);
    EXPECT_EQ(outside, std::vector<std::string>{}) << kind.name << " frame " << i;
    if (testing::Test::HasFailure()) return {};
  }
  EXPECT_EQ(scene.counters().hybrids, 80U) << kind.name;
  EXPECT_LT(scene.world.physics().kineticEnergy(), 0.05 * peakEnergy) << kind.name;
  Pouring outcome{hookedPairs(scene.world), 0.0F};
  for (const auto& object : scene.world.objects()) {
    if (object->def().motion != Motion::kDynamic) continue;
    outcome.highest = std::max(outcome.highest, object->state().centerOfMass.y);
  }
  return outcome;
}

TEST(Mugs, HookIntoEachOtherAtTheFinestLevelAndNotAtLevelOne) {
  if (kSanitized) GTEST_SKIP() << "mugs are stepped in other tests";
  std::vector<Pouring> outcomes;
  for (const WorldCase& kind : everyWorld()) {
    outcomes.push_back(pour(kind));
    RecordProperty(std::string("hooked_") + kind.name, outcomes.back().hooked);
  }
  ASSERT_EQ(outcomes.size(), 3U);
  EXPECT_GT(outcomes[0].hooked, 150);
  EXPECT_GT(outcomes[1].hooked, 150);
  EXPECT_LE(outcomes[2].hooked, 2);
  // What does not fit into its neighbours piles up higher.
  EXPECT_GT(outcomes[2].highest, 1.2F * outcomes[1].highest);
}

/// A mug that hangs by its handle on the end of a lamp's arm, the lamp held fast.
class Hanging {
 public:
  explicit Hanging(const PhysicsDef& def) : world_(makeBulletPhysics(def)) {
    world_.physics().setGravity(Vec3(0.0F, -9.81F, 0.0F));
    const auto models = loadProps({"mug", "lamp"});
    EXPECT_TRUE(models) << models.error().message;
    BodyDef lamp = propBody((*models)[1], "lamp", {});
    lamp.motion = Motion::kStatic;
    EXPECT_TRUE(world_.add(std::move(lamp)));
    // The handle looks up, and its opening along the arm.
    const Vec3 along = glm::normalize(kTailEnd - kTailStart);
    const Vec3 up = glm::normalize(glm::cross(Vec3(0.0F, 0.0F, 1.0F), along)) * -1.0F;
    const Quat turn = glm::quat_cast(Mat3(up, glm::cross(along, up), along));
    const Vec3 middle = 0.5F * (kTailStart + kTailEnd);
    BodyDef mug = propBody((*models)[0], "mug", {middle - turn * kOpening, turn});
    auto added = world_.add(std::move(mug));
    EXPECT_TRUE(added);
    mug_ = *added;
  }

  void run(int frames) {
    for (int i = 0; i < frames; ++i) world_.step(1.0F / 60.0F);
  }

  /// How far the opening of the handle is from the middle of the arm's end.
  [[nodiscard]] float distance() const {
    return glm::length(mug_->state().pose(kOpening) - 0.5F * (kTailStart + kTailEnd));
  }

 private:
  static constexpr Vec3 kTailStart{0.0F, 1.32F, 0.0F};  // of the arm behind the lamp's pole
  static constexpr Vec3 kTailEnd{-0.45F, 1.56F, 0.0F};
  static constexpr Vec3 kOpening{0.385F, 0.37F, 0.0F};  // of the mug's handle

  World world_;
  WorldObject* mug_ = nullptr;
};

TEST(Mugs, HangByTheirHandleOnALampExceptAtLevelOne) {
  for (const WorldCase& kind : everyWorld()) {
    Hanging scene(kind.def);
    EXPECT_LT(scene.distance(), 1e-3F);
    scene.run(180);
    if (std::string(kind.name) == "coarsest") {
      EXPECT_GT(scene.distance(), 1.0F) << "the boxes push each other apart, and the mug falls";
    } else {
      EXPECT_LT(scene.distance(), 0.4F) << kind.name;
    }
  }
}

}  // namespace
}  // namespace scatter::test
