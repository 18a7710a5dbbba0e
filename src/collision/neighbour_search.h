#pragma once

#include <cstdint>
#include <vector>

#include "collision/part_body.h"

namespace scatter {

/// Two parts whose boxes are near each other.
struct Neighbours {
  std::uint16_t a;
  std::uint16_t b;
  float separation;  ///< Of the boxes along `axis`: a lower bound for the parts' distance.
  Vec3 axis;         ///< From A to B, in A's frame, of length 1.
};

/// Finds the pairs of parts that are near each other. Reuses its memory from search to search.
class NeighbourSearch {
 public:
  /// All pairs of parts whose boxes are not separated by more than `limit` along one of the six face axes of
  /// the two bodies, nor along the normal of a triangle of A, in ascending order of (a, b). `frameB` is B's
  /// frame in A's.
  void byPartBoxes(const PartList& a, const PartList& b, const Frame& frameB, float limit);

  /// All pairs of parts whose world bounds overlap, in ascending order, without an axis and with the lowest
  /// separation.
  void byWorldBounds(PartBody& a, PartBody& b);

  [[nodiscard]] const std::vector<Neighbours>& found() const { return found_; }

 private:
  /// B's parts that are near A's box, as boxes in both frames; padded like part lists.
  struct Candidates {
    std::vector<std::uint16_t> part;
    std::vector<float> centerInA[3];
    std::vector<float> halfInA[3];
    std::vector<float> centerInB[3];
    std::vector<float> halfInB[3];
    void clear();
    void add(std::uint16_t part, const Vec3& centerA, const Vec3& halfA, const Vec3& centerB,
             const Vec3& halfB);
    void pad();
  };
  struct Box {
    Vec3 center;
    Vec3 half;
  };

  void collectNear(const PartList& list, const Box& other, float limit, std::vector<std::uint16_t>& near);
  void collectCandidates(const PartList& a, const PartList& b, const Frame& frameB, float limit);
  void cutByPlane(std::size_t first, const PartList::Part& triangle, const PartList& b, const Frame& frameB,
                  float limit);
  void pairUp(std::uint16_t part, const Box& inA, const Box& inB, const Frame& frameB, float limit);

  std::vector<std::uint16_t> nearA_;
  std::vector<std::uint16_t> nearB_;
  Candidates candidates_;
  std::vector<Neighbours> found_;
};

}  // namespace scatter
