#include <gtest/gtest.h>

#include <array>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "recording/body_coder.h"
#include "recording/compression.h"
#include "recording/frame_coder.h"
#include "recording/frame_streams.h"
#include "recording/info_coder.h"
#include "recording/samples.h"

namespace scatter::recording {
namespace {

/// Streams of bytes, damaged behind their compression and the file's checksums, which would stop most of it.
class StreamMutator {
 public:
  explicit StreamMutator(unsigned seed) : random_(seed) {}

  std::string mutate(std::vector<std::string> streams) {
    for (std::size_t left = 1 + below(3); left > 0; --left) {
      std::string& stream = streams[below(streams.size())];
      if (stream.empty()) continue;
      const std::size_t at = below(stream.size());
      switch (below(4)) {
        case 0:
          stream.resize(at);
          break;
        case 1:
          stream.insert(at, stream.substr(below(stream.size()), 1 + below(30)));
          break;
        case 2:
          stream[at] = static_cast<char>(0xFF);
          break;
        default:
          stream[at] = static_cast<char>(random_());
      }
    }
    const std::vector<std::string_view> views(streams.begin(), streams.end());
    return packStreams(views);
  }

 private:
  std::size_t below(std::size_t limit) { return static_cast<std::size_t>(random_() % limit); }

  std::mt19937_64 random_;
};

TEST(FrameCoder, DamagedStreamsAreFramesOrNothing) {
  FrameEncoder encoder;
  for (const FrameSample& sample : test::sampleFrames(45)) encoder.add(sample);
  const std::string bytes = encoder.take();
  std::set<std::string, std::less<>> names;
  const NameKeeper keep = [&](std::string_view name) -> std::string_view {
    return *names.emplace(name).first;
  };
  ASSERT_TRUE(decodeFrames(bytes, 0, 45, keep));
  EXPECT_FALSE(decodeFrames(bytes, 0, 44, keep));
  EXPECT_FALSE(decodeFrames(bytes, 0, 46, keep));
  const auto streams = unpackStreams(bytes, kStreamCount, kMostBlockBytes);
  ASSERT_TRUE(streams);
  StreamMutator mutator(5);
  std::size_t refused = 0;
  for (int round = 0; round < 4000; ++round) {
    const auto frames = decodeFrames(mutator.mutate(*streams), 0, 45, keep);
    if (!frames) {
      ++refused;
      continue;
    }
    for (const RecordedFrame& frame : *frames) {
      ASSERT_EQ(frame.bodies.size(), frame.roster->size());
      for (const RecordedBody& body : frame.bodies) {
        EXPECT_NEAR(glm::length(body.pose.rotation), 1.0F, 1e-5F);
        EXPECT_FALSE(std::isnan(body.pose.position.x));
      }
    }
  }
  EXPECT_GT(refused, 400U);
}

TEST(BodyCoder, DamagedStreamsAreBodiesOrNothing) {
  BodyEncoder encoder;
  const auto samples = test::sampleFrames(1);
  for (const auto& [body, def] : samples.front().added) encoder.add(body, def);
  const std::string bytes = encoder.take();
  ASSERT_TRUE(BodyDecoder().read(bytes));
  const auto streams = unpackStreams(bytes, 1, kMostBlockBytes);
  StreamMutator mutator(6);
  std::size_t refused = 0;
  for (int round = 0; round < 4000; ++round) {
    refused += BodyDecoder().read(mutator.mutate(*streams)) ? 0U : 1U;
  }
  EXPECT_GT(refused, 400U);
}

TEST(InfoCoder, DamagedStreamsAreInfoOrNothing) {
  const auto streams = unpackStreams(encodeInfo(test::sampleInfo()), 1, kMostBlockBytes);
  StreamMutator mutator(7);
  std::size_t refused = 0;
  for (int round = 0; round < 2000; ++round) refused += decodeInfo(mutator.mutate(*streams)) ? 0U : 1U;
  EXPECT_GT(refused, 400U);
}

}  // namespace
}  // namespace scatter::recording
