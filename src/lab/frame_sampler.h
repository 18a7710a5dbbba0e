#pragma once

#include <scatter/lab/frame_data.h>
#include <scatter/recording/recorded_frame.h>
#include <scatter/recording/recording_info.h>
#include <scatter/world/world.h>

#include <cstdint>
#include <unordered_set>
#include <vector>

namespace scatter::lab {

/// Fills samples for a recording from a world, frame after frame.
class FrameSampler {
 public:
  explicit FrameSampler(bool contacts) : contacts_(contacts) {}

  /// The world as it is after its last step. Without `data` the sample has no values.
  void sample(const World& world, const FrameData* data, FrameSample& out);

  /// Dynamic bodies that did not sleep, over all samples.
  [[nodiscard]] std::uint64_t movingBodies() const { return movingBodies_; }

 private:
  [[nodiscard]] int levelOf(const LevelSwitching& switching, BodyId body) const;
  void findAdded(const World& world, FrameSample& out);
  void addContacts(const World& world, FrameSample& out);

  bool contacts_;
  std::uint64_t movingBodies_ = 0;
  std::vector<BodyId> roster_;
  std::unordered_set<BodyId> known_;
  std::vector<std::uint8_t> coarsest_;
  Observation observed_;
};

/// Adds the pairs of an observation that have a level.
void addPairLevels(const Observation& observed, std::vector<PairLevel>& pairs);

/// The channels of frame data, as a recording names them.
[[nodiscard]] std::vector<RecordedChannel> recordedChannels(const FrameData& data);

}  // namespace scatter::lab
