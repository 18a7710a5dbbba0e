#include <scatter/recording/difference.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/temporary_folder.h"
#include "recording/samples.h"

namespace scatter {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class DifferenceTest : public testing::Test {
 protected:
  Result<RunComparison> compare(const std::vector<FrameSample>& a, const std::vector<FrameSample>& b) {
    // Blocks of other lengths change nothing.
    test::writeRecording(folder / "a.rec", a, 10);
    test::writeRecording(folder / "b.rec", b, 7);
    const auto first = Recording::open(folder / "a.rec").value();
    const auto second = Recording::open(folder / "b.rec").value();
    return compareRecordings(*first, *second);
  }

  test::TemporaryFolder folder;
  std::vector<FrameSample> samples = test::sampleFrames(60);
};

TEST_F(DifferenceTest, TheSameRunsHaveNone) {
  const auto compared = compare(samples, {samples.begin(), samples.begin() + 50});
  ASSERT_TRUE(compared) << compared.error().message;
  EXPECT_EQ(compared->first, 0U);
  EXPECT_EQ(compared->last, 49U);
  EXPECT_FALSE(compared->difference);
}

TEST_F(DifferenceTest, OneBitOfAVelocityNamesFrameBodyAndQuantity) {
  auto other = samples;
  for (std::size_t frame = 37; frame < other.size(); ++frame)
    other[frame].bodies[5].bits.linearVelocity[2] ^= 1U;
  const auto found = compare(samples, other)->difference;
  ASSERT_TRUE(found);
  EXPECT_EQ(found->frame, 37U);
  ASSERT_EQ(found->bodies.size(), 1U);
  EXPECT_EQ(found->bodies[0].name, "body-5");
  EXPECT_THAT(found->bodies[0].quantities, ElementsAre("linear velocity"));
  EXPECT_EQ(found->bodies[0].metres, 0.0F);
  EXPECT_THAT(found->unplaced, testing::IsEmpty());
}

TEST_F(DifferenceTest, EveryQuantityIsNamed) {
  auto other = samples;
  other[12].bodies[4].pose.position.x += 0.5F;
  other[12].bodies[4].bits.position[0] ^= 77U;
  other[12].bodies[4].level = 5;
  other[12].bodies[4].asleep = true;
  other[12].bodies[4].bits.orientation[8] ^= 1U << 31U;
  other[12].bodies[4].bits.angularVelocity[0] ^= 2U;
  const auto found = compare(samples, other)->difference;
  ASSERT_TRUE(found);
  EXPECT_EQ(found->frame, 12U);
  EXPECT_THAT(found->bodies[0].quantities,
              ElementsAre("position", "orientation", "angular velocity", "level", "sleep"));
  EXPECT_NEAR(found->bodies[0].metres, 0.5F, 2.0F * kRecordedMetres);
}

TEST_F(DifferenceTest, ABodyThatOnlyOneHasIsNamed) {
  auto other = samples;
  other[20].bodies.erase(other[20].bodies.begin() + 2);
  const auto found = compare(samples, other)->difference;
  ASSERT_TRUE(found);
  EXPECT_EQ(found->frame, 20U);
  ASSERT_EQ(found->bodies.size(), 1U);
  EXPECT_EQ(found->bodies[0].name, "body-2");
  EXPECT_THAT(found->bodies[0].quantities, ElementsAre("presence"));
}

TEST_F(DifferenceTest, AnotherEventIsNamed) {
  auto other = samples;
  other[9].events.push_back({.kind = LevelEventKind::kSwitched, .body = BodyId{7}, .policy = "speed"});
  const auto found = compare(samples, other)->difference;
  ASSERT_TRUE(found);
  EXPECT_EQ(found->frame, 9U);
  EXPECT_EQ(found->bodies[0].name, "body-6");
  EXPECT_THAT(found->bodies[0].quantities, ElementsAre("request"));
}

// Bits that were found to have the same check.
TEST_F(DifferenceTest, ADifferenceThatNoCheckShowsIsFoundAndSaysThatItsBodyIsUnknown) {
  auto other = samples;
  // In a word the last byte comes last: 0x107 over its two last bytes.
  other[9].bodies[1].bits.position[1] ^= 0x07010000U;
  const auto found = compare(samples, other)->difference;
  ASSERT_TRUE(found);
  EXPECT_EQ(found->frame, 9U);
  EXPECT_THAT(found->bodies, testing::IsEmpty());
  EXPECT_THAT(found->unplaced, ElementsAre("position"));
}

TEST_F(DifferenceTest, WithoutACommonFrameTheyAreNotCompared) {
  const auto compared =
      compare({samples.begin(), samples.begin() + 10}, {samples.begin() + 30, samples.end()});
  ASSERT_FALSE(compared);
  EXPECT_THAT(compared.error().message, HasSubstr("no frame in common"));
}

}  // namespace
}  // namespace scatter
