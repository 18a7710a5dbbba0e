#pragma once

#include <scatter/math.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace scatter::lab {

/// A body in a frame of a block.
struct BlockBody {
  std::uint8_t level = 0;  ///< 0: it is not there.
  bool asleep = false;
  Transform pose{};
};

/// Frames of a world as a page reads them, each block by itself: web/report/src/motion.js is its reader.
/// First a byte for each body and frame, in the order of the frames: the level, with 128 for sleep, and
/// without what it was in the frame before. Then seven runs of numbers, one for each of x, y and z in
/// `quantum` and of the quaternion's x, y, z and w in 1/8192, each in the order of the bodies: what differs
/// from a body that moves on as it did, in zigzag, seven bits a byte.
class PoseBlock {
 public:
  explicit PoseBlock(std::size_t bodies) : bodies_(bodies) {}

  /// The next frame, all of its bodies as absent; filled in by the caller.
  [[nodiscard]] std::vector<BlockBody>& addFrame() { return frames_.emplace_back(bodies_); }

  [[nodiscard]] std::size_t frames() const { return frames_.size(); }
  [[nodiscard]] std::string encode(float quantum) const;

 private:
  std::size_t bodies_ = 0;
  std::vector<std::vector<BlockBody>> frames_;
};

}  // namespace scatter::lab
