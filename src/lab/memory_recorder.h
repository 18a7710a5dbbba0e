#pragma once

#include <scatter/lab/frame_data.h>
#include <scatter/world/world.h>

#include <cstdint>

namespace scatter::lab {

inline constexpr const char* kTouchedColumn = "touched_memory_mb";

/// Measures what steps of a world touch of memory, in a channel of its own: touched_memory_mb in the frames
/// that are sampled. Changes nothing in the world.
class MemoryRecorder {
 public:
  /// Samples every so many frames, at least 1, where TouchedMemory can count. World and data must outlive it.
  MemoryRecorder(const World& world, FrameData& data, int every);

  void beforeStep();  ///< Just before it.
  void afterStep();   ///< Just after it.

 private:
  const World& world_;
  FrameData& data_;
  ChannelId touched_;
  std::uint64_t every_;
  bool isSampled_ = false;
};

}  // namespace scatter::lab
