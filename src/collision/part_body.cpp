#include "collision/part_body.h"

namespace scatter {

void PartBody::setParts(const PartList& parts) {
  parts_ = &parts;
  placed_ = false;
}

void PartBody::moveTo(const Frame& frame) {
  if (placed_ && frame == frame_) return;
  if (placed_) {
    travel_ += static_cast<double>(displacementBound(frame_, frame, parts_->center(), parts_->radius()));
  }
  frame_ = frame;
  placed_ = true;
  bounded_ = false;
}

const std::vector<float>& PartBody::worldBounds() {
  if (!bounded_) parts_->worldBounds(frame_, bounds_);
  bounded_ = true;
  return bounds_;
}

bool boundsOverlap(PartBody& a, int i, PartBody& b, int j) {
  const float* const boundsA = a.worldBounds().data() + i;
  const float* const boundsB = b.worldBounds().data() + j;
  const auto roomA = static_cast<std::ptrdiff_t>(a.parts().paddedCount());
  const auto roomB = static_cast<std::ptrdiff_t>(b.parts().paddedCount());
  for (std::ptrdiff_t axis = 0; axis < 3; ++axis) {
    if (!(boundsA[axis * roomA] <= boundsB[(axis + 3) * roomB] &&
          boundsA[(axis + 3) * roomA] >= boundsB[axis * roomB])) {
      return false;
    }
  }
  return true;
}

}  // namespace scatter
