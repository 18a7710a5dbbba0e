#include <scatter/lab/run.h>
#include <scatter/recording/difference.h>

#include "lab/play_scene.h"
#include "lab/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <memory>

namespace scatter {
namespace {

using testing::ElementsAre;

/// PlayScene, with a velocity of which one bit, the lowest, is another one from a frame on.
class NudgedScene final : public Scene {
 public:
  explicit NudgedScene(std::uint64_t frame) : frame_(frame) {}

  Result<void> build(World& world, const SceneOptions& options) override {
    auto built = scene_.build(world, options);
    world.find("plank")->setVelocity(Vec3(6.0F, 1.0F, 0.0F), Vec3(0.0F, 2.0F, 0.0F));
    return built;
  }

  void update(World& world) override {
    if (world.frame() != frame_) return;
    WorldObject* plank = world.find("plank");
    Vec3 velocity = plank->state().linearVelocity;
    velocity.x = std::bit_cast<float>(std::bit_cast<std::uint32_t>(velocity.x) ^ 1U);
    plank->setVelocity(velocity, plank->state().angularVelocity);
  }

 private:
  test::PlayScene scene_{/*gravity=*/false};
  std::uint64_t frame_;
};

RunOptions nudgedRun(std::uint64_t frame, const std::filesystem::path& file) {
  RunOptions options = test::playRun(WorldKind::kHybrid, false);
  options.makeScene = [frame] { return std::make_unique<NudgedScene>(frame); };
  options.frames = 80;
  options.record = RecordOptions{.file = file, .contacts = true};
  return options;
}

class RunRecorderTest : public testing::Test {
 protected:
  std::unique_ptr<Recording> record(std::uint64_t frame, const char* file) {
    const auto run = runScene(nudgedRun(frame, folder.path() / file));
    EXPECT_TRUE(run) << run.error().message;
    EXPECT_EQ(run->recording->failed, "");
    EXPECT_EQ(run->recording->frames, 81U);
    return Recording::open(folder.path() / file).value();
  }

  test::TemporaryFolder folder;
};

TEST_F(RunRecorderTest, StoresWhereBodiesWereAndWhatWasMeasured) {
  RunOptions options = nudgedRun(1000, folder.path() / "a.rec");
  std::vector<BodyState> last;
  options.inspect = [&](const World& world) {
    for (const auto& object : world.objects()) last.push_back(object->state());
  };
  const auto run = runScene(options);
  ASSERT_TRUE(run) << run.error().message;
  const auto recording = Recording::open(folder.path() / "a.rec").value();
  EXPECT_EQ(recording->first(), 0U);
  EXPECT_EQ(recording->last(), 80U);
  EXPECT_EQ(recording->damage(), "");
  EXPECT_EQ(recording->info().scene, "play");
  const auto frame = recording->frame(80).value();
  ASSERT_EQ(frame->bodies.size(), last.size());
  for (std::size_t i = 0; i < last.size(); ++i) {
    EXPECT_LT(glm::distance(frame->bodies[i].pose.position, last[i].pose.position), kRecordedMetres);
  }
  const std::size_t hash = recording->info().channel("state_hash").value();
  const auto& hashes = run->table.hashes("state_hash");
  for (std::uint64_t number = 80; number > 0; --number) {
    EXPECT_EQ((*recording->frame(number))->values[hash], hashes[number - 1]);
  }
  EXPECT_EQ(recording->nameOf(BodyId{1}), "crate-1");
  EXPECT_GT(run->recording->bytes, 1000U);
}

TEST_F(RunRecorderTest, ARunIsTheSameWithAndWithoutIt) {
  const auto with = runScene(nudgedRun(1000, folder.path() / "a.rec"));
  RunOptions options = nudgedRun(1000, {});
  options.record.reset();
  const auto without = runScene(options);
  EXPECT_EQ(with->table.hashes("state_hash"), without->table.hashes("state_hash"));
  EXPECT_FALSE(without->recording);
}

TEST_F(RunRecorderTest, TwoRunsThatDifferInOneBitPartInThatFrameBodyAndQuantity) {
  const auto one = record(1000, "one.rec");
  const auto same = record(1000, "same.rec");
  const auto nudged = record(50, "nudged.rec");
  EXPECT_FALSE(compareRecordings(*one, *same)->difference);
  const auto found = compareRecordings(*one, *nudged)->difference;
  ASSERT_TRUE(found);
  EXPECT_EQ(found->frame, 51U);
  ASSERT_EQ(found->bodies.size(), 1U);
  EXPECT_EQ(found->bodies[0].name, "plank");
  EXPECT_THAT(found->bodies[0].quantities, testing::Contains("linear velocity"));
  EXPECT_EQ(found->bodies[0].metres, 0.0F);
}

TEST_F(RunRecorderTest, AFileThatCannotBeMadeIsRefusedBeforeTheRun) {
  const auto run = runScene(nudgedRun(1000, folder.path() / "none" / "a.rec"));
  ASSERT_FALSE(run);
  EXPECT_THAT(run.error().message, testing::HasSubstr("a.rec"));
}

}  // namespace
}  // namespace scatter
