#include "collision/part_body.h"

#include <cmath>

namespace scatter {

void PartBody::setParts(const PartList& parts) {
  parts_ = &parts;
  placed_ = false;
}

void PartBody::moveTo(const Frame& frame) {
  if (placed_ && frame == frame_) return;
  if (placed_) {
    const float moved = displacementBound(frame_, frame, parts_->center(), parts_->radius());
    if (std::isfinite(moved)) {
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
  if (!bounded_) parts_->worldBounds(frame_, bounds_);
  bounded_ = true;
  return bounds_;
}

}  // namespace scatter
