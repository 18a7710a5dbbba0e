#include "viewer/recorded_curves.h"

#include <gtest/gtest.h>

#include <bit>

#include "io/temporary_folder.h"
#include "recording/samples.h"

namespace scatter::viewer {
namespace {

TEST(RecordedCurves, AreTheNumbersOfAllFrames) {
  const test::TemporaryFolder folder;
  const auto frames = test::sampleFrames(50);
  test::writeRecording(folder / "run.rec", frames, 7);
  const auto recording = Recording::open(folder / "run.rec");
  ASSERT_TRUE(recording) << recording.error().message;
  RecordedCurves curves(**recording);
  EXPECT_EQ(curves.frames(), 50U);
  curves.readFor(0.0);
  EXPECT_EQ(curves.framesRead(), 1U);
  while (!curves.isWhole()) curves.readFor(1.0);
  EXPECT_TRUE(curves.hasContacts());
  const RecordingInfo& info = (*recording)->info();
  std::size_t numbers = 0;
  for (std::size_t i = 0; i < info.channels.size(); ++i) {
    const auto values = curves.values(info.channels[i].name);
    const bool isHash = info.channels[i].kind == RecordedKind::kHash;
    ASSERT_EQ(values.size(), isHash ? 0U : 50U) << info.channels[i].name;
    for (std::size_t frame = 0; frame < values.size(); ++frame)
      EXPECT_FLOAT_EQ(values[frame], static_cast<float>(std::bit_cast<double>(frames[frame].values[i])));
    numbers += isHash ? 0U : 1U;
  }
  EXPECT_GT(numbers, 0U);
  EXPECT_EQ(curves.channels().size(), numbers);
  EXPECT_TRUE(curves.values("nothing").empty());
}

TEST(RecordedCurves, OfSeveralFramesTheMostIsShown) {
  const std::vector<float> values{1.0F, 5.0F, 2.0F, 2.0F, 3.0F};
  EXPECT_EQ(mostOfEach(values, 1), values);
  EXPECT_EQ(mostOfEach(values, 2), (std::vector<float>{5.0F, 2.0F, 3.0F}));
  EXPECT_EQ(mostOfEach({}, 3), std::vector<float>());
}

}  // namespace
}  // namespace scatter::viewer
