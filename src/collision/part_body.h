#pragma once

#include <cstddef>
#include <vector>

#include "collision/part_list.h"

namespace scatter {

/// A body in motion, as its pairs see it: where it is, how far it has come, where its parts are.
class PartBody {
 public:
  /// `parts` must outlive it or be replaced by setParts(). `engine`, which must outlive it too, is needed if
  /// parts ask for their bounds.
  explicit PartBody(const PartList& parts, const EngineBounds* engine = nullptr)
      : parts_(&parts), engine_(engine) {}

  [[nodiscard]] const PartList& parts() const { return *parts_; }
  void setParts(const PartList& parts);

  /// Does nothing if it is there already.
  void moveTo(const Frame& frame);
  [[nodiscard]] const Frame& frame() const { return frame_; }

  /// An upper bound for how far any of its points has moved in all, metres. Of two bodies' parts, the
  /// distance changes by no more than the sum of what is added to their travels.
  [[nodiscard]] double travel() const { return travel_; }

  /// Counts the moves without a length, to or from a place that is no number: travel() does not hold across
  /// them.
  [[nodiscard]] int jumps() const { return jumps_; }

  /// World bounds of the parts, laid out as by PartList::worldBounds, computed once per place.
  [[nodiscard]] const std::vector<float>& worldBounds();

  [[nodiscard]] std::size_t bytes() const { return sizeof(*this) + sizeof(float) * bounds_.capacity(); }

 private:
  const PartList* parts_;
  const EngineBounds* engine_;
  Frame frame_;
  double travel_ = 0.0;
  int jumps_ = 0;
  bool placed_ = false;
  bool bounded_ = false;
  std::vector<float> bounds_;
};

/// Tells whether the world bounds of parts of two bodies overlap, where the bodies are now. They are computed
/// when they are first asked for.
class BoundsTest {
 public:
  BoundsTest(PartBody& a, PartBody& b) : bodyA_(a), bodyB_(b) {}

  [[nodiscard]] bool overlap(int i, int j) {
    if (a_ == nullptr) compute();
    const float* const a = a_ + i;
    const float* const b = b_ + j;
    return a[0] <= b[3 * roomB_] && a[3 * roomA_] >= b[0] && a[roomA_] <= b[4 * roomB_] &&
           a[4 * roomA_] >= b[roomB_] && a[2 * roomA_] <= b[5 * roomB_] && a[5 * roomA_] >= b[2 * roomB_];
  }

 private:
  void compute() {
    a_ = bodyA_.worldBounds().data();
    b_ = bodyB_.worldBounds().data();
    roomA_ = bodyA_.parts().paddedCount();
    roomB_ = bodyB_.parts().paddedCount();
  }

  PartBody& bodyA_;
  PartBody& bodyB_;
  const float* a_ = nullptr;
  const float* b_ = nullptr;
  std::ptrdiff_t roomA_ = 0;
  std::ptrdiff_t roomB_ = 0;
};

}  // namespace scatter
