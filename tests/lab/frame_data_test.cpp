#include <scatter/lab/frame_data.h>
#include <scatter/lab/frame_table.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace scatter {
namespace {

using testing::ElementsAre;

std::vector<double> windowOf(const FrameData& data, ChannelId id, std::size_t frames) {
  std::vector<double> values;
  for (const double value : data.window(id, frames)) {
    values.push_back(value);
  }
  return values;
}

TEST(FrameData, FindsChannelsByName) {
  FrameData data(4);
  const ChannelId time = data.addChannel({"time_s", "s", ChannelKind::kReal});
  EXPECT_EQ(data.find("time_s"), time);
  EXPECT_EQ(data.find("time"), std::nullopt);
  EXPECT_EQ(data.channel(time).unit, "s");
}

TEST(FrameData, ReadsBackWhileItIsWrittenAndForgetsTheOldest) {
  FrameData data(3);
  const ChannelId id = data.addChannel({"x", "", ChannelKind::kReal});
  for (int frame = 1; frame <= 10; ++frame) {
    data.beginFrame();
    EXPECT_EQ(data.value(id), 0.0);
    data.set(id, frame);
    ASSERT_EQ(data.available(), static_cast<std::size_t>(std::min(frame, 3)));
    for (std::size_t ago = 0; ago < data.available(); ++ago) {
      ASSERT_EQ(data.value(id, ago), frame - static_cast<int>(ago));
    }
  }
  EXPECT_EQ(data.framesBegun(), 10U);
}

TEST(FrameData, WindowRunsFromOldestToNewestAcrossTheWrap) {
  FrameData data(4);
  const ChannelId id = data.addChannel({"x", "", ChannelKind::kInteger});
  EXPECT_TRUE(windowOf(data, id, 3).empty());
  for (int frame = 1; frame <= 6; ++frame) {
    data.beginFrame();
    data.set(id, frame);
  }
  EXPECT_THAT(windowOf(data, id, 3), ElementsAre(4, 5, 6));
  EXPECT_THAT(windowOf(data, id, 100), ElementsAre(3, 4, 5, 6));
}

TEST(FrameData, HashesKeepAll64Bits) {
  FrameData data(2);
  const ChannelId id = data.addChannel({"h", "", ChannelKind::kHash});
  data.beginFrame();
  data.setHash(id, 0xFFFFFFFFFFFFFFFFULL);
  data.beginFrame();
  EXPECT_EQ(data.hash(id), 0U);
  EXPECT_EQ(data.hash(id, 1), 0xFFFFFFFFFFFFFFFFULL);
}

TEST(FrameData, AChannelAddedWhileRunningReadsZeroBefore) {
  FrameData data(4);
  data.beginFrame();
  const ChannelId late = data.addChannel({"late", "", ChannelKind::kReal});
  data.beginFrame();
  data.set(late, 5.0);
  EXPECT_EQ(data.value(late), 5.0);
  EXPECT_EQ(data.value(late, 1), 0.0);
}

TEST(FrameTable, KeepsEveryFrame) {
  FrameData data(1);
  const ChannelId x = data.addChannel({"x", "", ChannelKind::kReal});
  const ChannelId h = data.addChannel({"h", "", ChannelKind::kHash});
  FrameTable table(data.channels());
  for (int frame = 1; frame <= 3; ++frame) {
    data.beginFrame();
    data.set(x, frame * 0.5);
    data.setHash(h, static_cast<std::uint64_t>(frame));
    table.append(data);
  }
  EXPECT_EQ(table.frames(), 3U);
  EXPECT_THAT(table.values("x"), ElementsAre(0.5, 1.0, 1.5));
  EXPECT_THAT(table.hashes("h"), ElementsAre(1U, 2U, 3U));
  EXPECT_EQ(table.find("y"), nullptr);
  table.setValues("x", {1, 2, 3});
  EXPECT_THAT(table.values("x"), ElementsAre(1, 2, 3));
}

}  // namespace
}  // namespace scatter
