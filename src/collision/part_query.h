#pragma once

#include <cstdint>
#include <vector>

#include "collision/neighbour_search.h"
#include "collision/part_list.h"

namespace scatter {

/// How deep two parts overlap, metres: how far they must be moved apart at the most, along the best of a set
/// of axes. Continuous in the parts' places. Exact for boxes (all 15 axes; Gottschalk, Lin, Manocha 1996) and
/// for spheres with spheres and boxes; for other parts never less than the true depth. 0 if they do not
/// overlap.
[[nodiscard]] float partDepth(const PartList::Part& a, const PartList::Part& b, const Frame& frameB);

/// Direct questions about where two lists of parts are, without anything remembered from earlier steps.
/// Reuses its memory. `frameB` is B's frame in A's.
class PartQuery {
 public:
  /// Whether a plane proves of every two parts that more than `gap` metres lie between them; doubt is no.
  /// With a negative gap they may overlap by as much, as far as margins, or boxes, allow to prove that.
  [[nodiscard]] bool isSeparated(const PartList& a, const PartList& b, const Frame& frameB, float gap);

  /// The least distance of two parts, or `limit` if none is nearer. Overlaps are found as deep as the parts'
  /// margins reach, or all the way for two boxes; deeper ones count as that deep.
  [[nodiscard]] float distance(const PartList& a, const PartList& b, const Frame& frameB, float limit);

  /// Two parts that overlap, and how deep.
  struct Overlap {
    std::uint16_t a;
    std::uint16_t b;
    float depth;
  };

  /// All that overlap by partDepth(); valid until the next question.
  [[nodiscard]] const std::vector<Overlap>& overlaps(const PartList& a, const PartList& b,
                                                     const Frame& frameB);

 private:
  NeighbourSearch search_;
  std::vector<Overlap> overlaps_;
};

}  // namespace scatter
