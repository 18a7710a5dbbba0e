#include "lab/memory_recorder.h"

#include <scatter/lab/touched_memory.h>

#include <cassert>
#include <limits>

namespace scatter::lab {

MemoryRecorder::MemoryRecorder(const World& world, FrameData& data, int every)
    : world_(world),
      data_(data),
      touched_(data.addChannel(
          {.name = kTouchedColumn, .unit = "MB", .kind = ChannelKind::kReal, .sampled = true})),
      every_(static_cast<std::uint64_t>(every)) {
  assert(every > 0);
}

void MemoryRecorder::beforeStep() {
  isSampled_ = (world_.frame() + 1) % every_ == 0 && TouchedMemory::begin();
}

void MemoryRecorder::afterStep() {
  double touched = std::numeric_limits<double>::quiet_NaN();
  if (isSampled_) {
    if (const auto bytes = TouchedMemory::bytes()) touched = static_cast<double>(*bytes) * 1e-6;
  }
  data_.set(touched_, touched);
}

}  // namespace scatter::lab
