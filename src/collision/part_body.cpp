#include "collision/part_body.h"

namespace scatter {

void PartBody::setParts(const PartList& parts) {
  parts_ = &parts;
  placed_ = false;
}

void PartBody::moveTo(const Frame& frame) {
  if (placed_ && frame == frame_) return;
  if (placed_) {
    const float moved = displacementBound(frame_, frame, parts_->center(), parts_->radius()).length;
    // Further, and the sum would lose the millimetres; this is also true of what is no number.
    constexpr float kFar = 1e6F;
    if (moved < kFar) {
      travel_ += static_cast<double>(moved);
    } else {
      ++jumps_;
    }
  }
  frame_ = frame;
  placed_ = true;
  bounded_ = false;
}

const std::vector<float>& PartBody::worldBounds() {
  if (bounded_) return bounds_;
  parts_->worldBounds(frame_, bounds_);
  if (engine_ != nullptr) parts_->askBounds(*engine_, frame_, bounds_);
  bounded_ = true;
  return bounds_;
}

}  // namespace scatter
