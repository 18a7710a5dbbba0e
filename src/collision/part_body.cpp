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

}  // namespace scatter
