#pragma once

#include <scatter/recording/recorded_frame.h>

#include <string>

#include "recording/bytes.h"

namespace scatter::lab {

/// What contact points are stored to, metres.
inline constexpr float kContactQuantum = 1.0F / 64.0F;

/// Where bodies touch in the frames of a block, for a page: of each pair of bodies the deepest point that is
/// closer than a centimetre, as the solver saw it. Of each frame their number, and of each point the level at
/// which the pair meets, 0 if nobody knows, and x, y and z as differences from the point before.
class ContactBlock {
 public:
  void addFrame(const RecordedFrame& frame);

  /// What was added; this is then empty.
  [[nodiscard]] std::string take();

 private:
  recording::ByteWriter bytes_;
};

}  // namespace scatter::lab
