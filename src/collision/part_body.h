#pragma once

#include <cstddef>
#include <vector>

#include "collision/part_list.h"

namespace scatter {

/// A body in motion, as its pairs see it: where it is, how far it has come, where its parts are.
class PartBody {
 public:
  /// `parts` must outlive it or be replaced by setParts().
  explicit PartBody(const PartList& parts) : parts_(&parts) {}

  [[nodiscard]] const PartList& parts() const { return *parts_; }
  void setParts(const PartList& parts);

  /// Does nothing if it is there already.
  void moveTo(const Frame& frame);
  [[nodiscard]] const Frame& frame() const { return frame_; }

  /// An upper bound for how far any of its points has moved in all, metres. Of two bodies' parts, the distance
  /// changes by no more than the sum of what is added to their travels.
  [[nodiscard]] double travel() const { return travel_; }

  /// World bounds of the parts as PartList::worldBounds gives them, computed once per place.
  [[nodiscard]] const std::vector<float>& worldBounds();

  [[nodiscard]] std::size_t bytes() const { return sizeof(*this) + sizeof(float) * bounds_.capacity(); }

 private:
  const PartList* parts_;
  Frame frame_;
  double travel_ = 0.0;
  bool placed_ = false;
  bool bounded_ = false;
  std::vector<float> bounds_;
};

/// Whether the world bounds of part `i` of `a` and part `j` of `b` overlap.
[[nodiscard]] bool boundsOverlap(PartBody& a, int i, PartBody& b, int j);

}  // namespace scatter
